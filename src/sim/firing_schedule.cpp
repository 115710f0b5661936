// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/firing_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "sim/scene_fault.hpp"

namespace echoarc::sim {

Result<FiringSchedule> FiringSchedule::make(const DrivePlan& plan, std::size_t sensors, double interval_s,
                                            double dwell_s) {
  FiringSchedule schedule(plan);
  schedule.sensors_ = sensors;
  schedule.interval_s_ = interval_s;
  const double drive_s = plan.trajectory.end_s();
  schedule.in_stops_ = plan.stops_s.size() * sensors;
  schedule.after_begin_s_ = plan.with_stops ? drive_s : 0.0;
  // A drive that is over at once still has a round.
  const double after_s = (plan.with_stops ? 0.0 : drive_s) + dwell_s;
  const double in_time = std::floor(after_s / interval_s + 1e-9) + (plan.with_stops ? 0.0 : 1.0);
  const double after = plan.with_stops ? in_time : std::max(in_time, static_cast<double>(sensors));
  if (static_cast<double>(schedule.in_stops_) + after > static_cast<double>(max_firings))
    return scene_fault("the drive lasts so long that its sensors would fire more than 10 million times", 0,
                       "drive a shorter way, stop less often, or fire at a longer interval_s");
  schedule.after_ = static_cast<std::uint64_t>(after);
  schedule.end_s_ = drive_s + dwell_s;
  if (schedule.after_ > 0) schedule.end_s_ = std::max(schedule.end_s_, schedule.firing(schedule.count() - 1).time_s);
  return schedule;
}

Firing FiringSchedule::firing(std::uint64_t number) const {
  Firing firing{.number = number, .sensor = static_cast<std::size_t>(number % sensors_), .T_world_robot = {}};
  if (number < in_stops_)
    firing.time_s =
        plan_->stops_s[static_cast<std::size_t>(number / sensors_)] + static_cast<double>(firing.sensor) * interval_s_;
  else
    firing.time_s = after_begin_s_ + static_cast<double>(number - in_stops_) * interval_s_;
  firing.T_world_robot = plan_->trajectory.at(firing.time_s);
  firing.travelled_m = plan_->trajectory.travelled_m(firing.time_s);
  return firing;
}

}  // namespace echoarc::sim
