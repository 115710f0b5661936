// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/core/reading.hpp"

namespace echoarc {

/// Lengths and angles closer than this are equal; arcs shorter than `min_arc` are no arcs.
inline constexpr double eps_length_m = 1e-9;
inline constexpr Angle eps_angle = radians(1e-9);
inline constexpr Angle min_arc = radians(1e-6);

/// Which part of the ellipse of a bistatic reading is its arc.
enum class BeamPolicy {
  bisector,  ///< bearings from the foci's midpoint within half a beam of the mean orientation
  both,      ///< points inside both beams; empty for diverging sensors at short range
  either,    ///< connected hull of the points inside either beam
};

struct Box {
  Vec2 low;
  Vec2 high;
};

/// The curve on which the echo of a reading lies, with constant path length |P-tx| + |P-rx| = 2 range.
///
/// Transmitter = receiver gives a circular arc; otherwise the arc is elliptical with the sensors as foci ([Barshan07]
/// 2, Fig. 1). Both kinds are parametrised alike: by the bearing of the point from `centre()` (the sensor, or the
/// midpoint of the foci), relative to `axis()`. The parameter t runs over the closed interval [t_begin, t_end] inside
/// [-h, h].
class Arc {
 public:
  /// Circular arc about `sensor`: { S + r (cos tau, sin tau) : |wrap(tau - axis)| <= beam/2 } ([Silver04] eq. 2.1).
  /// Requires range_m > 0 and 0 < beam_width < pi.
  [[nodiscard]] static Arc circular(Vec2 sensor, Angle axis, double range_m, Angle beam_width);

  /// Elliptical arc. No value when the path 2 range_m does not exceed the distance of the foci, when the acoustic axes
  /// are more than 90 degrees apart, or when `policy` leaves nothing. Foci closer than `eps_length_m` give the circle.
  [[nodiscard]] static std::optional<Arc> elliptical(const Pose2& T_world_tx, const Pose2& T_world_rx, double range_m,
                                                     Angle beam_width, BeamPolicy policy = BeamPolicy::bisector);

  [[nodiscard]] bool is_circular() const { return semi_focal_m_ == 0.0; }
  [[nodiscard]] Vec2 centre() const { return centre_; }
  [[nodiscard]] Vec2 transmitter() const { return centre_ - semi_focal_m_ * focal_axis_; }
  [[nodiscard]] Vec2 receiver() const { return centre_ + semi_focal_m_ * focal_axis_; }
  [[nodiscard]] double range_m() const { return range_m_; }            ///< semi-major axis; the radius of a circle
  [[nodiscard]] double semi_minor_m() const { return semi_minor_m_; }  ///< the radius of a circle
  [[nodiscard]] Vec2 focal_axis() const { return focal_axis_; }        ///< unit vector from transmitter to receiver
  [[nodiscard]] Angle axis() const { return axis_; }
  [[nodiscard]] Angle half_width() const { return half_width_; }
  [[nodiscard]] Angle t_begin() const { return t_begin_; }
  [[nodiscard]] Angle t_end() const { return t_end_; }
  /// Keeps [begin, end] only; both relative to `axis()`, begin <= end.
  void set_limits(Angle begin, Angle end);

  /// The arc with the same sensors, axis and limits at another range, which must exceed half the distance of the foci.
  [[nodiscard]] Arc at_range(double range_m) const;

  /// Distance from `centre()` at parameter `t`: rho = A B / sqrt(B^2 cos^2 u + A^2 sin^2 u), u = bearing - focal axis.
  [[nodiscard]] double radius_at(Angle t) const;
  [[nodiscard]] Vec2 point_at(Angle t) const;
  /// The point where nothing but the reading is known: t = 0.
  [[nodiscard]] Vec2 midpoint() const { return point_at(Angle{}); }
  /// Outward unit normal, unit(unit(P-tx) + unit(P-rx)): the bisector of incidence and reflection.
  [[nodiscard]] Vec2 normal_at(Angle t) const;
  /// Unit tangent in the direction of growing `t`.
  [[nodiscard]] Vec2 tangent_at(Angle t) const { return perpendicular(normal_at(t)); }
  /// Metres along the arc; exact for circles, 1e-12 relative for ellipses (16-point Gauss-Legendre).
  [[nodiscard]] double length_m() const;
  /// Whether the bearing (world frame, from `centre()`) lies on the arc; ends included.
  [[nodiscard]] bool contains_bearing(Angle bearing) const;
  /// Half the path of a point, (|P-tx| + |P-rx|)/2: its distance for a circle. On the arc it equals `range_m()`.
  [[nodiscard]] double half_path_m(Vec2 p) const;
  /// Smallest axis-parallel box that holds the arc.
  [[nodiscard]] Box bounds() const;

 private:
  Vec2 centre_;
  Vec2 focal_axis_{1.0, 0.0};
  double semi_focal_m_ = 0.0;
  double range_m_ = 0.0;
  double semi_minor_m_ = 0.0;
  Angle axis_;
  Angle half_width_;
  Angle t_begin_;
  Angle t_end_;
};

/// The arc of a reading; no value when it has no echo or its bistatic geometry has no arc.
[[nodiscard]] std::optional<Arc> arc_of(const Reading& reading, BeamPolicy policy = BeamPolicy::bisector);

}  // namespace echoarc
