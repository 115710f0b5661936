// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/view.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::sim {

namespace {

constexpr double slope_slack = 1e-9;
const Angle widest_half_sector = degrees(30.0);

}  // namespace

void View::look(const Transducer& eye, bool inward, double reach_m, BeamSweep& sweep, std::uint64_t& work) {
  const Angle half = std::clamp(eye.half_window, Angle{}, degrees(180.0));
  count_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(half / widest_half_sector - 1e-9)));
  if (sectors_.size() < count_) sectors_.resize(count_);
  const Angle half_sector = half / static_cast<double>(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    const Vec2 forward = unit(eye.axis - half + (2.0 * static_cast<double>(i) + 1.0) * half_sector);
    const double slope = tan(half_sector) + slope_slack;
    sectors_[i].beam = {.eye = eye.position,
                        .forward = forward,
                        .aside = perpendicular(forward),
                        .low = -slope,
                        .high = slope,
                        .reach_m = reach_m,
                        .inward = inward};
    sweep.sweep(sectors_[i].beam, sectors_[i].depth, sectors_[i].lit, work);
  }
}

bool View::may_see(Vec2 point) const {
  return std::ranges::any_of(sectors(), [&](const Sector& sector) {
    const Beam& beam = sector.beam;
    const double z = dot(point - beam.eye, beam.forward);
    if (z <= 0.0) return false;
    const double u = dot(point - beam.eye, beam.aside) / z;
    return u >= beam.low && u <= beam.high && sector.depth.may_see(u, z);
  });
}

Beam reflected(const Beam& beam, std::uint32_t wall, const Mirror& mirror, double low, double high) {
  const Vec2 normal = perpendicular(mirror.direction);
  const auto turned = [&](Vec2 v) { return v - 2.0 * dot(v, normal) * normal; };
  Beam next = beam;
  next.eye = mirror.image(beam.eye);
  next.forward = turned(beam.forward);
  next.aside = turned(beam.aside);
  next.low = low - slope_slack;
  next.high = high + slope_slack;
  next.mirror = wall;
  next.mirror_point = mirror.a;
  next.mirror_normal = mirror.side(beam.eye) > 0.0 ? normal : -normal;
  return next;
}

}  // namespace echoarc::sim
