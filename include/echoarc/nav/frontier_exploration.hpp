// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/cost_map.hpp"
#include "echoarc/nav/frontiers.hpp"
#include "echoarc/nav/go_to.hpp"
#include "echoarc/nav/grid_planner.hpp"
#include "echoarc/nav/progress_watch.hpp"
#include "echoarc/nav/recovery.hpp"
#include "echoarc/nav/replanner.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

struct FrontierExplorationOptions {
  CostMapOptions map;
  ReplannerOptions replanner;
  PathFollowerOptions follower{.arrival_m = 0.25};
  RecoveryOptions recovery;
  double least_size_m = 0.45;
  double exclusion_m = 0.5;
  double reach_m = 0.5;
  double no_progress_s = 20.0;
  double patience_s = 3.0;
  bool sweep_at_start = true;
  bool sweep_on_arrival = false;
  bool leave_seen = true;

  /// Those of its own; the parts have theirs.
  static constexpr auto fields() {
    using O = FrontierExplorationOptions;
    return std::tuple{
        field("least_size_m", &O::least_size_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "a frontier of fewer cells in a row is none"}),
        field("exclusion_m", &O::exclusion_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "no frontier so near to one that was visited or given up"}),
        field("reach_m", &O::reach_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "so near to a frontier it counts as reached, if in sight"}),
        field("no_progress_s", &O::no_progress_s,
              {.unit = "s", .min = 1.0, .max = 3600.0, .doc = "after so long without progress a frontier is given up"}),
        field("patience_s", &O::patience_s,
              {.unit = "s", .min = 0.0, .max = 600.0, .doc = "what the map shows must hold so long to be believed"}),
        field("sweep_at_start", &O::sweep_at_start,
              {.doc = "whether it first turns round once, to look about", .source = "[Yamauchi97]"}),
        field("sweep_on_arrival", &O::sweep_on_arrival,
              {.doc = "whether it does so at every frontier", .source = "[Yamauchi97]"}),
        field("leave_seen", &O::leave_seen,
              {.doc = "whether it goes elsewhere once a frontier has been seen from afar"})};
  }
};

/// Explores by going where what is known ends ([Yamauchi97]): of the frontiers that it has neither visited nor given up
/// it takes the one that is cheapest to reach, until there is none. Finishes with the reason "no frontier is left" or
/// "the rest is inaccessible", fails when it cannot begin.
class FrontierExploration final : public Strategy {
 public:
  explicit FrontierExploration(const RobotBody& body, const FrontierExplorationOptions& options = {},
                               Avoidance avoidance = {});

  [[nodiscard]] std::string_view name() const override { return "frontier"; }
  [[nodiscard]] Steering update(const Surroundings& surroundings) override;
  [[nodiscard]] Sketch sketch() const override;

  [[nodiscard]] const std::vector<Vec2>& visited() const { return visited_; }
  [[nodiscard]] const std::vector<Vec2>& inaccessible() const { return inaccessible_; }

 private:
  enum class Phase : std::uint8_t { sweeping, choosing, driving };

  [[nodiscard]] Steering end(Status status, std::string reason);
  void see(const Surroundings& surroundings);
  [[nodiscard]] Steering sweep(const Surroundings& surroundings);
  void begin_sweep();
  [[nodiscard]] Steering choose(const Surroundings& surroundings);
  [[nodiscard]] Steering go_to(const PlanGoal& target, const Plan& plan, const Surroundings& surroundings);
  [[nodiscard]] Steering conclude(const Surroundings& surroundings, PlanFault fault);
  [[nodiscard]] Steering drive(const Surroundings& surroundings);
  [[nodiscard]] Steering wait_for_way(double time_s);
  [[nodiscard]] Steering steer(const Surroundings& surroundings, std::string reason);
  void give_up_target();
  void reach_target();
  void leave_seen_target();
  [[nodiscard]] bool near_any(const std::vector<Vec2>& places, Vec2 target) const;
  [[nodiscard]] bool still_there(Vec2 target) const;
  [[nodiscard]] std::vector<PlanGoal> candidates() const;

  RobotBody body_;
  FrontierExplorationOptions options_;
  Avoidance avoidance_;
  PoseWatch pose_watch_;
  CostMap map_;
  FrontierFinder finder_;
  GridPlanner chooser_;
  Replanner replanner_;
  ProgressWatch progress_;
  Recovery recovery_;

  Phase phase_ = Phase::choosing;
  Angle swept_;
  std::optional<Angle> last_heading_;
  std::optional<double> sweeping_since_s_;
  std::optional<std::uint64_t> map_version_;
  std::optional<Vec2> here_;      // where the robot was last
  std::vector<PlanGoal> choice_;  // that `chooser_` is at work on
  bool choosing_ = false;
  bool thorough_ = false;  // goals all along the frontiers
  std::optional<PlanGoal> target_;
  std::optional<double> nothing_since_s_;  // no frontier to go to
  std::optional<double> cut_off_since_s_;  // no way to the target
  std::vector<Vec2> visited_;
  std::vector<Vec2> inaccessible_;
  std::vector<Vec2> seen_;  // targets that were no frontier any more before they were reached
  std::optional<Steering> ended_;
};

}  // namespace echoarc::nav
