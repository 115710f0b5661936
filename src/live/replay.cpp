// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/replay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace echoarc::live {

bool is_used(const Evidence& evidence, const JudgedPing& ping) {
  return !ping.rejected && !evidence.sensors_off.contains(ping.reading.rx) &&
         !evidence.sensors_off.contains(ping.reading.tx);
}

std::vector<Reading> used_readings(const Evidence& evidence, std::size_t begin, std::size_t end) {
  std::vector<Reading> readings;
  for (std::size_t k = begin; k < std::min(end, evidence.readings.size()); ++k)
    if (is_used(evidence, evidence.readings[k])) readings.push_back(evidence.readings[k].reading);
  return readings;
}

Result<std::size_t> place_of(const Evidence& evidence, std::string_view method) {
  const auto found = std::ranges::find(evidence.methods, method, &MethodChoice::key);
  if (found != evidence.methods.end()) return std::size_t(found - evidence.methods.begin());
  return Error{ErrorCode::not_found, "method " + std::string(method) + " is not running", std::string(method),
               "add it first"};
}

Result<AnyMethod> replay(const Evidence& evidence, const MethodChoice& choice, std::size_t end) {
  auto method = make_method(choice.name, choice.options);
  if (!method) return method.error();
  InlineExecutor executor;
  method->insert(used_readings(evidence, 0, end), executor);
  method->finish(executor);
  return method;
}

double number_option(const OptionMap& options, std::string_view name, double otherwise) {
  const auto found = options.find(name);
  if (found == options.end()) return otherwise;
  if (const auto* real = std::get_if<double>(&found->second)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&found->second)) return double(*whole);
  return otherwise;
}

BeamPolicy beam_policy_of(const OptionMap& options) {
  const auto found = options.find("beam_policy");
  const auto* text = found != options.end() ? std::get_if<std::string>(&found->second) : nullptr;
  if (text != nullptr && *text == "both") return BeamPolicy::both;
  if (text != nullptr && *text == "either") return BeamPolicy::either;
  return BeamPolicy::bisector;
}

std::string ping_text(PingId ping) {
  return "ping " + std::to_string(ping);
}

std::string degrees_text(Angle angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f°", angle.deg());
  return text;
}

bool reaches(const Reading& reading, Vec2 position, double margin_m) {
  const Vec2 eye = 0.5 * (reading.T_world_tx.position + reading.T_world_rx.position);
  const double foci_m = norm(reading.T_world_tx.position - reading.T_world_rx.position);
  const double range_m = echo_range_m(reading.outcome).value_or(reading.trusted_range_m);
  const double distance_m = norm(position - eye);
  if (distance_m > range_m + foci_m + margin_m) return false;
  if (!reading.monostatic() || distance_m <= 2.0 * margin_m) return true;
  const Angle off_axis = wrap(bearing(position - eye) - reading.T_world_rx.heading);
  return abs(off_axis) <= 0.5 * reading.beam_width + radians(std::asin(margin_m / distance_m));
}

Result<PastMap> map_at(const Evidence& evidence, std::span<const std::string> methods, double time_s) {
  PastMap past;
  while (past.pings < evidence.readings.size() && !(evidence.readings[past.pings].reading.time_s > time_s))
    ++past.pings;
  if (past.pings > 0) past.T_world_robot = evidence.readings[past.pings - 1].reading.T_world_robot;
  for (const std::string& name : methods) {
    const auto place = place_of(evidence, name);
    if (!place) return place.error();
    const auto method = replay(evidence, evidence.methods[*place], past.pings);
    if (!method) return method.error();
    auto map = method->export_map();
    if (!map) return map.error();
    past.maps.push_back(std::make_shared<const MapExport>(std::move(*map)));
  }
  return past;
}

}  // namespace echoarc::live
