// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/fitted_line.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {

void PointMoments::add(Vec2 p) {
  if (count_++ == 0) origin_ = p;
  const Vec2 d = p - origin_;
  sum_ = sum_ + d;
  raw_.xx += d.x * d.x;
  raw_.xy += d.x * d.y;
  raw_.yy += d.y * d.y;
}

void PointMoments::add(const PointMoments& other) {
  if (count_ == 0) {
    *this = other;
    return;
  }
  // The other's moments about this origin.
  const Vec2 shift = other.origin_ - origin_;
  const auto n = double(other.count_);
  raw_.xx += other.raw_.xx + 2.0 * shift.x * other.sum_.x + n * shift.x * shift.x;
  raw_.xy += other.raw_.xy + shift.x * other.sum_.y + shift.y * other.sum_.x + n * shift.x * shift.y;
  raw_.yy += other.raw_.yy + 2.0 * shift.y * other.sum_.y + n * shift.y * shift.y;
  sum_ = sum_ + other.sum_ + n * shift;
  count_ += other.count_;
}

PointMoments::Scatter PointMoments::scatter() const {
  if (count_ == 0) return {};
  const auto n = double(count_);
  return {raw_.xx - sum_.x * sum_.x / n, raw_.xy - sum_.x * sum_.y / n, raw_.yy - sum_.y * sum_.y / n};
}

FittedLine FittedLine::of(const PointMoments& moments) {
  const auto [xx, xy, yy] = moments.scatter();
  FittedLine line;
  line.centroid = moments.mean();
  line.direction = unit(0.5 * radians(std::atan2(2.0 * xy, xx - yy)));
  const double beside = 0.5 * (xx + yy - std::hypot(xx - yy, 2.0 * xy));
  line.rms_m = moments.count() > 0 ? std::sqrt(std::max(beside, 0.0) / double(moments.count())) : 0.0;
  return line;
}

}  // namespace echoarc
