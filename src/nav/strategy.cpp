// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/strategy.hpp"

#include <array>
#include <cstddef>

namespace echoarc::nav {

std::string_view name(Status status) {
  constexpr std::array<std::string_view, 3> names{"running", "finished", "failed"};
  return names[static_cast<std::size_t>(status)];
}

}  // namespace echoarc::nav
