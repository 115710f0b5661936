// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/room_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/maps/point_map.hpp"
#include "echoarc/sensing/rejection.hpp"
#include "host/clocks.hpp"
#include "server/json_values.hpp"

namespace echoarc::server {
namespace {

Json source_of(const Room& room) {
  const live::SourceDescription& source = room.source();
  Json walls = Json::array();
  for (const Polyline& wall : source.walls) {
    Json points = Json::array();
    for (const Vec2 point : wall) points.push_back(json_of(point));
    walls.push_back(std::move(points));
  }
  return {{"room", room.name()},
          {"kind", room.kind()},
          {"name", source.name},
          {"title", source.title},
          {"drivable", room.drivable()},
          {"has_truth", source.has_truth},
          {"has_laser", !source.robot.lasers.empty()},
          {"duration_s", source.end_s ? Json(*source.end_s - source.begin_s) : Json()},
          {"walls", std::move(walls)}};
}

Json robot_of(const Room& room) {
  const RobotDescription& robot = room.source().robot;
  Json sensors = Json::array();
  for (const Sensor& sensor : robot.sensors.sensors())
    sensors.push_back({{"id", sensor.id},
                       {"T_robot_sensor", json_of(sensor.mount.T_robot_sensor())},
                       {"beam_width", sensor.model.beam_width.rad()},
                       {"range_min_m", sensor.model.range_min_m},
                       {"range_max_m", json_of(sensor.model.range_max_m)},
                       {"rate_hz", json_of(room.planned_rate_hz())}});
  return {{"name", robot.name}, {"radius_m", robot.radius_m}, {"sensors", std::move(sensors)}};
}

Json labels() {
  Json names = Json::array();
  for (std::size_t i = 0; i < point_label_count; ++i) names.push_back(name(static_cast<PointLabel>(i)));
  return names;
}

}  // namespace

std::string welcome_message(const ServerFacts& facts, const Room& room, const Viewer& viewer) {
  Json methods = Json::array();
  for (const MethodEntry& method : catalog()) methods.push_back(json_of(method));
  Json scenes = Json::array();
  for (const auto& [name, title] : facts.scenes) scenes.push_back({{"name", name}, {"title", title}});
  Json reasons = Json::array();
  for (const RejectionInfo& reason : rejections())
    reasons.push_back({{"name", reason.name}, {"explanation", reason.explanation}, {"remedy", reason.remedy}});
  const live::ControlOptions control;
  const RobotLimits limits;
  return text_of({{"type", "welcome"},
                  {"protocol", 1},
                  {"version", facts.version},
                  {"session", facts.session},
                  {"you", {{"viewer", viewer.id}, {"name", viewer.name}, {"may_drive", viewer.may_drive}}},
                  {"source", source_of(room)},
                  {"robot", robot_of(room)},
                  {"catalogue", std::move(methods)},
                  {"modes", room.modes()},
                  {"scenes", std::move(scenes)},
                  {"rejections", std::move(reasons)},
                  {"labels", labels()},
                  {"limits",
                   {{"upload_bytes", facts.upload_bytes},
                    {"speed_m_s", limits.speed_m_s},
                    {"turn_rate", limits.turn_rate_per_s.rad()},
                    {"dead_man_s", control.dead_man_s},
                    {"stop_deceleration_m_s2", control.stop_deceleration_m_s2}}}});
}

std::string state_message(const RobotStatus& status, const DrivingRights& rights, std::size_t watchers,
                          const std::optional<StopNote>& stopped_by, std::uint64_t pings) {
  const live::ControlState& control = status.control;
  Json stopped;
  if (stopped_by)
    stopped = {{"who", stopped_by->who},
               {"viewer", stopped_by->viewer ? Json(*stopped_by->viewer) : Json()},
               {"name", stopped_by->name}};
  const std::string reason = !status.broken.empty() ? status.broken
                             : status.ended         ? "end of log"
                                                    : std::string(name(control.reason));
  const std::string_view limited = control.reason == live::Reason::stopped ? "stop"
                                   : control.limited_by_obstacle           ? "obstacle"
                                                                           : "none";
  return text_of({{"type", "state"},
                  {"tick", status.tick},
                  {"t", json_of(status.time_s)},
                  {"mono_us", status.mono_us},
                  {"pose", json_of(status.T_world_robot.value_or(Pose2{}))},
                  {"true_pose", json_of(status.T_world_true)},
                  {"v", status.velocity.forward_m_s},
                  {"w", status.velocity.turn_per_s.rad()},
                  {"mode", mode_name(control)},
                  {"reason", reason},
                  {"strategy", control.strategy},
                  {"detail", control.detail},
                  {"goal", json_of(control.goal)},
                  {"driver", rights.driver() ? Json(*rights.driver()) : Json()},
                  {"watchers", watchers},
                  {"limit_m_s", control.limit_m_s},
                  {"limited_by", limited},
                  {"free_ahead_m", json_of(control.free_ahead_m)},
                  {"stopped_by", std::move(stopped)},
                  {"playing", status.playing},
                  {"speed", status.speed},
                  {"pings", pings},
                  {"drive_seq", status.drive_seq ? Json(*status.drive_seq) : Json()},
                  {"drive_mono_us", status.drive_seq ? Json(status.drive_us) : Json()},
                  {"distance_m", status.travelled_m}});
}

std::string viewers_message(const std::set<Viewer*>& viewers, const DrivingRights& rights) {
  std::vector<const Viewer*> ordered(viewers.begin(), viewers.end());
  std::ranges::sort(ordered, {}, [](const Viewer* viewer) { return viewer->id; });
  Json list = Json::array();
  for (const Viewer* viewer : ordered)
    list.push_back({{"viewer", viewer->id},
                    {"name", viewer->name},
                    {"driver", rights.driver() == viewer->id},
                    {"asking", rights.asking() == viewer->id}});
  return text_of({{"type", "viewers"}, {"viewers", std::move(list)}});
}

std::string error_message(std::optional<MessageId> id, const Error& error) {
  constexpr std::array<std::string_view, 8> codes{"not_found", "unreadable",  "unwritable", "bad_format",
                                                  "bad_value", "unsupported", "too_large",  "interrupted"};
  return text_of({{"type", "error"},
                  {"id", id ? Json(*id) : Json()},
                  {"code", codes.at(static_cast<std::size_t>(error.code))},
                  {"message", error.message},
                  {"remedy", error.remedy}});
}

std::string drive_request_message(const Viewer& asking) {
  return text_of({{"type", "drive_request"},
                  {"viewer", asking.id},
                  {"name", asking.name},
                  {"timeout_s", DrivingRights::request_timeout_s}});
}

std::string drive_lost_message(std::string_view reason) {
  return text_of({{"type", "drive_lost"}, {"reason", reason}});
}
std::string bye_message(std::string_view reason) {
  return text_of({{"type", "bye"}, {"reason", reason}});
}
std::string pong_message(MessageId id) {
  return text_of({{"type", "pong"}, {"id", id}, {"mono_us", std::llround(host::wall_time_s() * 1e6)}});
}
std::string opened_message(MessageId id, std::string_view room) {
  return text_of({{"type", "opened"}, {"id", id}, {"room", room}});
}
std::string pings_end_message(MessageId id) {
  return text_of({{"type", "pings_end"}, {"id", id}});
}
std::string snapshot_end_message(MessageId id, double time_s, std::size_t pings, const std::optional<Pose2>& pose) {
  return text_of({{"type", "snapshot_end"}, {"id", id}, {"t", time_s}, {"pings", pings}, {"pose", json_of(pose)}});
}

}  // namespace echoarc::server
