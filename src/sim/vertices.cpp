// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <unordered_map>

#include "sim/world_model.hpp"

namespace echoarc::sim {

namespace {

constexpr double same_point_m = 1e-6;
// Walls that meet within this of 180 degrees are one wall; the tangent at the end of a curve is known less well.
constexpr double straight_rad = 1e-6;
constexpr double smooth_rad = 0.01;
constexpr double most_end_tests = 1e8;

/// Merges points closer than `same_point_m`. Kept points are that far apart, so a cell holds few of them.
class PointMerger {
 public:
  std::uint32_t add(Vec2 p) {
    const double reach = same_point_m;
    for (const double x : {p.x - reach, p.x + reach})
      for (const double y : {p.y - reach, p.y + reach})
        for (std::uint32_t v = head({x, y}); v != Topology::nowhere; v = next_[v])
          if (norm(points_[v] - p) <= same_point_m) return v;
    const auto v = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    next_.push_back(std::exchange(heads_.try_emplace(key(p), Topology::nowhere).first->second, v));
    return v;
  }
  [[nodiscard]] const std::vector<Vec2>& points() const { return points_; }

 private:
  static constexpr double cell_m = 4e-6;
  static std::uint64_t key(Vec2 p) {
    const auto cell = [](double x) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell_m)));
    };
    return cell(p.x) * 0x9e3779b97f4a7c15ULL ^
           cell(p.y) * 0xc2b2ae3d27d4eb4fULL;  // another cell's points are just tested in vain
  }
  [[nodiscard]] std::uint32_t head(Vec2 p) const {
    const auto found = heads_.find(key(p));
    return found == heads_.end() ? Topology::nowhere : found->second;
  }

  std::unordered_map<std::uint64_t, std::uint32_t> heads_;
  std::vector<Vec2> points_;
  std::vector<std::uint32_t> next_;
};

/// A wall or curve as it leaves a vertex.
struct Spoke {
  std::uint32_t vertex = 0;
  std::uint32_t wall = Topology::nowhere;
  Vec2 direction;
  bool mirror_left = true;   ///< the face on the counter-clockwise side of the spoke reflects
  bool mirror_right = true;  ///< the other one
};

Vec2 normalised(Vec2 v) {
  return v / norm(v);
}

Vertex end_vertex(Vec2 point, const Spoke& spoke) {
  if (spoke.mirror_left && spoke.mirror_right) return {point, VertexKind::end, {1.0, 0.0}, {1.0, 0.0}};
  const Vec2 d = spoke.direction;  // one-sided: known on its mirror's side alone
  return spoke.mirror_left ? Vertex{point, VertexKind::end, d, -d} : Vertex{point, VertexKind::end, -d, d};
}

/// The widest sector between neighbouring spokes decides. A sector behind a one-sided wall makes no echo.
Vertex classify(Vec2 point, std::span<Spoke> spokes) {
  if (spokes.size() == 1) return end_vertex(point, spokes.front());
  std::ranges::sort(spokes, {}, [](const Spoke& s) { return bearing(s.direction).rad(); });
  const bool has_curve = std::ranges::any_of(spokes, [](const Spoke& s) { return s.wall == Topology::nowhere; });
  const double widest = std::numbers::pi + (has_curve ? smooth_rad : straight_rad);
  Vertex vertex{point, VertexKind::concave, spokes.front().direction, spokes.front().direction};
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Spoke& from = spokes[i];
    const Spoke& to = spokes[(i + 1) % spokes.size()];
    double width = bearing(to.direction).rad() - bearing(from.direction).rad();
    if (i + 1 == spokes.size()) width += 2.0 * std::numbers::pi;
    if (width > widest && from.mirror_left && to.mirror_right)
      vertex = {point, VertexKind::convex, from.direction, to.direction};
  }
  return vertex;
}

void add_wall_ends(const WorldDescription& d, PointMerger& merger, Topology& topology, std::vector<Spoke>& spokes) {
  for (std::uint32_t w = 0; w < d.walls.size(); ++w) {
    const Wall& wall = d.walls[w];
    const Vec2 along = normalised(wall.b - wall.a);
    const std::uint32_t a = merger.add(wall.a);
    const std::uint32_t b = merger.add(wall.b);
    topology.ends_of_wall.push_back({a, b});
    spokes.push_back({a, w, along, true, !wall.one_sided});
    spokes.push_back({b, w, -along, !wall.one_sided, true});
  }
}

/// The direction in which a curve leaves `p`, to second order in the step.
Vec2 tangent(Vec2 p, Vec2 next, Vec2 after) {
  return normalised(4.0 * (next - p) - (after - p));
}

void add_curve_ends(const WorldDescription& d, PointMerger& merger, Topology& topology, std::vector<Spoke>& spokes) {
  for (const SmoothCurve& curve : d.curves) {
    const auto& p = curve.points;
    const std::uint32_t first = merger.add(p.front());
    const std::uint32_t last = merger.add(p.back());
    topology.ends_of_curve.push_back({first, last});
    spokes.push_back({first, Topology::nowhere, tangent(p[0], p[1], p[2])});
    spokes.push_back({last, Topology::nowhere, tangent(p.back(), p[p.size() - 2], p[p.size() - 3])});
  }
}

/// Walls that go through a vertex where others end leave it in two directions. False: too much work.
bool add_through_walls(const WorldDescription& d, const SpatialIndex& index, const Topology& topology,
                       std::span<const Vec2> points, std::vector<Spoke>& spokes) {
  double tests = 0.0;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const std::span<const std::uint32_t> items = index.items(index.cell_at(points[v]));
    tests += static_cast<double>(items.size());
    if (tests > most_end_tests) return false;
    for (const std::uint32_t w : items) {
      if (w >= index.first_chunk()) break;
      const Segment& line = index.segments()[w];
      const double beside = cross(points[v] - line.a, line.along);
      if (beside * beside > 2.0 * same_point_m * same_point_m * squared_norm(line.along)) continue;  // most end here
      const std::array ends = topology.ends_of_wall[w];
      if (ends[0] == v || ends[1] == v || index.distance(points[v], w) > same_point_m) continue;
      const Wall& wall = d.walls[w];
      const Vec2 along = normalised(wall.b - wall.a);
      spokes.push_back({v, w, along, true, !wall.one_sided});
      spokes.push_back({v, w, -along, !wall.one_sided, true});
    }
  }
  return true;
}

}  // namespace

bool Vertex::echoes_to(Vec2 listener) const {
  if (kind == VertexKind::concave) return false;
  if (from == to) return true;
  const Vec2 way = listener - point;
  // The sector has 180 degrees or more: it is what lies left of its first border or right of its last.
  return cross(from, way) >= 0.0 || cross(way, to) >= 0.0;
}

Result<Topology> find_vertices(const WorldDescription& description, const SpatialIndex& index) {
  Topology topology;
  PointMerger merger;
  std::vector<Spoke> spokes;
  add_wall_ends(description, merger, topology, spokes);
  add_curve_ends(description, merger, topology, spokes);
  if (!add_through_walls(description, index, topology, merger.points(), spokes))
    return Error{ErrorCode::too_large, "too many long walls lie on top of each other", "",
                 "split the scene, or leave walls out"};
  std::ranges::sort(spokes, {},
                    [](const Spoke& s) { return std::tuple(s.vertex, s.wall, s.direction.x, s.direction.y); });
  topology.walls_start.push_back(0);
  for (std::size_t i = 0; i < spokes.size();) {
    std::size_t end = i;
    for (; end < spokes.size() && spokes[end].vertex == spokes[i].vertex; ++end)
      if (spokes[end].wall != Topology::nowhere) topology.walls.push_back(spokes[end].wall);
    topology.walls_start.push_back(static_cast<std::uint32_t>(topology.walls.size()));
    topology.vertices.push_back(classify(merger.points()[spokes[i].vertex], std::span(spokes).subspan(i, end - i)));
    i = end;
  }
  return topology;
}

}  // namespace echoarc::sim
