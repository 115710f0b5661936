// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_localisation.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/segment_voronoi.hpp"
#include "unit/nav/voronoi_world.hpp"

namespace echoarc::nav {
namespace {

VoronoiGraph t_graph() {
  std::vector<WallSegment> walls;
  for (const auto& wall : voronoi_world::t_world()) walls.push_back({wall.a, wall.b});
  return segment_voronoi(walls, Vec2{0, 5}).value();
}

struct Place {
  int node = 0;
  std::size_t way = 0;  // come by
};

/// Where an edge leads.
Place across(const VoronoiGraph& graph, int node, std::size_t way) {
  const VoronoiEdge& edge = graph.edges()[std::size_t(*graph.nodes()[std::size_t(node)].ways[way].edge)];
  const int far = edge.from == node ? edge.to : edge.from;
  const auto& ways = graph.nodes()[std::size_t(far)].ways;
  for (std::size_t w = 0; w < ways.size(); ++w)
    if (ways[w].edge == edge.id && !(far == node && w == way)) return {far, w};
  return {far, 0};
}

VoronoiLeg leg_of(const VoronoiGraph& graph, int from, std::size_t way, std::optional<std::size_t> come_by) {
  const Place to = across(graph, from, way);
  VoronoiLeg leg;
  leg.length_m = graph.edges()[std::size_t(*graph.nodes()[std::size_t(from)].ways[way].edge)].length_m;
  leg.degree = graph.nodes()[std::size_t(to.node)].degree();
  const int ways = graph.nodes()[std::size_t(from)].degree();
  if (come_by) leg.turned_by = ((int(way) - int(*come_by)) % ways + ways) % ways;
  return leg;
}

int node_near(const VoronoiGraph& graph, Vec2 place) {
  for (const VoronoiNode& node : graph.nodes())
    if (norm(node.place - place) < 0.1) return node.id;
  return -1;
}

/// Drives from a node by the ways nearest to some bearings.
VoronoiLocaliser after(const VoronoiGraph& graph, int node, const std::vector<double>& bearings_deg, bool with_turns) {
  VoronoiLocaliser localiser(graph);
  localiser.begin(graph.nodes()[std::size_t(node)].degree());
  std::optional<std::size_t> come_by;
  for (const double deg : bearings_deg) {
    const std::size_t way = *graph.way_towards(node, degrees(deg), degrees(5));
    localiser.drive(leg_of(graph, node, way, with_turns ? come_by : std::nullopt));
    const Place next = across(graph, node, way);
    node = next.node;
    come_by = next.way;
  }
  return localiser;
}

TEST(VoronoiLocalisation, OneDegreeAloneIsAmbiguous) {
  const VoronoiGraph graph = t_graph();
  VoronoiLocaliser localiser(graph);
  localiser.begin(3);
  const VoronoiPlace place = localiser.place();
  EXPECT_EQ(place.verdict, VoronoiVerdict::ambiguous);
  EXPECT_NE(place.reason.find("ambiguous"), std::string::npos);
  EXPECT_GE(place.candidates.size(), 3u);
}

TEST(VoronoiLocalisation, DrivingIntoTheNarrowCorridorIsUnique) {
  const VoronoiGraph graph = t_graph();
  const int left = node_near(graph, {-4, 5});
  const VoronoiPlace place = after(graph, left, {0, -90, -90}, false).place();
  ASSERT_EQ(place.verdict, VoronoiVerdict::sure) << place.reason;
  EXPECT_EQ(place.candidates[0].node, node_near(graph, {0, -3.55}));
}

TEST(VoronoiLocalisation, MirrorImagesAreToldApartByTheOrderOfWaysAlone) {
  const VoronoiGraph graph = t_graph();
  const int foot = node_near(graph, {0, 0.893});
  const std::vector<double> up_left_and_into_the_corner{90, 155, 135};
  const VoronoiPlace without = after(graph, foot, up_left_and_into_the_corner, false).place();
  EXPECT_EQ(without.verdict, VoronoiVerdict::ambiguous);
  ASSERT_GE(without.candidates.size(), 4u);  // four corners at the ends of the bar
  EXPECT_NEAR(without.candidates[0].probability, without.candidates[3].probability, 1e-6);
  const VoronoiPlace with = after(graph, foot, up_left_and_into_the_corner, true).place();
  ASSERT_EQ(with.verdict, VoronoiVerdict::ambiguous) << with.reason;
  EXPECT_EQ(with.candidates[0].node, node_near(graph, {-4.675, 5.675}));
  EXPECT_GT(with.candidates[0].probability, 5.0 * with.candidates[1].probability);
}

TEST(VoronoiLocalisation, WhatFitsNowhereIsSaid) {
  const VoronoiGraph graph = t_graph();
  VoronoiLocaliser localiser(graph);
  localiser.begin(3);
  localiser.drive({123.0, 3, {}});
  EXPECT_EQ(localiser.place().verdict, VoronoiVerdict::nowhere);
  localiser.drive({1.0, 3, {}});  // and stays said until it begins anew
  EXPECT_EQ(localiser.place().verdict, VoronoiVerdict::nowhere);
  localiser.begin(3);
  EXPECT_EQ(localiser.place().verdict, VoronoiVerdict::ambiguous);
}

TEST(VoronoiLocalisation, BadInput) {
  const VoronoiGraph empty;
  VoronoiLocaliser on_empty(empty);
  on_empty.begin(3);
  on_empty.drive({1.0, 3, {}});
  EXPECT_EQ(on_empty.place().verdict, VoronoiVerdict::nowhere);
  EXPECT_EQ(on_empty.place().reason, "the graph is empty");
  const VoronoiGraph graph = t_graph();
  VoronoiLocaliser localiser(graph);
  EXPECT_EQ(localiser.place().verdict, VoronoiVerdict::nowhere);  // before it begins
  localiser.begin(-5);
  localiser.drive({std::nan(""), 3, {}});
  EXPECT_EQ(localiser.place().verdict, VoronoiVerdict::nowhere);
}

/// Every sequence of nodes and ways by itself, weighed by the model as it is written.
void walk(const VoronoiGraph& graph, const std::vector<VoronoiLeg>& legs, std::size_t step, Place at, bool fresh,
          double weight, std::map<std::pair<int, std::size_t>, double>& sums) {
  if (step == legs.size()) {
    sums[{at.node, at.way}] += weight;
    return;
  }
  const VoronoiLocalisationOptions o;
  const VoronoiLeg& leg = legs[step];
  const auto& ways = graph.nodes()[std::size_t(at.node)].ways;
  const int n = int(ways.size());
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const Place to = across(graph, at.node, w);
    const double length_m = graph.edges()[std::size_t(*ways[w].edge)].length_m;
    const double off = (leg.length_m - length_m) / (o.length_deviation_m + o.length_deviation_share * length_m);
    double turn = 1.0 / n;
    if (leg.turned_by && !fresh && n > 1)
      turn = ((int(w) - int(at.way)) % n + n) % n == *leg.turned_by ? 1.0 - o.turn_error : o.turn_error / (n - 1);
    const int errors = std::abs(graph.nodes()[std::size_t(to.node)].degree() - leg.degree);
    const double degree = (1.0 - o.degree_error) * std::pow(o.degree_error, errors);
    walk(graph, legs, step + 1, to, false, weight * std::exp(-0.5 * off * off) * turn * degree, sums);
  }
}

RC_GTEST_PROP(VoronoiLocalisationProperty, EqualsTheSumOverAllWalks, (std::uint64_t seed)) {
  static const VoronoiGraph graph = t_graph();
  Rng rng(seed);
  Place at{int(rng.below(graph.nodes().size())), 0};
  const int first_degree = graph.nodes()[std::size_t(at.node)].degree();
  VoronoiLocaliser localiser(graph);
  localiser.begin(first_degree);
  std::vector<VoronoiLeg> legs;
  for (int k = 0; k < 3; ++k) {
    const auto way = std::size_t(rng.below(std::uint64_t(graph.nodes()[std::size_t(at.node)].degree())));
    VoronoiLeg leg = leg_of(graph, at.node, way, k > 0 && rng.below(2) == 0 ? std::optional(at.way) : std::nullopt);
    leg.length_m += rng.normal(0.0, 0.1);
    legs.push_back(leg);
    localiser.drive(leg);
    at = across(graph, at.node, way);
  }
  std::map<std::pair<int, std::size_t>, double> sums;
  for (const VoronoiNode& node : graph.nodes())
    walk(graph, legs, 0, {node.id, 0}, true, std::pow(0.1, std::abs(node.degree() - first_degree)), sums);
  double total = 0.0;
  for (const auto& [key, weight] : sums) total += weight;
  const VoronoiPlace place = localiser.place();
  double sum = 0.0;
  for (const VoronoiCandidate& c : place.candidates) {
    sum += c.probability;
    double expected = 0.0;
    for (const auto& [key, weight] : sums)
      if (key.first == c.node && graph.nodes()[std::size_t(c.node)].ways[key.second].edge == c.edge) expected += weight;
    RC_ASSERT(std::abs(c.probability - expected / total) < 1e-9);
  }
  RC_ASSERT(std::abs(sum - 1.0) < 1e-9);
}

}  // namespace
}  // namespace echoarc::nav
