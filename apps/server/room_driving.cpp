// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The part of Room that is about who moves the robot, and how.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "host/clocks.hpp"
#include "server/room.hpp"
#include "server/room_messages.hpp"
#include "server/strategy_modes.hpp"

namespace echoarc::server {

std::vector<std::string> Room::modes() const {
  if (!drivable_) return {};
  std::vector<std::string> modes;
  if (navigates_) modes.assign(strategy_modes().begin(), strategy_modes().end());
  if (!navigates_) modes.emplace_back("goto");
  if (source_.tour.size() > 1) modes.emplace_back("tour");
  modes.insert(modes.end(), {"stand", "drive"});
  return modes;
}

void Room::on(Viewer& viewer, const Stop& /*message*/) {
  if (!control_) return;
  stopped_by_ = StopNote{"viewer", viewer.id, viewer.name};
  control_->control([](live::RobotControl& control) { control.stop(); });
  stopped_us_ = std::llround(host::wall_time_s() * 1e6);
}

void Room::on(Viewer& viewer, const Take& /*message*/) {
  if (!may(viewer)) return;
  if (!drivable_)
    return refuse(viewer, std::nullopt,
                  {ErrorCode::unsupported, "a log cannot be driven", "", "open a scene, or the robot itself"});
  const std::optional<ViewerId> before = rights_.driver();
  switch (rights_.take(viewer.id, host::wall_time_s())) {
    case DrivingRights::Taken::yes: driver_changed(before, "handed_over"); break;
    case DrivingRights::Taken::asked:
      if (Viewer* driver = find(*rights_.driver())) driver->send(drive_request_message(viewer));
      tell_viewers();
      break;
    case DrivingRights::Taken::busy:
      refuse(viewer, std::nullopt,
             {ErrorCode::unsupported, "somebody else is asking to drive", "", "ask again when that is answered"});
  }
}

void Room::driver_changed(std::optional<ViewerId> before, std::string_view reason) {
  if (before == rights_.driver()) return;
  if (before)
    if (Viewer* viewer = find(*before)) viewer->send(drive_lost_message(reason));
  tell_viewers();
}

void Room::on(Viewer& viewer, const Release& message) {
  const std::optional<ViewerId> before = rights_.driver();
  if (message.to) {
    const Viewer* next = find(*message.to);
    if (next == nullptr || !next->may_drive)
      return refuse(viewer, std::nullopt,
                    {ErrorCode::not_found, "that viewer is gone, or has no token", "", "choose another"});
  }
  if (!rights_.release(viewer.id, message.to)) return;
  if (control_) control_->control([](live::RobotControl& control) { control.stand(); });
  driver_changed(before, "handed_over");
}

void Room::on(Viewer& viewer, const Answer& message) {
  const std::optional<ViewerId> before = rights_.driver();
  const std::optional<ViewerId> asked = rights_.answer(viewer.id, message.accept);
  if (!asked) return;
  if (!message.accept) {
    if (Viewer* asking = find(*asked)) asking->send(drive_lost_message("kept"));
    return tell_viewers();
  }
  if (control_) control_->control([](live::RobotControl& control) { control.stand(); });
  driver_changed(before, "handed_over");
}

void Room::on(Viewer& viewer, const DriveMessage& message) {
  if (!may(viewer)) return;
  if (rights_.driver() != viewer.id)
    return refuse(viewer, std::nullopt, {ErrorCode::unsupported, "you do not drive", "", "say take first"});
  driven_by_ = viewer.id;
  if (control_) control_->drive({message.v_m_s, radians(message.w_rad_s)}, message.seq);
}

void Room::on(Viewer& viewer, const ModeMessage& message) {
  if (!may(viewer)) return;
  if (rights_.driver() && rights_.driver() != viewer.id)
    return refuse(viewer, std::nullopt,
                  {ErrorCode::unsupported, "somebody else drives", "", "ask to drive, then choose the mode"});
  const std::vector<std::string> known = modes();
  const bool has_goal = message.x_m && message.y_m;
  if (!control_ || std::ranges::find(known, message.mode) == known.end() || message.mode == "drive" ||
      (message.mode == "goto" && !has_goal))
    return refuse(viewer, std::nullopt,
                  {ErrorCode::bad_value, fmt::format("\"{:.32}\" is no mode that can be started so", message.mode), "",
                   "welcome.modes lists them; goto needs x and y, drive is started by driving"});
  if (message.mode == "tour") control_->control([](live::RobotControl& control) { control.tour(); });
  if (message.mode == "stand") control_->control([](live::RobotControl& control) { control.stand(); });
  const std::optional<Vec2> goal = has_goal ? std::optional(Vec2{*message.x_m, *message.y_m}) : std::nullopt;
  if (navigates_ && std::ranges::find(strategy_modes(), message.mode) != strategy_modes().end())
    control_->navigate(message.mode, goal);
  else if (message.mode == "goto")
    control_->control([goal](live::RobotControl& control) { control.go_to(*goal); });
}

}  // namespace echoarc::server
