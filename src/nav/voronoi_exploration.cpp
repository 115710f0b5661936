// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_exploration.hpp"

#include <cmath>
#include <string>

#include "nav/voronoi_explorer.hpp"

namespace echoarc::nav {

VoronoiExploration::VoronoiExploration(const RobotBody& body, const VoronoiExplorationOptions& options,
                                       const TracerOptions& tracer, const ObstacleOptions& obstacles)
    : explorer_(std::make_unique<Explorer>(body, options, tracer, obstacles)) {}
VoronoiExploration::~VoronoiExploration() = default;
VoronoiExploration::VoronoiExploration(VoronoiExploration&&) noexcept = default;
VoronoiExploration& VoronoiExploration::operator=(VoronoiExploration&&) noexcept = default;

Steering VoronoiExploration::update(const Surroundings& surroundings) {
  return explorer_->update(surroundings);
}

Sketch VoronoiExploration::sketch() const {
  return explorer_->sketch();
}

const VoronoiGraph& VoronoiExploration::graph() const {
  return explorer_->graph();
}

std::string MomentGuard::check(const Surroundings& now, const RobotLimits& limits) {
  if (!is_finite(now.T_world_base)) return "the pose is not a number";
  if (!std::isfinite(now.time_s)) return "the time is not a number";
  std::string fault;
  if (T_world_last_) {
    passed_s_ = now.time_s - last_s_;
    if (passed_s_ < 0.0) return "the time runs backwards";
    const double moved_m = norm(now.T_world_base.position - T_world_last_->position);
    const Angle turned = abs(wrap(now.T_world_base.heading - T_world_last_->heading));
    if (moved_m > 1.5 * limits.speed_m_s * passed_s_ + 0.15)
      fault = "the pose jumped by " + std::to_string(std::lround(100.0 * moved_m)) + " cm: the graph no longer fits";
    else if (turned > 1.5 * passed_s_ * limits.turn_rate_per_s + degrees(20.0))
      fault =
          "the heading jumped by " + std::to_string(std::lround(turned.deg())) + " degrees: the graph no longer fits";
  }
  T_world_last_ = now.T_world_base;
  last_s_ = now.time_s;
  return fault;
}

bool StandstillWatch::is_stuck(Vec2 place, double passed_s, double patience_s) {
  if (norm(place - anchor_) > 0.10) restart(place);
  still_s_ += passed_s;
  return still_s_ > patience_s;
}

}  // namespace echoarc::nav
