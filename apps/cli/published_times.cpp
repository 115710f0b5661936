// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/published_times.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace echoarc::cli {

std::optional<double> published_cpu_s(std::string_view method) {
  constexpr double arcs = 738.0;
  constexpr std::array<std::pair<std::string_view, double>, 8> seconds{{{"centerline", 0.004},
                                                                        {"vt", 0.077},
                                                                        {"dm", 0.085},
                                                                        {"mp", 0.083},
                                                                        {"bu", 0.587},
                                                                        {"atm_org", 1.126},
                                                                        {"atm_mod", 1.128},
                                                                        {"tbf", 0.010}}};
  const auto* const found = std::ranges::find(seconds, method, &std::pair<std::string_view, double>::first);
  if (found == seconds.end()) return std::nullopt;
  return found->second / arcs;
}

}  // namespace echoarc::cli
