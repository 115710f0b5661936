// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/drive_plan.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "sim/scene_fault.hpp"

namespace echoarc::sim {
namespace {

constexpr double shortest_leg_m = 1e-6;
constexpr double smallest_turn_rad = 1e-9;
// A stop this close to the end of a leg belongs to it: 60 steps of 0.025 m need not add up to 1.5 m to the last bit.
constexpr double stop_slack = 1e-9;

/// Adds one leg after another, halting on the way where the drive says so.
class Planner {
 public:
  Planner(const Drive& drive, double stop_rest_s)
      : drive_(drive),
        stop_rest_s_(stop_rest_s),
        travel_(drive.start.heading),
        plan_{Trajectory({drive.start.position, drive.start.heading + drive.facing}), {}, false} {
    plan_.with_stops = drive.stop_step_m > 0.0 || drive.stop_turn > Angle{};
    if (plan_.with_stops) stop();
  }

  [[nodiscard]] Result<void> add(const DriveLeg& leg) {
    if (leg.to.has_value() == leg.turn.has_value())
      return fault("a leg is either a straight line or a turn", leg.line, "give `to` or `turn_deg`");
    return leg.to ? add_line(*leg.to, leg.line) : add_turn(*leg.turn, leg.line);
  }

  [[nodiscard]] DrivePlan take() { return std::move(plan_); }

 private:
  [[nodiscard]] static Error fault(std::string message, std::uint64_t line, std::string remedy) {
    return scene_fault(std::move(message), line, std::move(remedy));
  }

  [[nodiscard]] Result<void> add_line(Vec2 to, std::uint64_t line) {
    const Vec2 way = to - plan_.trajectory.end().position;
    const double length_m = norm(way);
    if (!(std::abs(to.x) <= World::max_coordinate_m && std::abs(to.y) <= World::max_coordinate_m))
      return fault("a leg ends out of the world", line, "give its end in metres, within 100 km");
    if (length_m < shortest_leg_m) return fault("a leg has no length", line, "leave it out, or give another end");
    const Angle aside = wrap(bearing(way) - travel_);
    if (!drive_.keep_heading && std::abs(aside.rad()) > smallest_turn_rad)
      if (const Result<void> turned = add_turn(aside, line); !turned) return turned;
    const Vec2 from = plan_.trajectory.end().position;
    const auto drive_to = [&](double way_m) {
      const Vec2 there = way_m < length_m ? from + (way_m / length_m) * way : to;
      plan_.trajectory.add_line(there, drive_.speed_m_s, drive_.acceleration_m_s2, line);
    };
    return walk(length_m, drive_.stop_step_m, since_stop_m_, line, drive_to);
  }

  [[nodiscard]] Result<void> add_turn(Angle by, std::uint64_t line) {
    if (!(std::abs(by.rad()) > smallest_turn_rad && std::abs(by.deg()) <= 360'000.0))
      return fault("a turn has no angle, or more than a thousand rounds", line, "give its angle in degrees");
    const double sign = std::copysign(1.0, by.rad());
    Angle turned;
    const auto turn_to = [&](double way_rad) {
      const Angle there = radians(sign * way_rad);
      plan_.trajectory.add_turn(there - turned, drive_.turn_rate_per_s, drive_.turn_acceleration_per_s2, line);
      turned = there;
    };
    const Result<void> done = walk(std::abs(by.rad()), drive_.stop_turn.rad(), since_stop_rad_, line, turn_to);
    travel_ += by;
    return done;
  }

  /// Makes a way in pieces that end at stops; `since_stop` is what was made since the last one, over several legs.
  template <class GoTo>
  [[nodiscard]] Result<void> walk(double way, double step, double& since_stop, std::uint64_t line, const GoTo& go_to) {
    double made = 0.0;
    if (step > 0.0) {
      if ((way + since_stop) / step + static_cast<double>(plan_.stops_s.size()) > static_cast<double>(max_firings))
        return fault("the drive has more than 10 million stops", line, "stop less often");
      const double first = step - since_stop;
      for (std::size_t k = 0; first + static_cast<double>(k) * step <= way + stop_slack; ++k) {
        made = std::min(first + static_cast<double>(k) * step, way);
        go_to(made);
        stop();
        since_stop = 0.0;
      }
    }
    if (way - made > stop_slack) {
      go_to(way);
      since_stop += way - made;
    }
    return {};
  }

  void stop() {
    plan_.stops_s.push_back(plan_.trajectory.end_s());
    plan_.trajectory.add_rest(stop_rest_s_);
  }

  const Drive& drive_;
  double stop_rest_s_;
  Angle travel_;  // direction of travel
  double since_stop_m_ = 0.0;
  double since_stop_rad_ = 0.0;
  DrivePlan plan_;
};

std::string place_text(Vec2 place, double time_s) {
  return "at (" + short_number(place.x) + ", " + short_number(place.y) + ") m after " + short_number(time_s) + " s";
}

/// Steps as long as the free way around the robot allows: nothing can be missed between them.
Result<void> check_move(const World& world, const Trajectory::Move& move, double hull_radius_m) {
  constexpr double look_m = 2.0;
  constexpr double touch_m = 1e-6;
  constexpr double shortest_step_m = 1e-3;
  const double way_m = move.direction == Vec2{} ? 0.0 : move.profile.way();
  for (double made_m = 0.0;;) {
    const Vec2 place = move.T_world_robot.position + made_m * move.direction;
    const double free_m = world.clearance(place, hull_radius_m + look_m) - hull_radius_m;
    if (free_m < -touch_m) {
      const double time_s = move.begin_s + move.profile.time_at(made_m);
      const std::string hull = short_number(hull_radius_m);
      if (time_s == 0.0)
        return scene_fault("the robot starts in a surface, " + place_text(place, 0.0), move.line,
                           "start where " + hull + " m around it are free, or give the robot its true radius");
      return scene_fault("the robot runs into a surface, " + place_text(place, time_s), move.line,
                         "lead its path through free space, " + hull + " m to every side");
    }
    if (made_m >= way_m) return {};
    made_m = std::min(way_m, made_m + std::max(free_m, shortest_step_m));
  }
}

}  // namespace

Result<DrivePlan> plan_drive(const Drive& drive, double stop_rest_s) {
  const double farthest_m = World::max_coordinate_m;
  if (!is_finite(drive.start) || std::abs(drive.start.position.x) > farthest_m ||
      std::abs(drive.start.position.y) > farthest_m)
    return scene_fault("the drive starts out of the world", 0, "give its start in metres, within 100 km");
  Planner planner(drive, stop_rest_s);
  for (const DriveLeg& leg : drive.legs)
    if (const Result<void> added = planner.add(leg); !added) return added.error();
  return planner.take();
}

Result<void> check_clearance(const World& world, const Trajectory& trajectory, double hull_radius_m) {
  const Trajectory::Move start{0.0, 0.0, trajectory.at(0.0), {}, 0.0, SpeedProfile(0.0, 1.0, 1.0), 0};
  if (const Result<void> free = check_move(world, start, hull_radius_m); !free) return free;
  for (const Trajectory::Move& move : trajectory.moves())
    if (move.direction != Vec2{})
      if (const Result<void> free = check_move(world, move, hull_radius_m); !free) return free;
  return {};
}

}  // namespace echoarc::sim
