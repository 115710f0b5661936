// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "echoarc/live/navigation_grid.hpp"
#include "echoarc/live/obstacles.hpp"
#include "echoarc/live/record.hpp"
#include "echoarc/live/source.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/nav/strategy.hpp"
#include "echoarc/sensing/sensing.hpp"

namespace echoarc::live {

/// What a robot that finds its way by itself plans on.
enum class PlanningMap : std::uint8_t {
  evidence,  ///< an evidence grid
  limited,   ///< one of laser-limited readings
  points,    ///< the points of the method
};

struct NavigatorOptions {
  std::string method = "combined";  ///< whose points are the obstacles around the robot
  PlanningMap map = PlanningMap::evidence;
  double cell_m = 0.10;       ///< of the map plans are made on
  double reach_m = 4.0;       ///< points further from the robot are none of its surroundings
  int map_history = 2000;     ///< so many can still be carved away from the points that plans are made on
  int history = 250;          ///< so many of the newest arcs, or points, are the local map
  int neighbours = 1;         ///< a point with fewer others within 20 cm is noise
  double map_period_s = 0.5;  ///< the map is brought up to date so often
};

/// A robot's own maps for finding its way, and the strategy that uses them. Made for the control alone: it depends on
/// nothing that people watch or change.
class Navigator {
 public:
  /// Errors: an unknown method.
  [[nodiscard]] static Result<Navigator> make(const SourceDescription& source, const NavigatorOptions& options = {});

  /// In the order of time, as they come.
  void heed(const Record& record);
  /// Follows it from now on; null: none. What was mapped stays. `places` lie on the map that plans are made on, whether
  /// anything was heard there or not.
  void follow(std::unique_ptr<nav::Strategy> strategy, std::span<const Vec2> places = {});
  [[nodiscard]] const nav::Strategy* strategy() const { return strategy_.get(); }
  /// Brings the maps up to date and asks the strategy, of which there is one. `T_world_base` in the odometry's frame.
  [[nodiscard]] nav::Steering steer(double time_s, const Pose2& T_world_base, const RobotVelocity& velocity);

  /// Brings the maps up to date while no strategy drives: nothing waits to be mapped, whenever one begins.
  void rest(double time_s, Vec2 here);

  /// Obstacles near the robot as of the last `steer`, world, m.
  [[nodiscard]] std::span<const Vec2> points() const { return points_; }
  /// What was heard to be free and occupied, whatever plans are made on.
  [[nodiscard]] const NavigationGrid& evidence() const { return heard_; }
  /// What plans are made on.
  [[nodiscard]] const NavigationGrid& map() const {
    return options_.map == PlanningMap::points ? from_points_ : heard_;
  }

 private:
  Navigator(const SourceDescription& source, const NavigatorOptions& options, AnyMethod local, AnyMethod global);
  void map_readings();
  void refresh_points(Vec2 here);
  void refresh_map(double time_s, Vec2 here);
  void take_points(Vec2 here);

  NavigatorOptions options_;
  InlineExecutor executor_;
  Sensing sensing_;
  AnyMethod local_;
  AnyMethod global_;  // of the planning map's points, where that is made of them
  EvidenceGrid evidence_;
  NavigationGrid heard_;
  NavigationGrid from_points_;
  std::vector<Vec2> places_;
  Box changed_;
  bool anything_changed_ = false;
  double map_time_s_;
  std::vector<Vec2> points_;
  std::unique_ptr<nav::Strategy> strategy_;
};

/// The obstacles of a navigator: points of a map, all of them sure.
class PointObstacles final : public Obstacles {
 public:
  explicit PointObstacles(std::span<const Vec2> points) : points_(points) {}
  [[nodiscard]] std::optional<double> free_along(const Pose2& T_world_base, const RobotVelocity& velocity,
                                                 double hull_radius_m, int least_hits = 1) const override;

 private:
  std::span<const Vec2> points_;
};

}  // namespace echoarc::live
