// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/world_lines.hpp"

#include <string>
#include <utility>

namespace echoarc::io {
namespace {

std::vector<Vec2> circle(Vec2 centre, double radius_m) {
  constexpr int corners = 72;
  std::vector<Vec2> outline;
  for (int k = 0; k <= corners; ++k) outline.push_back(centre + radius_m * unit(degrees(360.0 * k / corners)));
  return outline;
}

}  // namespace

Polylines surfaces_of(const sim::WorldDescription& world) {
  Polylines lines;
  for (const sim::Wall& wall : world.walls) lines.push_back({wall.a, wall.b});
  for (const sim::Disc& disc : world.discs) lines.push_back(circle(disc.centre, disc.radius_m));
  for (const sim::SmoothCurve& curve : world.curves) lines.push_back(curve.points);
  return lines;
}

Polylines movers_of(const sim::WorldDescription& world) {
  Polylines lines;
  for (const sim::MovingDisc& disc : world.moving) {
    if (disc.path.empty()) continue;
    lines.push_back(circle(disc.path.front().centre, disc.radius_m));
    lines.push_back(circle(disc.path.back().centre, disc.radius_m));
    std::vector<Vec2> way;
    for (const sim::MovingDisc::Station& station : disc.path) way.push_back(station.centre);
    lines.push_back(std::move(way));
  }
  return lines;
}

std::string title_of(const sim::Scene& scene) {
  std::string title = scene.title.empty() ? scene.name : scene.title;
  std::erase_if(title, [](char letter) { return letter < ' ' || letter > '~'; });
  return title;
}

}  // namespace echoarc::io
