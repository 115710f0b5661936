// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/cost_map.hpp"
#include "echoarc/nav/path_follower.hpp"
#include "echoarc/nav/progress_watch.hpp"
#include "echoarc/nav/recovery.hpp"
#include "echoarc/nav/replanner.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

/// Heads for a point nearby, world, m, around what stands in between.
using Avoidance = std::function<RobotVelocity(const Surroundings&, Vec2 target)>;

/// The velocity that follows a path: what `avoidance` wants, or straight for the target if it is empty, slow enough to
/// stop at the path's end.
[[nodiscard]] RobotVelocity follow_velocity(const Surroundings& surroundings, const Following& following,
                                            const RobotLimits& limits, const PathFollowerOptions& options,
                                            const Avoidance& avoidance);

struct GoToOptions {
  CostMapOptions map{.unknown_passable = true};
  GridPlannerOptions planner;
  ReplannerOptions replanner;
  PathFollowerOptions follower;
  RecoveryOptions recovery;
  double no_progress_s = 20.0;
  double patience_s = 3.0;
  bool look_around = true;
  Angle look_around_per_s = degrees(30.0);

  /// Those of its own; the parts have theirs.
  static constexpr auto fields() {
    using O = GoToOptions;
    return std::tuple{
        field("no_progress_s", &O::no_progress_s,
              {.unit = "s", .min = 1.0, .max = 3600.0, .doc = "after so long without progress it gives up"}),
        field("patience_s", &O::patience_s,
              {.unit = "s", .min = 0.0, .max = 600.0, .doc = "without a way it waits so long for one"}),
        field("look_around", &O::look_around, {.doc = "before that it turns round once, which clears ghosts"}),
        field("look_around_rate_deg", &O::look_around_per_s,
              {.unit = "deg/s", .min = 1.0, .max = 360.0, .doc = "rate of that turn"})};
  }
};

/// Goes to one goal after the other by the map, keeping clear of what the map and `avoidance` know.
class GoTo final : public Strategy {
 public:
  GoTo(std::vector<Vec2> goals, const RobotBody& body, const GoToOptions& options = {}, Avoidance avoidance = {},
       std::string_view name = "goto");

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] Steering update(const Surroundings& surroundings) override;
  [[nodiscard]] Sketch sketch() const override;

 private:
  [[nodiscard]] Steering end(Status status, std::string reason);
  [[nodiscard]] Steering go(const Surroundings& surroundings);
  [[nodiscard]] Steering wait(double time_s, PlanFault fault);
  [[nodiscard]] Steering plan(double time_s);
  [[nodiscard]] Steering arrive();
  void head_for(std::size_t goal);

  std::vector<Vec2> goals_;
  RobotBody body_;
  GoToOptions options_;
  Avoidance avoidance_;
  std::string_view name_;
  PoseWatch pose_watch_;
  CostMap map_;
  Replanner replanner_;
  ProgressWatch progress_;
  Recovery recovery_;
  std::optional<std::uint64_t> map_version_;
  std::optional<Vec2> here_;  // where the robot was last
  std::size_t goal_ = 0;
  std::optional<double> without_way_s_;  // since when there is none
  std::optional<double> planning_since_s_;
  std::optional<Steering> ended_;
};

}  // namespace echoarc::nav
