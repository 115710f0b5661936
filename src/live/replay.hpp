// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/live/inquiry.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::live {

/// Whether maps are made from this ping.
[[nodiscard]] bool is_used(const Evidence& evidence, const JudgedPing& ping);
/// Readings [begin, end) of the log that maps are made from.
[[nodiscard]] std::vector<Reading> used_readings(const Evidence& evidence, std::size_t begin, std::size_t end);
/// The choice of a running method. Error: it is not running.
[[nodiscard]] Result<std::size_t> place_of(const Evidence& evidence, std::string_view method);
/// The method after the first `end` pings of the log, finished.
[[nodiscard]] Result<AnyMethod> replay(const Evidence& evidence, const MethodChoice& choice, std::size_t end);

/// A number among a method's options; `otherwise` where it has none of that name.
[[nodiscard]] double number_option(const OptionMap& options, std::string_view name, double otherwise);
[[nodiscard]] BeamPolicy beam_policy_of(const OptionMap& options);
/// "ping 12", "3.2°", "12 pings": numbers as sentences have them.
[[nodiscard]] std::string ping_text(PingId ping);
[[nodiscard]] std::string degrees_text(Angle angle);

/// Whether the reading says something of places `margin_m` around `position`, seen generously.
[[nodiscard]] bool reaches(const Reading& reading, Vec2 position, double margin_m);

}  // namespace echoarc::live
