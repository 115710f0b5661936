// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/sensing/no_echo.hpp"
#include "echoarc/sensing/sensing_options.hpp"

namespace echoarc {

enum class Severity : std::uint8_t {
  note,     ///< worth knowing
  warning,  ///< the map suffers
  error,    ///< no map comes of it
};
[[nodiscard]] constexpr std::string_view name(Severity severity) {
  constexpr std::string_view names[] = {"note", "warning", "error"};
  return names[static_cast<std::size_t>(severity)];
}

/// Something a person should know about a log or a robot.
struct Finding {
  Severity severity = Severity::note;
  std::string_view name;  ///< fixed: "floor_in_beam", "zero_stamps", ...
  std::string message;    ///< what was found, with numbers
  std::string remedy;     ///< what to do about it
};

/// The no-echo decisions for people, sensors that agree taken together: "sensors 0-7: 5.11 m is no echo: ...".
[[nodiscard]] std::vector<std::string> no_echo_sentences(std::span<const NoEchoDecision> decisions);

/// What is odd about a description alone: beams, mounts, ranges, and from where on a beam meets the floor.
[[nodiscard]] std::vector<Finding> diagnose(const RobotDescription& robot);

/// The description and the log: clocks, odometry, units, sensors that are silent, stuck or copies of each other, and
/// every reason for which records were left out. The gravest first, otherwise in a fixed order.
[[nodiscard]] std::vector<Finding> diagnose(const Log& log, const SensingOptions& options = {});

}  // namespace echoarc
