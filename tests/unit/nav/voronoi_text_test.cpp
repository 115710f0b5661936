// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_text.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::nav {
namespace {

VoronoiGraph two_nodes() {
  VoronoiGraph graph;
  graph.add_node({{0.5, -1.25}, VoronoiNodeType::meet, 1.0, {degrees(90), degrees(-90), Angle{}}});
  graph.add_node({{0.5, 2.0}, VoronoiNodeType::boundary, 0.3, {degrees(-90)}});
  graph.add_edge(0, 2, 1, 0, {{0.5, 0.75}}, 0.3);
  graph.give_up(0, 0);
  return graph;
}

TEST(VoronoiText, Json) {
  EXPECT_EQ(to_json(two_nodes()),
            R"({"nodes":[
{"id":0,"place":[0.5,-1.25],"type":"meet","distance_m":1,"ways":[{"bearing_deg":-90,"edge":null,"given_up":true},)"
            R"({"bearing_deg":0,"edge":null,"given_up":false},{"bearing_deg":90,"edge":0,"given_up":false}]},
{"id":1,"place":[0.5,2],"type":"boundary","distance_m":0.3,"ways":[{"bearing_deg":-90,"edge":0,"given_up":false}]}],
"edges":[
{"id":0,"from":0,"to":1,"length_m":3.25,"min_clearance_m":0.3,"polyline":[[0.5,-1.25],[0.5,0.75],[0.5,2]]}]}
)");
}

TEST(VoronoiText, NumbersReadBackAsTheSameValues) {
  VoronoiGraph graph;
  graph.add_node({{0.1 + 0.2, 1e-17}, VoronoiNodeType::meet, 1.0 / 3.0, {}});
  const std::string all = to_json(graph);
  EXPECT_EQ(std::stod(all.substr(all.find("distance_m\":") + 12)), 1.0 / 3.0);
  EXPECT_EQ(std::stod(all.substr(all.find("place\":[") + 8)), 0.1 + 0.2);
}

TEST(VoronoiText, GraphMl) {
  const std::string text = to_graphml(two_nodes());
  EXPECT_EQ(
      text.rfind(
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">", 0),
      0u);
  EXPECT_NE(text.find("<graph id=\"voronoi\" edgedefault=\"undirected\">"), std::string::npos);
  EXPECT_NE(
      text.find(
          "<node id=\"n0\"><data key=\"x_m\">0.5</data><data key=\"y_m\">-1.25</data><data key=\"type\">meet</data>"
          "<data key=\"distance_m\">1</data><data key=\"ways\">-90:given_up 0:unexplored 90:e0</data></node>"),
      std::string::npos);
  EXPECT_NE(text.find("<edge id=\"e0\" source=\"n0\" target=\"n1\">"), std::string::npos);
  EXPECT_NE(text.find("<data key=\"polyline\">0.5,-1.25 0.5,0.75 0.5,2</data></edge>"), std::string::npos);
  EXPECT_TRUE(text.ends_with("  </graph>\n</graphml>\n"));
}

TEST(VoronoiText, EmptyGraphAndWhatIsNoNumber) {
  EXPECT_EQ(to_json(VoronoiGraph{}), "{\"nodes\":[],\n\"edges\":[]}\n");
  VoronoiGraph graph;
  graph.add_node({{0, 0}, VoronoiNodeType::pass, std::numeric_limits<double>::infinity(), {}});
  EXPECT_NE(to_json(graph).find("\"distance_m\":null"), std::string::npos);
  EXPECT_NE(to_graphml(graph).find("<data key=\"distance_m\">NaN</data>"), std::string::npos);
}

}  // namespace
}  // namespace echoarc::nav
