// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "echoarc/nav/voronoi_graph.hpp"

namespace echoarc::nav {
namespace {

/// A place on an edge.
struct Foot {
  const VoronoiEdge* edge = nullptr;
  std::size_t segment = 0;  ///< between its vertices `segment` and `segment + 1`
  Vec2 place;
  double along_m = 0.0;  ///< from the edge's begin
  double apart_m = 0.0;  ///< from what looks for it
};

Vec2 nearest_on(Vec2 a, Vec2 b, Vec2 p) {
  const double squared = squared_norm(b - a);
  return squared > 0.0 ? a + std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) * (b - a) : a;
}

std::vector<Foot> feet_of(const std::vector<VoronoiEdge>& edges, Vec2 place) {
  std::vector<Foot> feet;
  for (const VoronoiEdge& edge : edges) {
    double along_m = 0.0;
    for (std::size_t i = 0; i + 1 < edge.polyline.size(); ++i) {
      const Vec2 foot = nearest_on(edge.polyline[i], edge.polyline[i + 1], place);
      feet.push_back({&edge, i, foot, along_m + norm(foot - edge.polyline[i]), norm(foot - place)});
      along_m += norm(edge.polyline[i + 1] - edge.polyline[i]);
    }
  }
  std::stable_sort(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) { return a.apart_m < b.apart_m; });
  return feet;
}

Result<Foot> foot_of(const std::vector<VoronoiEdge>& edges, Vec2 place, const FreeLine& free, std::string_view which) {
  for (const Foot& foot : feet_of(edges, place))
    if (!free || free(place, foot.place)) return foot;
  return Error{ErrorCode::not_found, "no free line leads from the " + std::string(which) + " to the graph",
               std::string(which), "choose a place from which an edge of the graph can be seen"};
}

/// The part of an edge's polyline between a foot and one of its ends, from the foot.
std::vector<Vec2> to_end(const Foot& foot, bool to_begin) {
  const std::vector<Vec2>& line = foot.edge->polyline;
  const auto split = line.begin() + std::ptrdiff_t(foot.segment) + 1;
  std::vector<Vec2> part{foot.place};
  if (to_begin)
    part.insert(part.end(), std::make_reverse_iterator(split), line.rend());
  else
    part.insert(part.end(), split, line.end());
  return part;
}

std::vector<Vec2> between(Foot from, Foot to) {
  const bool backwards = from.along_m > to.along_m;
  if (backwards) std::swap(from, to);
  const std::vector<Vec2>& line = from.edge->polyline;
  std::vector<Vec2> part{from.place};
  for (std::size_t i = from.segment + 1; i <= to.segment; ++i) part.push_back(line[i]);
  part.push_back(to.place);
  if (backwards) std::reverse(part.begin(), part.end());
  return part;
}

/// Along the graph from foot to foot; empty if they are not connected.
std::vector<Vec2> along_graph(const VoronoiGraph& graph, const Foot& from, const Foot& to) {
  std::vector<Vec2> best;
  double best_m = std::numeric_limits<double>::infinity();
  if (from.edge == to.edge) {
    best = between(from, to);
    best_m = polyline_length_m(best);
  }
  for (const bool start_at_begin : {true, false}) {
    for (const bool end_at_begin : {true, false}) {
      const auto path = graph.shortest_path(start_at_begin ? from.edge->from : from.edge->to,
                                            end_at_begin ? to.edge->from : to.edge->to);
      if (!path) continue;
      std::vector<Vec2> line = to_end(from, start_at_begin);
      const std::vector<Vec2> middle = graph.polyline(*path);
      std::vector<Vec2> last = to_end(to, end_at_begin);
      line.insert(line.end(), middle.begin() + 1, middle.end());
      line.insert(line.end(), last.rbegin() + 1, last.rend());
      const double length_m = polyline_length_m(line);
      if (length_m < best_m) best = std::move(line), best_m = length_m;
    }
  }
  return best;
}

}  // namespace

Result<GraphWay> VoronoiGraph::plan(Vec2 start, Vec2 goal, const FreeLine& free) const {
  if (!is_finite(start) || !is_finite(goal))
    return Error{ErrorCode::bad_value, "start or goal is not a number", "plan", "give finite coordinates"};
  if (edges_.empty()) return Error{ErrorCode::not_found, "the graph has no edge yet", "plan", "explore first"};
  const Result<Foot> access = foot_of(edges_, start, free, "start");
  if (!access) return access.error();
  const Result<Foot> depart = foot_of(edges_, goal, free, "goal");
  if (!depart) return depart.error();
  const std::vector<Vec2> along = along_graph(*this, *access, *depart);
  if (along.empty())
    return Error{ErrorCode::not_found, "the graph does not connect start and goal", "plan",
                 "explore further, or choose places on one part of the graph"};
  GraphWay way;
  way.path.push_back(start);
  way.path.insert(way.path.end(), along.begin(), along.end());
  way.path.push_back(goal);
  way.length_m = polyline_length_m(way.path);
  way.access_index = 1;
  way.depart_index = way.path.size() - 2;
  return way;
}

}  // namespace echoarc::nav
