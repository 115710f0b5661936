// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace echoarc::nav {
namespace {

/// Shortest text that reads back as the same number, in any locale.
std::string text(double value, std::string_view no_number) {
  if (!std::isfinite(value)) return std::string(no_number);
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string json(double value) {
  return text(value, "null");
}

std::string json(Vec2 p) {
  return "[" + json(p.x) + "," + json(p.y) + "]";
}

std::string data(std::string_view key, std::string_view value) {
  std::string element = "<data key=\"";
  return element.append(key).append("\">").append(value).append("</data>");
}

std::string data(std::string_view key, double value) {
  return data(key, text(value, "NaN"));  // as XML Schema spells it
}

std::string ways_of(const VoronoiNode& node) {
  std::string list;
  for (const VoronoiWay& way : node.ways) {
    if (!list.empty()) list += ' ';
    list += text(way.bearing.deg(), "NaN") + ":";
    list += way.edge ? "e" + std::to_string(*way.edge) : way.given_up ? "given_up" : "unexplored";
  }
  return list;
}

std::string polyline_of(const VoronoiEdge& edge) {
  std::string list;
  for (const Vec2 p : edge.polyline) {
    if (!list.empty()) list += ' ';
    list += text(p.x, "NaN") + "," + text(p.y, "NaN");
  }
  return list;
}

constexpr std::string_view graphml_head =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
  <key id="x_m" for="node" attr.name="x_m" attr.type="double"/>
  <key id="y_m" for="node" attr.name="y_m" attr.type="double"/>
  <key id="type" for="node" attr.name="type" attr.type="string"/>
  <key id="distance_m" for="node" attr.name="distance_m" attr.type="double"/>
  <key id="ways" for="node" attr.name="ways" attr.type="string"/>
  <key id="length_m" for="edge" attr.name="length_m" attr.type="double"/>
  <key id="min_clearance_m" for="edge" attr.name="min_clearance_m" attr.type="double"/>
  <key id="polyline" for="edge" attr.name="polyline" attr.type="string"/>
  <graph id="voronoi" edgedefault="undirected">
)";

std::string json_of(const VoronoiNode& node) {
  std::string out = "{\"id\":" + std::to_string(node.id) + ",\"place\":" + json(node.place) + ",\"type\":\"";
  out.append(name(node.type)).append("\",\"distance_m\":").append(json(node.distance_m)).append(",\"ways\":[");
  for (std::size_t w = 0; w < node.ways.size(); ++w) {
    const VoronoiWay& way = node.ways[w];
    if (w > 0) out += ',';
    out += "{\"bearing_deg\":" + json(way.bearing.deg()) +
           ",\"edge\":" + (way.edge ? std::to_string(*way.edge) : "null") +
           ",\"given_up\":" + (way.given_up ? "true" : "false") + "}";
  }
  return out + "]}";
}

std::string json_of(const VoronoiEdge& edge) {
  std::string out = "{\"id\":" + std::to_string(edge.id) + ",\"from\":" + std::to_string(edge.from) +
                    ",\"to\":" + std::to_string(edge.to) + ",\"length_m\":" + json(edge.length_m) +
                    ",\"min_clearance_m\":" + json(edge.min_clearance_m) + ",\"polyline\":[";
  for (std::size_t i = 0; i < edge.polyline.size(); ++i) out += (i > 0 ? "," : "") + json(edge.polyline[i]);
  return out + "]}";
}

template <class T>
std::string json_list(const std::vector<T>& values) {
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i) out += (i > 0 ? ",\n" : "\n") + json_of(values[i]);
  return out + "]";
}

}  // namespace

std::string to_graphml(const VoronoiGraph& graph) {
  std::string out(graphml_head);
  for (const VoronoiNode& node : graph.nodes())
    out += "    <node id=\"n" + std::to_string(node.id) + "\">" + data("x_m", node.place.x) +
           data("y_m", node.place.y) + data("type", name(node.type)) + data("distance_m", node.distance_m) +
           data("ways", ways_of(node)) + "</node>\n";
  for (const VoronoiEdge& edge : graph.edges())
    out += "    <edge id=\"e" + std::to_string(edge.id) + "\" source=\"n" + std::to_string(edge.from) +
           "\" target=\"n" + std::to_string(edge.to) + "\">" + data("length_m", edge.length_m) +
           data("min_clearance_m", edge.min_clearance_m) + data("polyline", polyline_of(edge)) + "</edge>\n";
  return out + "  </graph>\n</graphml>\n";
}

std::string to_json(const VoronoiGraph& graph) {
  return "{\"nodes\":" + json_list(graph.nodes()) + ",\n\"edges\":" + json_list(graph.edges()) + "}\n";
}

}  // namespace echoarc::nav
