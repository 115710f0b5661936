// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/followed_direction.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace echoarc::studies {
namespace {

/// The nearest place to `p` on the wall.
Vec2 on_wall(const WallSpan& wall, Vec2 p) {
  const Vec2 along = wall.end - wall.begin;
  const double share = std::clamp(dot(p - wall.begin, along) / squared_norm(along), 0.0, 1.0);
  return wall.begin + share * along;
}

/// Where the robot would be if it had driven beside the nearest wall exactly. The inside is on a wall's left.
Vec2 ideal_place(const std::vector<WallSpan>& walls, Vec2 p) {
  const auto nearest =
      std::ranges::min_element(walls, {}, [&](const WallSpan& wall) { return squared_norm(p - on_wall(wall, p)); });
  const Vec2 along = nearest->end - nearest->begin;
  return on_wall(*nearest, p) + (nearest->depth_m / norm(along)) * perpendicular(along);
}

Result<MapScore> directional_maximum(const Trial& trial) {
  const MethodSpec spec{.label = "DM",
                        .method = "dm",
                        .options = {{"doi", std::string("followed_wall")}, {"unvisited", std::string("keep")}}};
  const Result<std::vector<MethodResult>> results = run_methods(trial, {&spec, 1});
  if (!results) return results.error();
  return results->front().cells;
}

}  // namespace

Result<std::optional<DirectionScores>> score_directions(const Trial& trial) {
  const std::vector<WallSpan>& walls = trial.scoring().walls;
  const auto followed = [](const Reading& reading) { return reading.wall != WallSide::unknown; };
  if (walls.empty() || std::ranges::none_of(trial.readings, followed)) return std::optional<DirectionScores>();
  const Result<MapScore> as_driven = directional_maximum(trial);
  if (!as_driven) return as_driven.error();
  Trial ideal = trial;
  for (Reading& reading : ideal.readings)
    reading.T_world_robot.position = ideal_place(walls, reading.T_world_robot.position);
  const Result<MapScore> beside_walls = directional_maximum(ideal);
  if (!beside_walls) return beside_walls.error();
  return std::optional(DirectionScores{*as_driven, *beside_walls});
}

}  // namespace echoarc::studies
