// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/mapping/catalog.hpp"

/// Values of messages as JSON. What is not finite is null: JSON has no word for it.
namespace echoarc::server {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline Json json_of(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}
[[nodiscard]] inline Json json_of(const std::optional<double>& value) {
  return value ? json_of(*value) : Json();
}
[[nodiscard]] inline Json json_of(const std::optional<Angle>& angle) {
  return angle ? json_of(angle->rad()) : Json();
}
[[nodiscard]] inline Json json_of(Vec2 position) {
  return Json::array({position.x, position.y});
}
[[nodiscard]] inline Json json_of(const std::optional<Vec2>& position) {
  return position ? json_of(*position) : Json();
}
[[nodiscard]] inline Json json_of(const Pose2& pose) {
  return Json::array({pose.position.x, pose.position.y, pose.heading.rad()});
}
[[nodiscard]] inline Json json_of(const std::optional<Pose2>& pose) {
  return pose ? json_of(*pose) : Json();
}
/// `PingDetail`.
[[nodiscard]] Json json_of(const live::JudgedPing& ping);
/// `OptionValues`.
[[nodiscard]] Json json_of(const OptionMap& options);
/// `Option`.
[[nodiscard]] Json json_of(const OptionSpec& option);
/// `Method`, with the name that people read and what they should look for.
[[nodiscard]] Json json_of(const MethodEntry& method);
/// How people are told of a running method: its short name, and what its id says beyond the method's.
[[nodiscard]] std::string label_of(const live::MethodChoice& choice);

/// The text of a message. What is no UTF-8 (a name from a log, say) is replaced.
[[nodiscard]] inline std::string text_of(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace echoarc::server
