// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/scene_fault.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "echoarc/core/options.hpp"

namespace echoarc::sim {

Error scene_fault(std::string message, std::uint64_t line, std::string remedy) {
  return {ErrorCode::bad_value, std::move(message), line > 0 ? "line " + std::to_string(line) : std::string(),
          std::move(remedy)};
}

Error in_file(Error error, const std::string& file) {
  constexpr std::string_view line = "line ";
  if (file.empty()) return error;
  if (error.where.starts_with(line))
    error.where = file + ":" + error.where.substr(line.size());
  else
    error.where = error.where.empty() ? file : file + ", " + error.where;
  return error;
}

std::string short_number(double value) {
  return to_text(OptionValue{std::round(value * 1000.0) / 1000.0 + 0.0});
}

}  // namespace echoarc::sim
