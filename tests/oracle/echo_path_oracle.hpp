// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "echoarc/sim/echo_paths.hpp"

namespace echoarc::sim::oracle {

/// The search for echo paths written down plainly: every sequence of walls, every vertex, every bump, every sample of
/// every curve; a line of sight is held against every surface. No index, no beams.
class Paths {
 public:
  Paths(const World& world, Transducer sender, Transducer listener, PathLimits limits, std::vector<Disc> moving)
      : world_(world),
        d_(world.description()),
        sender_(sender),
        listener_(listener),
        limits_(limits),
        moving_(std::move(moving)) {}

  std::vector<EchoPath> find() {
    std::vector<std::size_t> walls;
    planes(walls, {sender_.position});
    for (const Disc& disc : d_.discs) round(disc);
    for (const Disc& disc : moving_) round(disc);
    for (const SmoothCurve& curve : d_.curves) smooth(curve);
    for (const Vertex& v : world_.vertices()) {
      if (v.echoes_to(sender_.position) && v.echoes_to(listener_.position))
        point(v.point, limits_.edge_gain_db, EchoCause::edge);
      if (limits_.max_order < 2) continue;
      for (const Wall& wall : d_.walls)
        for (const bool wall_first : {true, false}) wall_edge(wall, v, wall_first);
    }
    for (const Scatterer& bump : world_.scatterers())
      if (bump.echoes_to(sender_.position) && bump.echoes_to(listener_.position))
        point(bump.point, bump.gain_db, EchoCause::scatterer);
    return paths_;
  }

 private:
  static constexpr double touch_m = 1e-9;

  static bool hears(const Transducer& t, Vec2 p) {
    const Vec2 way = p - t.position;
    return norm(way) > touch_m &&
           (t.half_window.deg() >= 180.0 || dot(way, unit(t.axis)) >= cos(t.half_window) * norm(way));
  }
  static double side(const Wall& w, Vec2 p) { return cross(w.b - w.a, p - w.a) / norm(w.b - w.a); }
  static bool reflects(const Wall& w, Vec2 p) {
    return w.one_sided ? side(w, p) > touch_m : std::abs(side(w, p)) > touch_m;
  }
  static Vec2 image(const Wall& w, Vec2 p) { return p - 2.0 * side(w, p) * perpendicular(w.b - w.a) / norm(w.b - w.a); }
  double loss_db(MaterialId m) const { return d_.materials[m].loss_db; }

  /// Whether a -> b, without its last 1e-6 m at both ends, meets p -> q.
  static bool crosses(Vec2 a, Vec2 b, Vec2 p, Vec2 q, bool one_sided) {
    const double length = norm(b - a);
    const Vec2 u = (b - a) / length;
    const Vec2 along = q - p;
    const double den = cross(u, along);
    if (std::abs(den) <= 1e-12 * norm(along)) {
      if (one_sided || std::abs(cross(u, p - a)) > touch_m) return false;
      const auto [low, high] = std::minmax(dot(p - a, u), dot(q - a, u));
      return high >= 1e-6 && low <= length - 1e-6;
    }
    if (one_sided && den < 0.0) return false;
    const double t = cross(p - a, along) / den;
    const double s = cross(p - a, u) / den * std::abs(den);
    return t >= 1e-6 && t <= length - 1e-6 && s >= -touch_m && s <= std::abs(den) + touch_m;
  }
  static bool crosses(Vec2 a, Vec2 b, const Disc& disc) {
    const double length = norm(b - a);
    const Vec2 u = (b - a) / length;
    const double along = dot(disc.centre - a, u);
    const double half2 = disc.radius_m * disc.radius_m - std::pow(cross(u, disc.centre - a), 2);
    if (half2 <= 0.0) return false;
    const auto on_leg = [&](double t) { return t >= 1e-6 && t <= length - 1e-6; };
    return on_leg(along - std::sqrt(half2)) || on_leg(along + std::sqrt(half2));
  }
  bool sees(Vec2 a, Vec2 b) const {
    if (norm(b - a) <= 2e-6) return true;
    for (const Wall& w : d_.walls)
      if (crosses(a, b, w.a, w.b, w.one_sided)) return false;
    for (const SmoothCurve& curve : d_.curves)
      for (std::size_t i = 1; i < curve.points.size(); ++i)
        if (crosses(a, b, curve.points[i - 1], curve.points[i], false)) return false;
    const auto hides = [&](const Disc& disc) { return crosses(a, b, disc); };
    return std::ranges::none_of(d_.discs, hides) && std::ranges::none_of(moving_, hides);
  }

  /// Adds the way through `stops` if it is heard, short enough and free.
  void way(const std::vector<Vec2>& stops, double gain_db, EchoCause cause, std::size_t reflections) {
    std::vector<Vec2> points{sender_.position};
    points.insert(points.end(), stops.begin(), stops.end());
    points.push_back(listener_.position);
    double length_m = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length_m += norm(points[i] - points[i - 1]);
    if (length_m > limits_.max_length_m || !hears(sender_, stops.front()) || !hears(listener_, stops.back())) return;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (!sees(points[i - 1], points[i])) return;
    paths_.push_back({length_m, bearing(stops.front() - sender_.position), bearing(stops.back() - listener_.position),
                      gain_db, cause, static_cast<std::uint8_t>(reflections)});
  }

  void point(Vec2 p, double gain_db, EchoCause cause) { way({p}, gain_db, cause, 1); }

  static bool bounce(const Wall& w, Vec2 target, Vec2 source_image, Vec2& p) {
    const double behind = side(w, source_image);
    const double before = side(w, target);
    if ((behind < 0.0 ? before : -before) < -touch_m) return false;
    p = target + before / (before - behind) * (source_image - target);
    const double along = dot(p - w.a, w.b - w.a) / norm(w.b - w.a);
    return along >= -touch_m && along <= norm(w.b - w.a) + touch_m;
  }

  /// Whether some of `next` stands on the side of `wall` into which it mirrors.
  static bool stands_before(const Wall& wall, Vec2 source_image, const Wall& next) {
    const double front = side(wall, source_image) < 0.0 ? 1.0 : -1.0;
    return front * side(wall, next.a) > touch_m || front * side(wall, next.b) > touch_m;
  }

  void planes(std::vector<std::size_t>& walls, const std::vector<Vec2>& images) {
    if (!walls.empty()) follow_back(walls, images);
    if (static_cast<int>(walls.size()) == limits_.max_order) return;
    for (std::size_t w = 0; w < d_.walls.size(); ++w) {
      if (!walls.empty() && !stands_before(d_.walls[walls.back()], images.back(), d_.walls[w])) continue;
      if (!reflects(d_.walls[w], images.back())) continue;
      std::vector<Vec2> next = images;
      next.push_back(image(d_.walls[w], images.back()));
      walls.push_back(w);
      planes(walls, next);
      walls.pop_back();
    }
  }

  void follow_back(const std::vector<std::size_t>& walls, const std::vector<Vec2>& images) {
    std::vector<Vec2> stops(walls.size());
    Vec2 target = listener_.position;
    double gain_db = 0.0;
    for (std::size_t k = walls.size(); k-- > 0;) {
      if (!bounce(d_.walls[walls[k]], target, images[k + 1], stops[k])) return;
      target = stops[k];
      gain_db -= loss_db(d_.walls[walls[k]].material);
    }
    for (std::size_t k = 1; k < walls.size(); ++k) {
      const Vec2 from = k > 1 ? stops[k - 2] : sender_.position;
      const bool in_apex = norm(stops[k] - stops[k - 1]) < 1e-7;
      if (in_apex && convex(stops[k], d_.walls[walls[k - 1]], d_.walls[walls[k]], from)) return;
    }
    EchoCause cause = walls.size() == 1 ? EchoCause::wall : EchoCause::corner;
    for (std::size_t k = 1; k < walls.size(); ++k)
      if (!meet(d_.walls[walls[k - 1]], d_.walls[walls[k]])) cause = EchoCause::multiple;
    way(stops, gain_db, cause, walls.size());
  }

  /// Whether sound from `source` meets the outside of the corner that two walls make in `apex`: it does not stand
  /// between them.
  static bool convex(Vec2 apex, const Wall& v, const Wall& w, Vec2 source) {
    const auto ends_here = [&](const Wall& wall) { return norm(wall.a - apex) < 1e-6 || norm(wall.b - apex) < 1e-6; };
    if (!ends_here(v) || !ends_here(w)) return false;
    const auto far_end = [&](const Wall& wall) { return norm(wall.a - apex) < 1e-6 ? wall.b : wall.a; };
    const Vec2 a = far_end(v) - apex;
    const Vec2 b = far_end(w) - apex;
    const Vec2 p = source - apex;
    return cross(a, p) * cross(a, b) < 0.0 || cross(b, p) * cross(b, a) < 0.0;
  }

  static double distance(Vec2 p, const Wall& w) {
    const Vec2 along = w.b - w.a;
    const double s = std::clamp(dot(p - w.a, along) / dot(along, along), 0.0, 1.0);
    return norm(p - w.a - s * along);
  }
  static bool meet(const Wall& v, const Wall& w) {
    return std::min({distance(v.a, w), distance(v.b, w), distance(w.a, v), distance(w.b, v)}) <= 1e-6;
  }

  void wall_edge(const Wall& wall, const Vertex& vertex, bool wall_first) {
    const Vec2 near_wall = wall_first ? sender_.position : listener_.position;
    const Vec2 near_edge = wall_first ? listener_.position : sender_.position;
    Vec2 p;
    if (!reflects(wall, near_wall) || !reflects(wall, vertex.point) ||
        !bounce(wall, vertex.point, image(wall, near_wall), p))
      return;
    if (!vertex.echoes_to(p) || !vertex.echoes_to(near_edge)) return;
    const std::vector<Vec2> stops = wall_first ? std::vector{p, vertex.point} : std::vector{vertex.point, p};
    way(stops, limits_.edge_gain_db - loss_db(wall.material), EchoCause::wall_edge, 2);
  }

  [[nodiscard]] double length(Vec2 p) const { return norm(p - sender_.position) + norm(p - listener_.position); }

  /// The shortest way over a rim, among 3600 points and then ever closer.
  void round(const Disc& disc) {
    if (norm(sender_.position - disc.centre) <= disc.radius_m ||
        norm(listener_.position - disc.centre) <= disc.radius_m)
      return;
    double best = 0.0;
    const auto on_rim = [&](double phi) { return disc.centre + disc.radius_m * unit(radians(phi)); };
    const auto faces = [&](double phi) {
      const Vec2 p = on_rim(phi);
      return dot(sender_.position - p, p - disc.centre) > 0.0 && dot(listener_.position - p, p - disc.centre) > 0.0;
    };
    double shortest = std::numeric_limits<double>::infinity();
    double step = 2.0 * std::numbers::pi / 3600.0;
    for (int i = 0; i < 3600; ++i)
      if (faces(i * step) && length(on_rim(i * step)) < shortest) {
        best = i * step;
        shortest = length(on_rim(best));
      }
    if (!std::isfinite(shortest)) return;
    for (; step > 1e-9; step *= 0.5)
      for (const double phi : {best - step, best + step})
        if (faces(phi) && length(on_rim(phi)) < length(on_rim(best))) best = phi;
    const double r = disc.radius_m;
    way({on_rim(best)}, 10.0 * std::log10(r / (r + length(on_rim(best)) / 2.0)) - loss_db(disc.material),
        EchoCause::disc, 1);
  }

  /// Samples where the length stops growing or falling; the length is right to second order there.
  void smooth(const SmoothCurve& curve) {
    const auto& p = curve.points;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      const bool nearest = length(p[i]) <= length(p[i - 1]) && length(p[i]) < length(p[i + 1]);
      const bool furthest = length(p[i]) >= length(p[i - 1]) && length(p[i]) > length(p[i + 1]);
      const Vec2 left = perpendicular(p[i + 1] - p[i - 1]) / norm(p[i + 1] - p[i - 1]);
      const double side = dot(sender_.position - p[i], left);
      if (!(nearest || furthest) || side * dot(listener_.position - p[i], left) <= 0.0) continue;
      const std::size_t reach = std::min({std::size_t{8}, i, p.size() - 1 - i});
      const Vec2 a = p[i] - p[i - reach];
      const Vec2 b = p[i + reach] - p[i];
      const double bend = (side > 0.0 ? 2.0 : -2.0) * cross(a, b) / (norm(a) * norm(b) * norm(a + b));
      const double range_m = length(p[i]) / 2.0;
      const double focus =
          bend <= 0.0 ? 1.0 / (1.0 - bend * range_m) : std::min(4.0, 1.0 / std::abs(1.0 - bend * range_m));
      way({p[i] + (side > 0.0 ? 1e-5 : -1e-5) * left}, 10.0 * std::log10(focus) - loss_db(curve.material),
          EchoCause::curve, 1);
    }
  }

  const World& world_;
  const WorldDescription& d_;
  Transducer sender_;
  Transducer listener_;
  PathLimits limits_;
  std::vector<Disc> moving_;
  std::vector<EchoPath> paths_;
};

}  // namespace echoarc::sim::oracle
