// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc_carving.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/arc_pieces.hpp"

namespace echoarc {
namespace {

/// The ends of pieces of one arc: at most 2 ends, 4 crossings with the beam's edges and 4 with the front of F (Bezout);
/// the rest is for crossings that rounding multiplies where two ellipses nearly coincide.
class Breakpoints {
 public:
  explicit Breakpoints(const Arc& older) : older_(older), axis_(unit(older.axis())) {}

  void add(Angle t) {
    if (t > older_.t_begin() && t < older_.t_end() && count_ < values_.size()) values_[count_++] = t;
  }
  /// The point of the arc in a direction from its centre; of any length.
  void add(Vec2 direction) { add(radians(std::atan2(cross(axis_, direction), dot(axis_, direction)))); }
  [[nodiscard]] std::span<const Angle> sorted() {
    std::sort(values_.begin(), values_.begin() + std::ptrdiff_t(count_));
    return {values_.data(), count_};
  }

 private:
  const Arc& older_;
  Vec2 axis_;
  std::array<Angle, 24> values_;
  std::size_t count_ = 0;
};

/// Where the ellipse (or circle) of `older` meets the straight line through the newer centre along `edge`.
void add_edge(const Arc& older, Vec2 newer_centre, Vec2 edge, Breakpoints& breakpoints) {
  // P = M + A cos(s) f + B sin(s) g on the line: p cos s + q sin s + c = 0.
  const Vec2 f = older.range_m() * older.focal_axis();
  const Vec2 g = older.semi_minor_m() * perpendicular(older.focal_axis());
  const double p = cross(edge, f);
  const double q = cross(edge, g);
  const double c = cross(edge, older.centre() - newer_centre);
  const double size2 = p * p + q * q;
  const double rest = size2 - c * c;
  if (!(rest >= 0.0)) return;
  const double root = std::sqrt(rest);
  breakpoints.add((-c * p - root * q) * f + (-c * q + root * p) * g);
  breakpoints.add((-c * p + root * q) * f + (-c * q - root * p) * g);
}

/// Half path of the points of an arc above the front of F, as a function of the arc's parameter.
class Excess {
 public:
  Excess(const Arc& older, const FreeSector& newer) : older_(older), newer_(newer) {}

  [[nodiscard]] double operator()(double t) const {
    return newer_.arc().half_path_m(older_.point_at(radians(t))) - newer_.reach_m();
  }

  /// The zero between two parameters with values of opposite sign.
  [[nodiscard]] double zero(double low, double high) const {
    const bool rising = (*this)(low) < 0.0;
    while (high - low > 1e-13) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (((*this)(middle) < 0.0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  /// The parameter of the extreme value of one sign (+1: the smallest) between two parameters, by golden section.
  [[nodiscard]] double extreme(double low, double high, double sign) const {
    constexpr double golden = 0.6180339887498949;
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double at_a = sign * (*this)(a);
    double at_b = sign * (*this)(b);
    while (high - low > 1e-9) {
      if (at_a < at_b) {
        high = b;
        b = a;
        at_b = at_a;
        a = high - golden * (high - low);
        at_a = sign * (*this)(a);
      } else {
        low = a;
        a = b;
        at_a = at_b;
        b = low + golden * (high - low);
        at_b = sign * (*this)(b);
      }
    }
    return 0.5 * (low + high);
  }

 private:
  const Arc& older_;
  const FreeSector& newer_;
};

/// Intervals in which an arc is searched for crossings that have no closed form: 1 cm apart, 32 to 1024 of them.
int search_intervals(const Arc& older) {
  constexpr double step_m = 0.01;
  const double length_m = older.range_m() * (older.t_end() - older.t_begin()).rad();
  return int(std::clamp(std::ceil(length_m / step_m), 32.0, 1024.0));
}

/// Where an arc meets the ellipse that bounds F, or an ellipse the circle: signs at samples, then bisection. Between
/// two crossings closer than a sample the extreme value gives the second sign.
void add_front_by_search(const Arc& older, const FreeSector& newer, Breakpoints& breakpoints) {
  const Excess excess(older, newer);
  const int intervals = search_intervals(older);
  const double begin = older.t_begin().rad();
  const double step = (older.t_end() - older.t_begin()).rad() / intervals;
  const double reach_of_step_m = 2.0 * step * older.range_m() * older.range_m() / older.semi_minor_m();
  double before = excess(begin - step);
  double here = excess(begin);
  for (int k = 0; k <= intervals; ++k) {
    const double t = begin + k * step;
    const double after = excess(t + step);
    if ((here < 0.0) != (after < 0.0)) {
      breakpoints.add(radians(excess.zero(t, t + step)));
    } else if (std::abs(here) < reach_of_step_m && (before < 0.0) == (here < 0.0)) {
      const double sign = here < 0.0 ? -1.0 : 1.0;
      if (sign * here <= sign * before && sign * here <= sign * after) {
        const double turn = excess.extreme(t - step, t + step, sign);
        if ((excess(turn) < 0.0) != (here < 0.0)) {
          breakpoints.add(radians(excess.zero(t - step, turn)));
          breakpoints.add(radians(excess.zero(turn, t + step)));
        }
      }
    }
    before = here;
    here = after;
  }
}

detail::Pieces<Angle> cut(const Arc& older, const FreeSector& newer, std::span<const Angle> breakpoints) {
  detail::Pieces<Angle> pieces;
  Angle begin = older.t_begin();
  const auto add_until = [&](Angle end) {
    if (end > begin) pieces.add({begin, end, !newer.contains(older.point_at(0.5 * (begin + end)))});
    begin = end;
  };
  for (const Angle t : breakpoints) add_until(t);
  add_until(older.t_end());
  return pieces;
}

}  // namespace

FreeSector::FreeSector(const Arc& arc, double guard_m) : arc_(arc) {
  assert(guard_m >= 0.0);
  arc_.set_limits(-arc.half_width(), arc.half_width());
  reach_m_ = arc.range_m() - guard_m - eps_length_m;
  const Angle half_width = arc.half_width() - eps_angle;
  axis_ = unit(arc.axis());
  cos_half_width_ = cos(half_width);
  low_edge_ = unit(arc.axis() - half_width);
  high_edge_ = unit(arc.axis() + half_width);
  bounds_ = arc_.bounds();
  const Vec2 apex = arc.centre();
  bounds_.low = {std::min(bounds_.low.x, apex.x), std::min(bounds_.low.y, apex.y)};
  bounds_.high = {std::max(bounds_.high.x, apex.x), std::max(bounds_.high.y, apex.y)};
}

bool FreeSector::contains(Vec2 p) const {
  if (!(arc_.half_path_m(p) < reach_m_)) return false;
  const Vec2 d = p - arc_.centre();
  return dot(d, axis_) > norm(d) * cos_half_width_;
}

bool FreeSector::out_of_reach(const Arc& older) const {
  // F lies in the disc of its reach about its centre, the arc between the circles of its two semi-axes about its own.
  const double d2 = squared_norm(older.centre() - arc_.centre());
  const double far = reach_m_ + older.range_m();
  const double near = older.semi_minor_m() - reach_m_;
  return !(reach_m_ > 0.0) || d2 >= far * far || (near > 0.0 && d2 <= near * near);
}

CarvableArc::CarvableArc(const Arc& arc) : arc_(arc), axis_(unit(arc.axis())) {
  set_limits(arc.t_begin(), arc.t_end());
}

void CarvableArc::set_limits(Angle begin, Angle end) {
  arc_.set_limits(begin, end);
  begin_ = unit(arc_.axis() + begin);
  end_ = unit(arc_.axis() + end);
}

Carving carve(const CarvableArc& older, const FreeSector& newer) {
  const Arc& arc = older.arc();
  const Carving unchanged{CarveOutcome::unchanged, arc.t_begin(), arc.t_end()};
  if (newer.out_of_reach(arc)) return unchanged;
  if (arc.is_circular() && newer.arc().is_circular()) return detail::carve_circle(older, newer);
  Breakpoints breakpoints(arc);
  add_edge(arc, newer.arc().centre(), newer.low_edge(), breakpoints);
  add_edge(arc, newer.arc().centre(), newer.high_edge(), breakpoints);
  add_front_by_search(arc, newer, breakpoints);
  const detail::Verdict<Angle> verdict = judge(cut(arc, newer, breakpoints.sorted()));
  if (verdict.outcome != CarveOutcome::carved) return {verdict.outcome, arc.t_begin(), arc.t_end()};
  return {verdict.outcome, verdict.kept.begin, verdict.kept.end};
}

Carving carve(const Arc& older, const FreeSector& newer) {
  return carve(CarvableArc(older), newer);
}

double max_error_m(const Arc& arc) {
  const Angle half = 0.5 * (arc.t_end() - arc.t_begin());
  if (arc.is_circular()) return 2.0 * arc.range_m() * sin(0.5 * half);
  const Vec2 middle = arc.point_at(0.5 * (arc.t_begin() + arc.t_end()));
  return std::max(norm(arc.point_at(arc.t_begin()) - middle), norm(arc.point_at(arc.t_end()) - middle));
}

}  // namespace echoarc
