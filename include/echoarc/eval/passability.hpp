// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/vec2.hpp"

/// Whether a robot that looks at a map of points would think that it fits through somewhere.
namespace echoarc {

/// A rectangle along the segment a -> b: `left_m` to its left, `right_m` to its right. Metres, world frame; a and b
/// differ.
///
///        +--------------------------+   ^ left_m
///      a *------------------------->* b
///        +--------------------------+   v right_m
struct Strip {
  Vec2 a;
  Vec2 b;
  double left_m = 0.0;
  double right_m = 0.0;

  [[nodiscard]] double length_m() const { return norm(b - a); }
  /// Distance along a -> b (x) and to the left of it (y), if the point lies in the rectangle, borders included.
  [[nodiscard]] std::optional<Vec2> local(Vec2 point) const;
};

/// A stretch of a strip's segment, metres from its begin.
struct Gap {
  double begin_m = 0.0;
  double end_m = 0.0;
  [[nodiscard]] double width_m() const { return end_m - begin_m; }
};

/// The widest stretch of the segment beside which the strip holds no point; the first of several. The whole segment
/// when the strip is empty. This is how wide an opening looks in a map ([Choset03] Figs. 6, 17).
[[nodiscard]] Gap widest_gap(std::span<const Vec2> points, const Strip& strip);

[[nodiscard]] std::size_t count_points(std::span<const Vec2> points, const Strip& strip);

/// Diameter of the largest disc that can be moved through the strip from a to b, between the points and between its two
/// long sides, which are walls: the smallest over all chains of points from side to side of the chain's longest step. A
/// robot that may swerve gets through where a straight lane need not exist. O(n^2) for n points in the strip.
[[nodiscard]] double passage_width_m(std::span<const Vec2> points, const Strip& strip);

/// How wide an opening looks to the centerline model of a beam that sweeps past it at right angles ([Choset03] Fig. 4):
///
///     c = a - 2 D tan(phi / 2)
///
/// for an opening a seen from the distance D with the full beam width phi; each jamb is heard, and drawn in front of
/// the sensor, as long as it lies in the beam. Negative: no opening is seen, by that much.
[[nodiscard]] double centerline_opening_m(double opening_m, double distance_m, Angle beam_width);

}  // namespace echoarc
