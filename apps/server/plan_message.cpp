// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/plan_message.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "server/json_values.hpp"

namespace echoarc::server {
namespace {

using Line = std::vector<Vec2>;

double to_millimetres(double value_m) {
  return std::round(value_m * 1e3) / 1e3;
}
Json place_of(Vec2 place) {
  return Json::array({to_millimetres(place.x), to_millimetres(place.y)});
}

Line finite_part(std::span<const Vec2> line) {
  Line finite;
  std::ranges::copy_if(line, std::back_inserter(finite), [](Vec2 place) { return is_finite(place); });
  return finite;
}

double distance_to_segment_m(Vec2 place, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double length2 = squared_norm(along);
  const double share = length2 > 0.0 ? std::clamp(dot(place - a, along) / length2, 0.0, 1.0) : 0.0;
  return norm(place - (a + share * along));
}

/// Whether all between `from` and `to` lie beside the straight line between the two.
bool is_straight(std::span<const Vec2> line, std::size_t from, std::size_t to, double tolerance_m) {
  for (std::size_t k = from + 1; k < to; ++k)
    if (distance_to_segment_m(line[k], line[from], line[to]) > tolerance_m) return false;
  return true;
}

/// Fewer points, none of those left out further than the tolerance from the line.
Line coarser(std::span<const Vec2> line, double tolerance_m) {
  constexpr std::size_t longest = 100;  // so that the work grows no faster than the line
  Line kept;
  for (std::size_t from = 0; from < line.size();) {
    kept.push_back(line[from]);
    std::size_t to = from + 1;
    while (to + 1 < line.size() && to - from < longest && is_straight(line, from, to + 1, tolerance_m)) ++to;
    from = to;
  }
  return kept;
}

std::size_t points_of(std::span<const Line> lines) {
  std::size_t points = 0;
  for (const Line& line : lines) points += line.size();
  return points;
}

/// As fine as fits. Returns how many lines do not fit at all.
std::size_t fit(std::vector<Line>& lines) {
  constexpr double fine_m = 0.01;
  constexpr double coarse_m = 0.5;
  for (double tolerance_m = fine_m; tolerance_m <= coarse_m; tolerance_m *= 2.0) {
    for (Line& line : lines) line = coarser(line, tolerance_m);
    if (points_of(lines) <= most_plan_points) return 0;
  }
  const std::size_t all = lines.size();
  while (points_of(lines) > most_plan_points) lines.resize(lines.size() / 2);
  return all - lines.size();
}

Json json_of_line(const Line& line) {
  Json places = Json::array();
  for (const Vec2 place : line) places.push_back(place_of(place));
  return places;
}

Json json_of_estimate(const std::optional<nav::Sketch::Spread>& estimate) {
  if (!estimate || !is_finite(estimate->T_world_axes) || !is_finite(estimate->deviation_m)) return {};
  return {{"pose", json_of(estimate->T_world_axes)}, {"deviation_m", json_of(estimate->deviation_m)}};
}

}  // namespace

std::string plan_message(std::string_view strategy, const nav::Sketch& sketch) {
  Json nodes = Json::array();
  std::size_t left_out = 0;
  for (const nav::Sketch::Node& node : sketch.nodes) {
    if (is_finite(node.place) && nodes.size() < most_plan_nodes)
      nodes.push_back({{"at", place_of(node.place)}, {"kind", node.kind}});
    else
      ++left_out;
  }
  std::vector<Line> lines;
  for (const Line& edge : sketch.edges)
    if (Line line = finite_part(edge); line.size() > 1) lines.push_back(std::move(line));
  left_out += fit(lines);
  std::vector<Line> path{finite_part(sketch.path)};
  left_out += fit(path);
  Json edges = Json::array();
  for (const Line& line : lines) edges.push_back(json_of_line(line));
  return text_of({{"type", "plan"},
                  {"strategy", strategy},
                  {"nodes", std::move(nodes)},
                  {"edges", std::move(edges)},
                  {"path", path.empty() ? Json::array() : json_of_line(path.front())},
                  {"estimate", json_of_estimate(sketch.estimate)},
                  {"left_out", left_out}});
}

std::string no_plan_message() {
  return plan_message("", {});
}

}  // namespace echoarc::server
