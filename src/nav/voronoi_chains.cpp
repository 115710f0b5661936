// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "nav/voronoi_chains.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace echoarc::nav {
namespace {

using Line = std::vector<ClearPlace>;

double length_m(const Line& line) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum_m += norm(line[i].place - line[i - 1].place);
  return sum_m;
}

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Vertices joined by short pieces become one; the pieces vanish.
void contract(std::vector<DiagramPiece>& pieces, std::size_t vertices, double merge_m) {
  std::vector<std::size_t> parent(vertices);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto is_short = [&](const DiagramPiece& p) { return length_m(p.line) <= merge_m; };
  for (const DiagramPiece& p : pieces)
    if (is_short(p)) parent[root(parent, p.to)] = root(parent, p.from);
  std::erase_if(pieces, is_short);
  for (DiagramPiece& p : pieces) {
    p.from = root(parent, p.from);
    p.to = root(parent, p.to);
  }
}

void keep_part_around(std::vector<DiagramPiece>& pieces, std::size_t vertices, Vec2 inside) {
  std::vector<std::size_t> parent(vertices);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t kept = 0;
  for (const DiagramPiece& p : pieces) parent[root(parent, p.to)] = root(parent, p.from);
  for (const DiagramPiece& p : pieces) {
    for (const ClearPlace& c : p.line) {
      // What is nearer than the walls are lies on this side of them.
      const double beyond = norm(c.place - inside) - c.clearance_m;
      if (beyond < nearest) nearest = beyond, kept = root(parent, p.from);
    }
  }
  std::erase_if(pieces, [&](const DiagramPiece& p) { return root(parent, p.from) != kept; });
}

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// One end of a piece.
struct End {
  std::size_t piece = 0;
  bool at_begin = true;
};

class Joiner {
 public:
  Joiner(std::vector<DiagramPiece> pieces, std::size_t vertices) : pieces_(std::move(pieces)), ends_(vertices) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      ends_[pieces_[i].from].push_back({i, true});
      ends_[pieces_[i].to].push_back({i, false});
    }
  }

  VoronoiGraph join() {
    used_.assign(pieces_.size(), false);
    for (std::size_t v = 0; v < ends_.size(); ++v)
      if (!ends_[v].empty() && ends_[v].size() != 2)
        for (const End& end : ends_[v])
          if (!used_[end.piece]) chains_.push_back(follow(v, end));
    for (std::size_t i = 0; i < pieces_.size(); ++i)  // what is left are circles
      if (!used_[i]) chains_.push_back(follow(pieces_[i].from, {i, true}));
    return graph();
  }

 private:
  /// Along pieces from vertex to vertex as long as just one other piece goes on, at most back to the first.
  DiagramPiece follow(std::size_t vertex, End end) {
    DiagramPiece chain{vertex, vertex, {}};
    for (;;) {
      const DiagramPiece& piece = pieces_[end.piece];
      used_[end.piece] = true;
      Line line = piece.line;
      if (!end.at_begin) std::reverse(line.begin(), line.end());
      chain.line.insert(chain.line.end(), line.begin() + (chain.line.empty() ? 0 : 1), line.end());
      chain.to = end.at_begin ? piece.to : piece.from;
      if (ends_[chain.to].size() != 2 || chain.to == chain.from) return chain;
      const auto& both = ends_[chain.to];
      const End next = both[both[0].piece == end.piece && both[0].at_begin != end.at_begin ? 1 : 0];
      if (used_[next.piece]) return chain;
      end = next;
    }
  }

  /// The bearing in which a chain leaves one of its ends, over a decimetre or two of it.
  static Angle leaving(const Line& line, bool at_begin) {
    constexpr double look_m = 0.15;
    const std::size_t n = line.size();
    const Vec2 start = line[at_begin ? 0 : n - 1].place;
    Vec2 to = start;
    for (std::size_t i = 1; i < n && norm(to - start) < look_m; ++i) to = line[at_begin ? i : n - 1 - i].place;
    return bearing(to - start);
  }

  VoronoiGraph graph() {
    std::map<std::size_t, NodeSight> sights;
    for (const DiagramPiece& chain : chains_) {
      for (const bool at_begin : {true, false}) {
        const ClearPlace& end = at_begin ? chain.line.front() : chain.line.back();
        NodeSight& sight = sights[at_begin ? chain.from : chain.to];
        if (sight.ways.empty()) sight.place = end.place, sight.distance_m = end.clearance_m;
        sight.ways.push_back(leaving(chain.line, at_begin));
      }
    }
    VoronoiGraph graph;
    std::map<std::size_t, int> ids;
    for (auto& [vertex, sight] : sights) {
      const std::size_t degree = sight.ways.size();
      sight.type = degree == 1   ? VoronoiNodeType::boundary
                   : degree == 2 ? VoronoiNodeType::pass
                                 : VoronoiNodeType::meet;
      ids[vertex] = graph.add_node(sight);
    }
    for (const DiagramPiece& chain : chains_) add_edge(graph, chain, ids[chain.from], ids[chain.to]);
    return graph;
  }

  /// The way of a node that has this very bearing, no edge yet, and is not `other`.
  static std::size_t free_way(const VoronoiGraph& graph, int node, Angle bearing, std::size_t other) {
    const std::vector<VoronoiWay>& ways = graph.nodes()[std::size_t(node)].ways;
    std::size_t w = 0;
    while (w + 1 < ways.size() && (ways[w].edge || ways[w].bearing != bearing || w == other)) ++w;
    return w;
  }

  static void add_edge(VoronoiGraph& graph, const DiagramPiece& chain, int from, int to) {
    std::vector<Vec2> polyline;
    double least_m = std::numeric_limits<double>::infinity();
    for (const ClearPlace& c : chain.line) {
      polyline.push_back(c.place);
      least_m = std::min(least_m, c.clearance_m);
    }
    const std::size_t from_way = free_way(graph, from, wrap(leaving(chain.line, true)), none);
    const std::size_t other = from == to ? from_way : none;
    const std::size_t to_way = free_way(graph, to, wrap(leaving(chain.line, false)), other);
    graph.add_edge(from, from_way, to, to_way, std::move(polyline), least_m);
  }

  std::vector<DiagramPiece> pieces_;
  std::vector<std::vector<End>> ends_;  // by vertex
  std::vector<bool> used_;
  std::vector<DiagramPiece> chains_;
};

}  // namespace

VoronoiGraph join_pieces(std::vector<DiagramPiece> pieces, std::size_t vertices, double merge_m,
                         std::optional<Vec2> inside) {
  contract(pieces, vertices, merge_m);
  if (inside && is_finite(*inside)) keep_part_around(pieces, vertices, *inside);
  return Joiner(std::move(pieces), vertices).join();
}

}  // namespace echoarc::nav
