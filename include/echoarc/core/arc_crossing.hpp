// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <span>

#include "echoarc/core/arc.hpp"

namespace echoarc {

/// A point that two arcs have in common.
struct ArcCrossing {
  Vec2 position;  ///< world, metres
  Angle t_a;      ///< parameter on the first arc, see `Arc`
  Angle t_b;      ///< parameter on the second arc
  Angle angle;    ///< between the tangents, 0 to 90 degrees
};

/// Up to four crossings, by value.
class ArcCrossings {
 public:
  static constexpr std::size_t max_count = 4;

  void add(const ArcCrossing& crossing) {
    if (count_ < max_count) crossings_[count_++] = crossing;
  }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] const ArcCrossing& operator[](std::size_t k) const {
    assert(k < count_);
    return crossings_[k];
  }
  [[nodiscard]] const ArcCrossing* begin() const { return crossings_.data(); }
  [[nodiscard]] const ArcCrossing* end() const { return crossings_.data() + count_; }

 private:
  std::array<ArcCrossing, max_count> crossings_;
  std::size_t count_ = 0;
};

/// An arc with the numbers that every comparison with another arc needs: made once per arc, used for many partners.
class CrossableArc {
 public:
  CrossableArc() = default;
  explicit CrossableArc(const Arc& arc);

  friend ArcCrossings crossings(const CrossableArc& a, const CrossableArc& b);

 private:
  [[nodiscard]] bool may_hold(Vec2 from_centre) const;
  [[nodiscard]] double parameter_of(Vec2 from_centre) const;
  [[nodiscard]] Vec2 to_unit_circle(Vec2 from_centre) const {
    return {dot(from_centre, focal_axis_) * inverse_major_, cross(focal_axis_, from_centre) * inverse_minor_};
  }
  [[nodiscard]] Vec2 gradient(Vec2 from_centre) const;

  static void add(const CrossableArc& a, const CrossableArc& b, Vec2 position, Vec2 from_a, Vec2 from_b,
                  ArcCrossings& out);
  static ArcCrossings of_circles(const CrossableArc& a, const CrossableArc& b);
  static ArcCrossings of_ellipse(const CrossableArc& implicit, const CrossableArc& parametric, bool swapped);

  Vec2 centre_;
  Vec2 focal_axis_{1.0, 0.0};
  double range_m_ = 0.0;
  double inverse_major_ = 0.0;  // 1/A
  double inverse_minor_ = 0.0;  // 1/B
  Vec2 axis_;                   // unit vector of t = 0
  double t_begin_ = 0.0;        // limits, widened by eps_angle: the ends belong to the arc
  double t_end_ = 0.0;
  Vec2 middle_;          // unit vector half way between the limits
  double cos_half_ = 0;  // of half the distance of the limits
  double sin_half_ = 0;
  // The rational form P(u) = centre + ((1 - u^2) to_middle + 2 u along_middle) / (1 + u^2), u in [u_begin, u_end].
  Vec2 to_middle_;
  Vec2 along_middle_;
  double u_begin_ = 0.0;
  double u_end_ = 0.0;
  bool circular_ = true;
};

/// The points that two arcs have in common inside the limits of both, ends included.
///
/// Circles: closed form; concentric circles (centres closer than `eps_length_m`) and circles that only touch (half
/// chord at most `eps_length_m`) do not cross. With an ellipse: the second curve in rational form makes the equation of
/// the first one a quartic, whose roots are enclosed by Bernstein coefficients and refined to rounding; curves that
/// only touch do not cross, nor do curves that coincide.
///
/// Error of position and parameters: below 1e-11 m and rad for ranges to 3 m and angles of 0.3 degrees or more, as held
/// against dense sampling and bisection by the tests; it grows with the range and with 1 / sin(angle). The angle is
/// acos |n_a . n_b| of the normals.
[[nodiscard]] ArcCrossings crossings(const CrossableArc& a, const CrossableArc& b);
[[nodiscard]] inline ArcCrossings crossings(const Arc& a, const Arc& b) {
  return crossings(CrossableArc(a), CrossableArc(b));
}

}  // namespace echoarc
