// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc_crossing.hpp"

#include <cmath>

#include "core/quartic_roots.hpp"

namespace echoarc {

CrossableArc::CrossableArc(const Arc& arc)
    : centre_(arc.centre()),
      focal_axis_(arc.focal_axis()),
      range_m_(arc.range_m()),
      inverse_major_(1.0 / arc.range_m()),
      inverse_minor_(1.0 / arc.semi_minor_m()),
      axis_(unit(arc.axis())),
      t_begin_((arc.t_begin() - eps_angle).rad()),
      t_end_((arc.t_end() + eps_angle).rad()),
      circular_(arc.is_circular()) {
  const Angle middle = 0.5 * (arc.t_begin() + arc.t_end());
  const Angle half = radians(0.5 * (t_end_ - t_begin_));
  middle_ = unit(arc.axis() + middle);
  cos_half_ = cos(half);
  sin_half_ = sin(half);
  // In the affine frame where the ellipse is the unit circle, the arc runs from e_begin to e_end about its middle.
  const Vec2 g = perpendicular(focal_axis_);
  const auto on_unit_circle = [&](Vec2 direction) {
    const Vec2 e = to_unit_circle(direction);
    return e / norm(e);
  };
  const Vec2 e = on_unit_circle(middle_);
  to_middle_ = arc.range_m() * e.x * focal_axis_ + arc.semi_minor_m() * e.y * g;
  along_middle_ = -arc.range_m() * e.y * focal_axis_ + arc.semi_minor_m() * e.x * g;
  const auto half_tangent = [&](double t) {  // tan(angle / 2) = sin / (1 + cos)
    const Vec2 end = on_unit_circle(unit(arc.axis() + radians(t)));
    return cross(e, end) / (1.0 + dot(e, end));
  };
  u_begin_ = half_tangent(t_begin_);
  u_end_ = half_tangent(t_end_);
}

/// Whether the direction may lie between the limits: two products, no angle. Most points of the curve do not.
bool CrossableArc::may_hold(Vec2 from_centre) const {
  const double along = dot(middle_, from_centre);
  const double aside = std::abs(cross(middle_, from_centre));
  constexpr double slack = 1e-9;
  return along * sin_half_ - aside * cos_half_ >= -slack * (std::abs(along) + aside);
}

double CrossableArc::parameter_of(Vec2 from_centre) const {
  return std::atan2(cross(axis_, from_centre), dot(axis_, from_centre));
}

Vec2 CrossableArc::gradient(Vec2 from_centre) const {
  if (circular_) return from_centre;
  return (dot(from_centre, focal_axis_) * inverse_major_ * inverse_major_) * focal_axis_ +
         (cross(focal_axis_, from_centre) * inverse_minor_ * inverse_minor_) * perpendicular(focal_axis_);
}

void CrossableArc::add(const CrossableArc& a, const CrossableArc& b, Vec2 position, Vec2 from_a, Vec2 from_b,
                       ArcCrossings& out) {
  if (!a.may_hold(from_a) || !b.may_hold(from_b)) return;
  const double t_a = a.parameter_of(from_a);
  const double t_b = b.parameter_of(from_b);
  if (!(t_a >= a.t_begin_ && t_a <= a.t_end_ && t_b >= b.t_begin_ && t_b <= b.t_end_)) return;
  const Vec2 n_a = a.gradient(from_a);
  const Vec2 n_b = b.gradient(from_b);
  const double angle = std::atan2(std::abs(cross(n_a, n_b)), std::abs(dot(n_a, n_b)));
  out.add({position, radians(t_a), radians(t_b), radians(angle)});
}

/// The chord is measured from the smaller circle, whose radius the difference of squares may otherwise swallow.
ArcCrossings CrossableArc::of_circles(const CrossableArc& a, const CrossableArc& b) {
  ArcCrossings found;
  const Vec2 a_to_b = b.centre_ - a.centre_;
  const double d2 = squared_norm(a_to_b);
  constexpr double eps2 = eps_length_m * eps_length_m;
  if (!(d2 >= eps2)) return found;
  const bool from_b = b.range_m_ < a.range_m_;
  const double small = from_b ? b.range_m_ : a.range_m_;
  const double large = from_b ? a.range_m_ : b.range_m_;
  if (d2 > (small + large) * (small + large) || d2 < (large - small) * (large - small)) return found;
  const double d = std::sqrt(d2);
  const double along = 0.5 * (small * small + (d - large) * (d + large)) / d2;  // of the chord, as a share of d
  const double chord2 = small * small / d2 - along * along;                     // half chord squared, likewise
  if (!(chord2 * d2 > eps2)) return found;
  const double aside = std::sqrt(chord2);
  for (const double side : {aside, -aside}) {
    const Vec2 from_small = (from_b ? -along : along) * a_to_b + side * perpendicular(a_to_b);
    const Vec2 from_a = from_b ? from_small + a_to_b : from_small;
    const Vec2 to_b = from_b ? from_small : from_small - a_to_b;
    add(a, b, a.centre_ + from_a, from_a, to_b, found);
  }
  return found;
}

/// |S P(u)|^2 = 1, with S the map that turns the implicit ellipse into the unit circle: with
/// (1 + u^2) S P(u) = alpha + beta u + gamma u^2 a quartic in u.
ArcCrossings CrossableArc::of_ellipse(const CrossableArc& implicit, const CrossableArc& parametric, bool swapped) {
  ArcCrossings found;
  const Vec2 offset = parametric.centre_ - implicit.centre_;
  const Vec2 alpha = implicit.to_unit_circle(offset + parametric.to_middle_);
  const Vec2 beta = 2.0 * implicit.to_unit_circle(parametric.along_middle_);
  const Vec2 gamma = implicit.to_unit_circle(offset - parametric.to_middle_);
  const Quartic quartic{squared_norm(alpha) - 1.0, 2.0 * dot(alpha, beta),
                        squared_norm(beta) + 2.0 * dot(alpha, gamma) - 2.0, 2.0 * dot(beta, gamma),
                        squared_norm(gamma) - 1.0};
  const double noise = 1e-14 * (1.0 + squared_norm(alpha) + squared_norm(beta) + squared_norm(gamma));
  const QuarticRoots roots = roots_between(quartic, parametric.u_begin_, parametric.u_end_, noise);
  for (std::size_t k = 0; k < roots.count; ++k) {
    const double u = roots.u[k];
    const Vec2 from_parametric =
        ((1.0 - u * u) * parametric.to_middle_ + 2.0 * u * parametric.along_middle_) / (1.0 + u * u);
    const Vec2 position = parametric.centre_ + from_parametric;
    const Vec2 from_implicit = offset + from_parametric;
    if (swapped)
      add(parametric, implicit, position, from_parametric, from_implicit, found);
    else
      add(implicit, parametric, position, from_implicit, from_parametric, found);
  }
  return found;
}

ArcCrossings crossings(const CrossableArc& a, const CrossableArc& b) {
  if (a.circular_ && b.circular_) return CrossableArc::of_circles(a, b);
  return a.circular_ ? CrossableArc::of_ellipse(b, a, true) : CrossableArc::of_ellipse(a, b, false);
}

}  // namespace echoarc
