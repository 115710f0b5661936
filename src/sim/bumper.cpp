// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/bumper.hpp"

#include <algorithm>

namespace echoarc::sim {
namespace {

// Who is held has not quite come to the wall; until it is this far off, it is the same contact.
constexpr double release_m = 0.005;

}  // namespace

/// Distance from a place to the nearest surface, as far as it matters: exact where it is close to the hull's radius
/// or less, otherwise some lower bound that is more.
double Bumper::clearance(Vec2 place, double time_s) {
  constexpr double look_m = 1.0;
  double free_m = looked_free_m_ - norm(place - looked_at_);
  if (free_m < hull_radius_m_ + release_m) {
    looked_free_m_ = free_m = world_->clearance(place, hull_radius_m_ + look_m);
    looked_at_ = place;
  }
  for (const MovingDisc& moving : world_->description().moving) {
    const Disc disc = moving.at(time_s);
    free_m = std::min(free_m, norm(place - disc.centre) - disc.radius_m);
  }
  return free_m;
}

void Bumper::check(SimulatedRobot& robot, Vec2 before_m, double time_s) {
  const Vec2 place = robot.T_world_robot().position;
  const double free_m = clearance(place, time_s);
  const bool touches = free_m < hull_radius_m_;
  // Who is touched may still back away.
  if (touches && place != before_m && free_m <= clearance(before_m, time_s)) robot.hold(before_m);
  if (touches && !touching_) ++contacts_;
  touching_ = touches || (touching_ && free_m < hull_radius_m_ + release_m);
}

}  // namespace echoarc::sim
