// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/passability.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace echoarc {
namespace {

std::vector<Vec2> local_points(std::span<const Vec2> points, const Strip& strip) {
  std::vector<Vec2> inside;
  for (const Vec2 point : points)
    if (const auto local = strip.local(point)) inside.push_back(*local);
  return inside;
}

}  // namespace

std::optional<Vec2> Strip::local(Vec2 point) const {
  const double length = length_m();
  assert(length > 0.0);
  const Vec2 along = (b - a) / length;
  const Vec2 local{dot(point - a, along), cross(along, point - a)};
  const bool inside = local.x >= 0.0 && local.x <= length && local.y >= -right_m && local.y <= left_m;
  return inside ? std::optional(local) : std::nullopt;
}

Gap widest_gap(std::span<const Vec2> points, const Strip& strip) {
  std::vector<double> stops;
  for (const Vec2 local : local_points(points, strip)) stops.push_back(local.x);
  stops.push_back(strip.length_m());
  std::sort(stops.begin(), stops.end());
  Gap widest;
  double begin = 0.0;
  for (const double stop : stops) {
    if (stop - begin > widest.width_m()) widest = {begin, stop};
    begin = stop;
  }
  return widest;
}

std::size_t count_points(std::span<const Vec2> points, const Strip& strip) {
  return std::size_t(std::count_if(points.begin(), points.end(), [&](Vec2 p) { return strip.local(p).has_value(); }));
}

// Prim's algorithm with the longest step so far in place of the sum: points are settled in the order in which a flood
// from the left side reaches them.
double passage_width_m(std::span<const Vec2> points, const Strip& strip) {
  const std::vector<Vec2> inside = local_points(points, strip);
  std::vector<double> reach;
  for (const Vec2 p : inside) reach.push_back(strip.left_m - p.y);
  std::vector<bool> settled(inside.size(), false);
  double width = strip.left_m + strip.right_m;
  for (std::size_t round = 0; round < inside.size(); ++round) {
    std::size_t next = inside.size();
    for (std::size_t k = 0; k < inside.size(); ++k)
      if (!settled[k] && (next == inside.size() || reach[k] < reach[next])) next = k;
    settled[next] = true;
    width = std::min(width, std::max(reach[next], inside[next].y + strip.right_m));
    for (std::size_t k = 0; k < inside.size(); ++k)
      reach[k] = std::min(reach[k], std::max(reach[next], norm(inside[k] - inside[next])));
  }
  return width;
}

double centerline_opening_m(double opening_m, double distance_m, Angle beam_width) {
  return opening_m - 2.0 * distance_m * tan(0.5 * beam_width);
}

}  // namespace echoarc
