// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <span>

#include "echoarc/core/vec2.hpp"

namespace echoarc {

/// First and second moments of points, about the first of them so that far places lose no digits.
class PointMoments {
 public:
  void add(Vec2 p);
  void add(const PointMoments& other);
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Vec2 mean() const { return count_ > 0 ? origin_ + sum_ / double(count_) : origin_; }
  /// Sums of squares and products about the mean.
  struct Scatter {
    double xx = 0.0, xy = 0.0, yy = 0.0;
  };
  [[nodiscard]] Scatter scatter() const;

 private:
  Vec2 origin_;
  Vec2 sum_;  ///< of p - origin
  Scatter raw_;
  std::size_t count_ = 0;
};

/// The line with the least sum of squared distances (total least squares).
struct FittedLine {
  Vec2 centroid;
  Vec2 direction;      ///< unit
  double rms_m = 0.0;  ///< of the distances

  [[nodiscard]] static FittedLine of(const PointMoments& moments);
  [[nodiscard]] double along_m(Vec2 p) const { return dot(p - centroid, direction); }
  [[nodiscard]] double beside_m(Vec2 p) const { return cross(direction, p - centroid); }
  [[nodiscard]] Vec2 at(double along_m) const { return centroid + along_m * direction; }
};

}  // namespace echoarc
