// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/speed_profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace echoarc::sim {

SpeedProfile::SpeedProfile(double way, double max_speed, double acceleration)
    : way_(way), acceleration_(acceleration), top_speed_(std::min(max_speed, std::sqrt(way * acceleration))) {
  assert(way >= 0.0 && max_speed > 0.0 && acceleration > 0.0);
  ramp_s_ = top_speed_ / acceleration;
  cruise_s_ = top_speed_ > 0.0 ? std::max(0.0, way / top_speed_ - ramp_s_) : 0.0;
}

double SpeedProfile::way_at(double time_s) const {
  const double left_s = duration_s() - time_s;
  if (time_s <= 0.0) return 0.0;
  if (left_s <= 0.0) return way_;
  if (time_s < ramp_s_) return 0.5 * acceleration_ * time_s * time_s;
  if (left_s < ramp_s_) return way_ - 0.5 * acceleration_ * left_s * left_s;
  return top_speed_ * (time_s - 0.5 * ramp_s_);
}

double SpeedProfile::time_at(double way) const {
  const double ramp_way = 0.5 * top_speed_ * ramp_s_;
  if (way <= ramp_way) return std::sqrt(2.0 * std::max(way, 0.0) / acceleration_);
  const double left = way_ - way;
  if (left <= ramp_way) return duration_s() - std::sqrt(2.0 * std::max(left, 0.0) / acceleration_);
  return 0.5 * ramp_s_ + way / top_speed_;
}

}  // namespace echoarc::sim
