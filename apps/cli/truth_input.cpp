// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/truth_input.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/eval_input.hpp"
#include "cli/scene_input.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/sim/world.hpp"
#include "echoarc/studies/scene_reference.hpp"

namespace echoarc::cli {
namespace {

constexpr double surface_spacing_m = 0.002;
constexpr double eye_spacing_m = 0.02;

bool names_scene(const std::filesystem::path& path) {
  return path.extension() == ".toml" || (!std::filesystem::exists(path) && io::builtin_scene(path.string()));
}

/// Positions of a path so far apart that each shows something new.
std::vector<Vec2> eyes_along(const PointSet& path) {
  std::vector<Vec2> eyes;
  for (const Vec2 p : path.points())
    if (eyes.empty() || norm(p - eyes.back()) >= eye_spacing_m) eyes.push_back(p);
  return eyes;
}

Result<Truth> scene_truth(const std::string& name, const PointSet& path) {
  const Result<io::SceneFile> file = load_scene(name);
  if (!file) return file.error();
  const Result<sim::World> world = sim::World::make(file->scene.world);
  if (!world) return world.error();
  std::vector<Vec2> points = studies::surface_points(world->description(), surface_spacing_m);
  if (!path.empty()) points = studies::visible_points(*world, points, eyes_along(path));
  Result<PointSet> surfaces = PointSet::make(std::move(points));
  if (!surfaces) return surfaces.error();
  if (surfaces->empty())
    return Error{ErrorCode::bad_value, "none of its surfaces is visible from the robot's path", name,
                 "give the scene that the maps' log was simulated in"};
  Truth truth{{std::move(*surfaces), surface_spacing_m, name + ", surfaces visible from the path"}, std::nullopt};
  if (!file->scoring) return truth;
  DirectionSet directions = studies::scene_directions(*file->scoring);
  if (!directions.families.empty() || !directions.fans.empty()) truth.directions = std::move(directions);
  return truth;
}

}  // namespace

Result<Truth> load_truth(const LogArguments& arguments, const PointSet& path) {
  if (names_scene(arguments.log)) return scene_truth(arguments.log.string(), path);
  Result<Reference> reference = load_reference(arguments);
  if (!reference) return reference.error();
  return Truth{std::move(*reference), std::nullopt};
}

}  // namespace echoarc::cli
