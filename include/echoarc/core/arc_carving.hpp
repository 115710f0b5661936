// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/core/arc.hpp"

namespace echoarc {

/// A circular arc in few numbers, to tell quickly that a free sector does not meet it.
struct CircleOutline {
  Vec2 centre;
  Vec2 begin;  ///< unit vectors from the centre to the arc's ends
  Vec2 end;
  double radius_m = 0.0;

  /// Whether a direction from the centre lies between the ends; of any length.
  [[nodiscard]] bool holds(Vec2 v) const { return cross(begin, v) > 0.0 && cross(v, end) > 0.0; }
};

/// The space between a sensor and its echo, in which nothing answered ([Silver04] eq. 3.2):
///
///     F = { P : half path(P) < r - guard  and  |bearing of P from the arc's centre - axis| < h }
///
/// An open set, where the paper prints <=: so that equal readings leave each other whole, and neighbouring beams that
/// only touch do so, too. Always the whole beam of the reading, whatever was carved from its arc since.
class FreeSector {
 public:
  /// `guard_m` >= 0 keeps that much before the echo out of F, for the error of the ranges; 0 is the paper's rule.
  explicit FreeSector(const Arc& arc, double guard_m = 0.0);

  [[nodiscard]] const Arc& arc() const { return arc_; }
  /// F holds the points with less than this half path; not positive when the guard leaves nothing.
  [[nodiscard]] double reach_m() const { return reach_m_; }
  /// The two edges of the beam, as unit vectors from the centre: clockwise and counter-clockwise.
  [[nodiscard]] Vec2 low_edge() const { return low_edge_; }
  [[nodiscard]] Vec2 high_edge() const { return high_edge_; }
  /// A box that holds F.
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] bool contains(Vec2 p) const;
  /// True when distances alone tell that no point of `older` lies in F; calls no trigonometric function.
  [[nodiscard]] bool out_of_reach(const Arc& older) const;
  /// True when the whole arc lies at or beyond one of the lines along the beam's edges, behind which F, convex below
  /// half a turn, has no point.
  [[nodiscard]] bool leaves_aside(const CircleOutline& older) const {
    const Vec2 offset = older.centre - arc_.centre();
    const Vec2 first = offset + older.radius_m * older.begin;
    const Vec2 last = offset + older.radius_m * older.end;
    const auto beyond = [&](Vec2 inwards) {
      if (dot(inwards, first) > 0.0 || dot(inwards, last) > 0.0) return false;
      return !older.holds(inwards) || dot(inwards, offset) + older.radius_m <= 0.0;
    };
    return beyond(perpendicular(low_edge_)) || beyond(-perpendicular(high_edge_));
  }

 private:
  Arc arc_;
  double reach_m_ = 0.0;
  Vec2 axis_;
  double cos_half_width_ = 1.0;
  Vec2 low_edge_;
  Vec2 high_edge_;
  Box bounds_;
};

/// An arc that is carved again and again, with the directions that this takes at hand.
class CarvableArc {
 public:
  CarvableArc() = default;
  explicit CarvableArc(const Arc& arc);

  [[nodiscard]] const Arc& arc() const { return arc_; }
  void set_limits(Angle begin, Angle end);
  /// Unit vectors from the arc's centre: along its axis, to its first and its last point.
  [[nodiscard]] Vec2 axis() const { return axis_; }
  [[nodiscard]] Vec2 begin() const { return begin_; }
  [[nodiscard]] Vec2 end() const { return end_; }
  /// Of a circular arc.
  [[nodiscard]] CircleOutline outline() const { return {arc_.centre(), begin_, end_, arc_.range_m()}; }

 private:
  Arc arc_;
  Vec2 axis_;
  Vec2 begin_;
  Vec2 end_;
};

/// What a newer reading made of an older arc.
enum class CarveOutcome : std::uint8_t {
  unchanged,
  carved,         ///< one connected piece is left
  removed_full,   ///< nothing is left: the echo was spurious, or what it came from is gone
  removed_split,  ///< more than one piece is left; the newer sensor is closer and knows better ([Silver04] 3)
};

struct Carving {
  CarveOutcome outcome = CarveOutcome::unchanged;
  Angle t_begin;  ///< what is left, closed, relative to the older arc's axis; of a removed arc what it had
  Angle t_end;
};

/// Takes the part of `older` inside F from it: C' = C - C cap F_j for one strictly newer j ([Silver04] eqs. 3.4, 3.5).
///
/// Pieces of less than `min_arc` do not count: none so short is kept, and none so short divides an arc. Between circles
/// the ends of the pieces are exact; where an ellipse is involved its crossings with the front of F are bisected to
/// 1e-13 rad.
[[nodiscard]] Carving carve(const CarvableArc& older, const FreeSector& newer);
[[nodiscard]] Carving carve(const Arc& older, const FreeSector& newer);

/// What is left of `arc` at most spans this chord from its middle: E_s = 2 r sin(E_m / 2), E_m = (t_end - t_begin) / 2
/// ([Silver04] eqs. 5.2, 5.3); of an ellipse the distance to the farther end. Metres.
[[nodiscard]] double max_error_m(const Arc& arc);

}  // namespace echoarc
