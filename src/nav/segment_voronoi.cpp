// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/segment_voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include <boost/polygon/voronoi.hpp>

#include "nav/voronoi_chains.hpp"
#include "nav/whole_segments.hpp"

namespace echoarc::nav {
namespace {

namespace polygon = boost::polygon;
using Diagram = polygon::voronoi_diagram<double>;

/// What a cell of the diagram is nearest to: a wall without its ends, or one end.
struct Site {
  Vec2 begin;
  Vec2 end;
  [[nodiscard]] bool is_point() const { return begin == end; }
  [[nodiscard]] Vec2 nearest(Vec2 p) const {
    const Vec2 along = end - begin;
    return is_point() ? begin : begin + std::clamp(dot(p - begin, along) / squared_norm(along), 0.0, 1.0) * along;
  }
};

Result<std::vector<WholeSegment>> whole_segments(std::span<const WallSegment> walls, double resolution_m) {
  constexpr double largest = 536'870'911.0;  // 2^29 - 1
  std::vector<WholeSegment> segments;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Vec2 a = walls[i].begin / resolution_m;
    const Vec2 b = walls[i].end / resolution_m;
    if (!(std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}) <= largest) || !is_finite(a) ||
        !is_finite(b))
      return Error{ErrorCode::bad_value, "an end of a wall is no number, or too far away", "wall " + std::to_string(i),
                   "give finite coordinates within 50 km"};
    const auto whole = [](Vec2 p) { return WholePoint{std::llround(p.x), std::llround(p.y)}; };
    segments.push_back({whole(a), whole(b)});
  }
  if (!split_at_crossings(segments))
    return Error{ErrorCode::unsupported, "the crossings of the walls cannot be told apart", "walls",
                 "give a finer resolution"};
  return segments;
}

/// The diagram's edges as lines of places with their clearance, cut where the graph ends.
class Pieces {
 public:
  Pieces(const std::vector<WholeSegment>& walls, const SegmentVoronoiOptions& options)
      : walls_(walls), options_(options) {}

  [[nodiscard]] std::vector<DiagramPiece> make() {
    polygon::voronoi_builder<std::int32_t> builder;
    for (const WholeSegment& w : walls_) {
      const auto x0 = std::int32_t(w.begin.x), y0 = std::int32_t(w.begin.y);
      if (w.begin == w.end)
        builder.insert_point(x0, y0);
      else
        builder.insert_segment(x0, y0, std::int32_t(w.end.x), std::int32_t(w.end.y));
    }
    Diagram diagram;
    builder.construct(&diagram);
    for (const auto& edge : diagram.edges())
      if (edge.is_primary() && edge.is_finite() && &edge < edge.twin()) add(edge);
    return std::move(pieces_);
  }
  [[nodiscard]] std::size_t vertices() const { return vertices_; }

 private:
  [[nodiscard]] Vec2 metres(double x, double y) const { return options_.resolution_m * Vec2{x, y}; }
  [[nodiscard]] Vec2 metres(WholePoint p) const { return metres(double(p.x), double(p.y)); }

  [[nodiscard]] Site site(const Diagram::cell_type& cell) const {
    const WholeSegment& wall = walls_[cell.source_index()];
    const bool at_begin = cell.source_category() != polygon::SOURCE_CATEGORY_SEGMENT_END_POINT;
    if (cell.contains_segment()) return {metres(wall.begin), metres(wall.end)};
    return at_begin ? Site{metres(wall.begin), metres(wall.begin)} : Site{metres(wall.end), metres(wall.end)};
  }

  std::size_t number(const Diagram::vertex_type* vertex) {
    const auto [it, fresh] = numbers_.try_emplace(vertex, vertices_);
    if (fresh) ++vertices_;
    return it->second;
  }

  /// Places along an edge, a straight line or the parabola between a point and a wall.
  [[nodiscard]] std::vector<Vec2> places(Vec2 from, Vec2 to, const Site& a, const Site& b) const {
    const int steps = std::clamp(int(std::ceil(norm(to - from) / options_.spacing_m)), 1, 100'000);
    const Site& wall = a.is_point() ? b : a;
    const Vec2 focus = a.is_point() ? a.begin : b.begin;
    const bool curved = a.is_point() != b.is_point();
    const Vec2 along = curved ? (wall.end - wall.begin) / norm(wall.end - wall.begin) : Vec2{};
    const double height = curved ? cross(along, focus - wall.begin) : 0.0;  // of the focus above the wall
    std::vector<Vec2> line{from};
    for (int i = 1; i < steps; ++i) {
      Vec2 p = from + (double(i) / double(steps)) * (to - from);
      if (std::abs(height) > options_.resolution_m) {
        const double t = dot(p - focus, along);
        const Vec2 foot = wall.begin + dot(p - wall.begin, along) * along;
        p = foot + ((t * t + height * height) / (2.0 * height)) * perpendicular(along);
      }
      line.push_back(p);
    }
    line.push_back(to);
    return line;
  }

  void add(const Diagram::edge_type& edge) {
    const Site a = site(*edge.cell());
    const Site b = site(*edge.twin()->cell());
    const Vec2 from = metres(edge.vertex0()->x(), edge.vertex0()->y());
    const Vec2 to = metres(edge.vertex1()->x(), edge.vertex1()->y());
    const auto clear = [&](Vec2 p) { return ClearPlace{p, norm(p - a.nearest(p))}; };
    const auto belongs = [&](Vec2 p) {
      const Vec2 to_a = a.nearest(p) - p;
      const Vec2 to_b = b.nearest(p) - p;
      return norm(to_a) >= options_.min_clearance_m &&
             abs(radians(std::atan2(cross(to_a, to_b), dot(to_a, to_b)))) >= options_.separation;
    };
    const std::vector<Vec2> line = places(from, to, a, b);
    DiagramPiece piece{number(edge.vertex0()), 0, {}};
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool in = belongs(line[i]);
      if (i > 0 && in != belongs(line[i - 1])) {
        const Vec2 end = border(line[i - 1], line[i], belongs);
        piece.line.push_back(clear(end));
        if (in)
          piece.from = vertices_++;
        else
          close(piece, vertices_++);
      }
      if (in) piece.line.push_back(clear(line[i]));
    }
    if (!piece.line.empty()) close(piece, number(edge.vertex1()));
  }

  /// Between two neighbouring places, one of which belongs to the graph: where it ends.
  template <class Belongs>
  static Vec2 border(Vec2 a, Vec2 b, const Belongs& belongs) {
    const bool a_belongs = belongs(a);
    for (int i = 0; i < 30; ++i) {
      const Vec2 middle = 0.5 * (a + b);
      (belongs(middle) == a_belongs ? a : b) = middle;
    }
    return 0.5 * (a + b);
  }

  void close(DiagramPiece& piece, std::size_t vertex) {
    piece.to = vertex;
    if (piece.line.size() > 1) pieces_.push_back(piece);
    piece.line.clear();
  }

  const std::vector<WholeSegment>& walls_;
  const SegmentVoronoiOptions& options_;
  std::unordered_map<const Diagram::vertex_type*, std::size_t> numbers_;
  std::size_t vertices_ = 0;
  std::vector<DiagramPiece> pieces_;
};

}  // namespace

Result<VoronoiGraph> segment_voronoi(std::span<const WallSegment> walls, std::optional<Vec2> inside,
                                     const SegmentVoronoiOptions& options) {
  const Result<std::vector<WholeSegment>> segments = whole_segments(walls, options.resolution_m);
  if (!segments) return segments.error();
  Pieces pieces(*segments, options);
  std::vector<DiagramPiece> made = pieces.make();
  return join_pieces(std::move(made), pieces.vertices(), options.merge_m, inside);
}

}  // namespace echoarc::nav
