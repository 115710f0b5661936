// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/loop_watch.hpp"
#include "echoarc/nav/recovery.hpp"
#include "echoarc/nav/side_wall.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

struct WallFollowerOptions {
  bool left = true;
  double distance_m = 0.60;
  double turn_away_m = 0.75;
  double stop_m = 0.35;
  double wall_within_m = 1.2;
  double cruise_m_s = 0.25;
  double slow_m_s = 0.05;
  Angle turn_per_s = radians(0.6);
  double distance_gain_per_m2 = 1.5;
  double direction_gain_per_s = 0.8;
  double corner_m = 0.3;
  double gap_m = 1.1;
  double lost_m = 2.0;
  double close_m = 0.3;
  double least_loop_m = 3.0;
  double longest_m = 2000.0;
  double patience_s = 5.0;

  static constexpr auto fields() {
    using O = WallFollowerOptions;
    return std::tuple{
        field("left", &O::left, {.doc = "keep the wall on the left; no: on the right"}),
        field("distance_m", &O::distance_m,
              {.unit = "m", .min = 0.1, .max = 5.0, .doc = "kept between robot's centre and wall"}),
        field("turn_away_m", &O::turn_away_m,
              {.unit = "m", .min = 0.1, .max = 5.0, .doc = "something ahead is so near: turn away"}),
        field("stop_m", &O::stop_m,
              {.unit = "m", .min = 0.0, .max = 5.0, .doc = "something ahead is so near: turn on the spot"}),
        field("wall_within_m", &O::wall_within_m,
              {.unit = "m", .min = 0.1, .max = 10.0, .doc = "what is further away is not the wall that is followed"}),
        field("cruise_m_s", &O::cruise_m_s, {.unit = "m/s", .min = 0.01, .max = 10.0, .doc = "speed along a wall"}),
        field("slow_m_s", &O::slow_m_s, {.unit = "m/s", .min = 0.0, .max = 10.0, .doc = "speed of turning away"}),
        field("turn_rate_deg", &O::turn_per_s,
              {.unit = "deg/s", .min = 1.0, .max = 360.0, .doc = "rate of turning away"}),
        field("distance_gain_per_m2", &O::distance_gain_per_m2,
              {.unit = "1/m^2", .min = 0.0, .max = 100.0, .doc = "turn per way driven and error of distance"}),
        field("direction_gain_per_s", &O::direction_gain_per_s,
              {.unit = "1/s", .min = 0.0, .max = 100.0, .doc = "turning rate over the angle to the wall"}),
        field("corner_m", &O::corner_m,
              {.unit = "m",
               .min = 0.0,
               .max = 5.0,
               .doc = "way past the wall's end before the robot may turn around it"}),
        field("gap_m", &O::gap_m,
              {.unit = "m",
               .min = 0.0,
               .max = 5.0,
               .doc = "way past the wall's end, if nothing is ahead: doors are narrower"}),
        field("lost_m", &O::lost_m, {.unit = "m", .min = 0.1, .max = 100.0, .doc = "way without wall: it is lost"}),
        field("close_m", &O::close_m,
              {.unit = "m", .min = 0.01, .max = 10.0, .doc = "so near to its start the robot is round"}),
        field("least_loop_m", &O::least_loop_m,
              {.unit = "m", .min = 0.0, .max = 1e4, .doc = "way before it may be round"}),
        field("longest_m", &O::longest_m, {.unit = "m", .min = 1.0, .max = 1e6, .doc = "way after which it gives up"}),
        field("patience_s", &O::patience_s,
              {.unit = "s", .min = 0.0, .max = 600.0, .doc = "time to wait for the first echo"})};
  }
};

/// Follows a wall by rules, on either side, around concave and convex corners, until it is round: sectors of bearing
/// give the nearest obstacle ahead (F, within 30 degrees), at the side (S, 60 to 120) and between (SF).
///   1. F is very near: turn away on the spot. 2. F is near: turn away slowly.
///   3. Neither S nor SF for longer than a doorway is wide: turn towards the wall around its corner; sooner, if
///      something ahead leaves no other way. Sonar hears a wall beyond a doorway only when it is abreast.
///   4. Otherwise: omega = s k_p v (S - d) + k_theta theta, theta the angle to the line through the last side points.
///   5. No wall for long: it is lost; drive to the nearest one known.
/// [Barshan07] 4.2 names a simple rule-based scheme; the rules are this library's. In a passage that is narrower than
/// twice the distance to be kept the robot takes its middle. Distances are from the robot's centre.
class WallFollower final : public Strategy {
 public:
  explicit WallFollower(const RobotBody& body, const WallFollowerOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "wall"; }
  [[nodiscard]] Steering update(const Surroundings& surroundings) override;
  [[nodiscard]] Sketch sketch() const override;

 private:
  [[nodiscard]] Steering steer(const Surroundings& surroundings);
  [[nodiscard]] std::optional<Angle> wall_direction(const Pose2& T_world_base, const SectorMinima& minima) const;
  [[nodiscard]] Steering along_wall(const Pose2& T_world_base, const SectorMinima& minima);
  [[nodiscard]] Steering around_edge(const Pose2& T_world_base, Vec2 edge, double front_m);
  [[nodiscard]] bool at_corner(double front_m) const;
  [[nodiscard]] Steering turn_away(double forward_m_s, std::string reason);
  [[nodiscard]] Steering approach(const Surroundings& surroundings, const std::optional<Vec2>& nearest);
  [[nodiscard]] std::optional<Vec2> mapped_wall(const Surroundings& surroundings);
  void look_for_wall(const Pose2& T_world_base, const SectorMinima& minima);
  void forget_wall();
  void keep_account(const Pose2& T_world_base);
  [[nodiscard]] Steering end(Status status, std::string reason);

  RobotBody body_;
  WallFollowerOptions options_;
  WallSide side_;
  PoseWatch watch_;
  Recovery recovery_;
  SideWall wall_;
  std::optional<Vec2> edge_;              // the last point of the wall that was abreast
  LoopWatch loop_;                        // begins where the wall is first followed in its proper distance
  std::optional<double> silent_since_s_;  // nothing is known of any wall
  std::optional<Steering> ended_;
  std::optional<Vec2> mapped_wall_;  // the nearest one of the map, when it was asked for
  double unseen_m_ = 0.0;            // since a wall was seen last
  double past_edge_m_ = 0.0;         // since the wall's last point was abreast
  double approach_m_ = 0.0;          // travel towards a wall that is not reached yet
  bool beside_ = false;              // S sees a wall
  bool goes_on_ = false;             // SF sees the same one
  bool rounding_ = false;            // the robot is on its way around `edge_`
  bool turning_away_ = false;        // from what is ahead
  bool lost_ = true;                 // at first there is none
};

}  // namespace echoarc::nav
