// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/arc_pieces.hpp"

namespace echoarc::detail {
namespace {

/// A direction from the older centre, of unit length; all those of an arc lie within less than half a turn, so that
/// cross products order them.
struct Direction {
  Vec2 v;
  enum Kind { begin, inner, end } kind = inner;
};

bool counts(const Direction& a, const Direction& b) {
  constexpr double sin_min_arc = 1e-6;  // min_arc, to 1e-13 of itself
  return cross(a.v, b.v) >= sin_min_arc || dot(a.v, b.v) < 0.0;
}

/// Directions between the ends of an arc, in order.
class Fan {
 public:
  explicit Fan(const CircleOutline& arc) : arc_(arc) {}

  [[nodiscard]] bool holds(Vec2 v) const { return arc_.holds(v); }
  /// A direction of any length.
  void add(Vec2 v) {
    if (!holds(v)) return;
    const Vec2 direction = v / std::sqrt(squared_norm(v));
    std::size_t k = count_++;
    for (; k > 0 && cross(inner_[k - 1], direction) < 0.0; --k) inner_[k] = inner_[k - 1];
    inner_[k] = direction;
  }
  [[nodiscard]] std::span<const Vec2> inner() const { return {inner_.data(), count_}; }

 private:
  CircleOutline arc_;
  std::array<Vec2, 6> inner_;
  std::size_t count_ = 0;
};

/// The older arc as seen from the newer sensor.
struct Scene {
  Scene(const CarvableArc& older, const FreeSector& newer)
      : sector(newer),
        fan(older.outline()),
        offset(older.arc().centre() - newer.arc().centre()),
        radius_m(older.arc().range_m()),
        first(offset + radius_m * older.begin()),
        last(offset + radius_m * older.end()) {}

  const FreeSector& sector;
  Fan fan;
  Vec2 offset;  ///< of the older centre from the newer one
  double radius_m;
  Vec2 first;  ///< the ends of the older arc, from the newer centre
  Vec2 last;
};

/// Whether the whole arc lies at or beyond the circle that bounds F.
bool beyond_front(const Scene& scene) {
  const double reach2 = scene.sector.reach_m() * scene.sector.reach_m();
  if (squared_norm(scene.first) < reach2 || squared_norm(scene.last) < reach2) return false;
  if (!scene.fan.holds(-scene.offset)) return true;  // the distance has no minimum between the ends
  const double nearest = std::sqrt(squared_norm(scene.offset)) - scene.radius_m;
  return nearest * nearest >= reach2;
}

/// Where the older circle meets the straight line along an edge: cross(edge, offset + r v) = 0.
void add_edge(Scene& scene, Vec2 edge) {
  const double sine = -cross(edge, scene.offset) / scene.radius_m;
  const double rest = 1.0 - sine * sine;
  if (!(rest >= 0.0)) return;
  const double cosine = std::sqrt(rest);
  scene.fan.add(sine * perpendicular(edge) + cosine * edge);
  scene.fan.add(sine * perpendicular(edge) - cosine * edge);
}

/// Where it meets the circle that bounds F: |offset + r v| = reach.
void add_front(Scene& scene) {
  const double d2 = squared_norm(scene.offset);
  if (d2 < eps_length_m * eps_length_m) return;  // concentric: inside or outside as a whole
  const double reach_m = scene.sector.reach_m();
  const double r = scene.radius_m;
  const double k = (reach_m * reach_m - d2 - r * r) / (2.0 * r);  // offset . v
  const double rest = d2 - k * k;
  if (!(rest >= 0.0)) return;
  const double root = std::sqrt(rest);
  scene.fan.add(k * scene.offset + root * perpendicular(scene.offset));
  scene.fan.add(k * scene.offset - root * perpendicular(scene.offset));
}

Pieces<Direction> cut(const CarvableArc& older, const Scene& scene) {
  Pieces<Direction> pieces;
  Direction begin{older.begin(), Direction::begin};
  const auto add_until = [&](const Direction& end) {
    const Vec2 middle = begin.v + end.v;
    const Vec2 p = older.arc().centre() + (scene.radius_m / std::sqrt(squared_norm(middle))) * middle;
    pieces.add({begin, end, !scene.sector.contains(p)});
    begin = end;
  };
  for (const Vec2 v : scene.fan.inner()) add_until({v, Direction::inner});
  add_until({older.end(), Direction::end});
  return pieces;
}

Angle parameter(const CarvableArc& older, const Direction& direction) {
  if (direction.kind == Direction::begin) return older.arc().t_begin();
  if (direction.kind == Direction::end) return older.arc().t_end();
  const double t = std::atan2(cross(older.axis(), direction.v), dot(older.axis(), direction.v));
  return radians(std::clamp(t, older.arc().t_begin().rad(), older.arc().t_end().rad()));
}

}  // namespace

Carving carve_circle(const CarvableArc& older, const FreeSector& newer) {
  Carving carving{CarveOutcome::unchanged, older.arc().t_begin(), older.arc().t_end()};
  if (newer.leaves_aside(older.outline())) return carving;
  Scene scene(older, newer);
  if (beyond_front(scene)) return carving;
  add_edge(scene, newer.low_edge());
  add_edge(scene, newer.high_edge());
  add_front(scene);
  const Verdict<Direction> verdict = judge(cut(older, scene));
  carving.outcome = verdict.outcome;
  if (verdict.outcome != CarveOutcome::carved) return carving;
  carving.t_begin = parameter(older, verdict.kept.begin);
  carving.t_end = parameter(older, verdict.kept.end);
  return carving;
}

}  // namespace echoarc::detail
