// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "sim/beam_sweep.hpp"

namespace echoarc::sim {

namespace {

constexpr double same_slope = 1e-12;  // walls that meet in a corner leave no gap wider than their overhang
constexpr double same_depth_m = 1e-5;

/// 1 / z is linear in the slope along a straight wall.
class InverseDepth {
 public:
  explicit InverseDepth(const Sight& s)
      : u1_(s.u1), inverse_(1.0 / s.z1), rise_(s.u2 > s.u1 ? (1.0 / s.z2 - inverse_) / (s.u2 - s.u1) : 0.0) {}
  [[nodiscard]] double operator()(double u) const { return inverse_ + rise_ * (u - u1_); }

 private:
  double u1_;
  double inverse_;
  double rise_;
};

}  // namespace

void BeamDepth::open(const Beam& beam) {
  low_ = beam.low;
  width_ = (beam.high - beam.low) / slices;
  per_width_ = width_ > 0.0 ? 1.0 / width_ : 0.0;
  for (int b = 0; b < slices; ++b) slice_[static_cast<std::size_t>(b)] = {never, slope(b), 0.0, slope(b + 1), 0.0};
}

int BeamDepth::slice_at(double u) const {
  return static_cast<int>(std::clamp((u - low_) * per_width_, 0.0, slices - 1.0));
}

void BeamDepth::close(const Sight& wall) {
  const double u1 = wall.u1;
  const double u2 = wall.u2;
  const InverseDepth inverse(wall);
  const int last = slice_at(u2);
  for (int b = slice_at(u1); b <= last; ++b) {
    Slice& slice = slice_[static_cast<std::size_t>(b)];
    const double left = slope(b);
    const double right = slope(b + 1);
    const double from = std::max(u1, left);
    const double to = std::min(u2, right);
    const double furthest = 1.0 / std::min(inverse(from), inverse(to));
    const bool covers_left = u1 <= left + same_slope;
    const bool covers_right = u2 >= right - same_slope;
    if (covers_left && covers_right) {
      slice.depth = std::min(slice.depth, furthest);
      continue;
    }
    if (covers_left && to > slice.left_to) {
      slice.left_to = to;
      slice.left_depth = furthest;
    }
    if (covers_right && from < slice.right_from) {
      slice.right_from = from;
      slice.right_depth = furthest;
    }
    if (slice.left_to >= slice.right_from - same_slope && slice.left_to > left && slice.right_from < right)
      slice.depth = std::min(slice.depth, std::max(slice.left_depth, slice.right_depth));
  }
}

bool BeamDepth::may_see(const Sight& sight, double slack_m, double& low, double& high) const {
  const InverseDepth inverse(sight);
  const double u1 = sight.u1;
  const double u2 = sight.u2;
  const int first = slice_at(u1 - same_slope);
  const int last = slice_at(u2 + same_slope);
  int seen_first = slices;
  int seen_last = -1;
  for (int b = first; b <= last; ++b) {
    const double from = std::clamp(slope(b), u1, u2);
    const double to = std::clamp(slope(b + 1), u1, u2);
    const double nearest = 1.0 / std::max(inverse(from), inverse(to));
    if (nearest > slice_[static_cast<std::size_t>(b)].depth + slack_m + same_depth_m) continue;
    seen_first = std::min(seen_first, b);
    seen_last = b;
  }
  if (seen_last < 0) return false;
  low = std::max(u1, slope(seen_first));
  high = std::max(low, std::min(u2, slope(seen_last + 1)));
  return true;
}

bool BeamDepth::may_see(double u, double z) const {
  double low = 0.0;
  double high = 0.0;
  return may_see({u, z, u, z}, 0.0, low, high);
}

}  // namespace echoarc::sim
