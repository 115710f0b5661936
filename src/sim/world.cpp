// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/world.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "sim/world_model.hpp"

namespace echoarc::sim {

namespace {

constexpr double eye_m = 1e-9;
constexpr double leg_end_m = 1e-6;  // of a leg at either end, not looked at for obstacles

}  // namespace

Disc MovingDisc::at(double time_s) const {
  assert(!path.empty());
  const auto next = std::ranges::upper_bound(path, time_s, {}, &Station::time_s);
  Vec2 centre = path.back().centre;
  if (next == path.begin())
    centre = path.front().centre;
  else if (next != path.end()) {
    const Station& from = *(next - 1);
    const double share = (time_s - from.time_s) / (next->time_s - from.time_s);
    centre = from.centre + share * (next->centre - from.centre);
  }
  return {centre, radius_m, material, line};
}

MaterialId WorldModel::material_of(std::uint32_t item) const {
  if (item < index.first_chunk()) return description.walls[item].material;
  if (item < index.first_disc()) return description.curves[index.chunks()[item - index.first_chunk()].curve].material;
  return description.discs[item - index.first_disc()].material;
}

bool WorldModel::visible(Vec2 a, Vec2 b, std::span<const Disc> moving, std::uint64_t& work) const {
  const double length_m = norm(b - a);
  if (length_m <= 2.0 * leg_end_m) return true;
  const Ray ray{a, (b - a) / length_m, leg_end_m, length_m - leg_end_m};
  if (std::ranges::any_of(moving, [&](const Disc& disc) { return crossing(ray, disc) < never; })) return false;
  return !index.blocked(ray, work);
}

bool WorldModel::share_vertex(std::uint32_t wall, std::uint32_t other) const {
  const auto ends_on = [&](std::uint32_t w, std::uint32_t o) {
    return std::ranges::any_of(topology.ends_of_wall[w],
                               [&](std::uint32_t v) { return std::ranges::count(topology.walls_at(v), o) > 0; });
  };
  return ends_on(wall, other) || ends_on(other, wall);
}

World::World(std::unique_ptr<const WorldModel> model) : model_(std::move(model)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::make(WorldDescription description) {
  if (std::optional<Error> error = check_description(description)) return *std::move(error);
  auto model = std::make_unique<WorldModel>();
  model->description = std::move(description);
  model->index = SpatialIndex(model->description);
  Result<Topology> topology = find_vertices(model->description, model->index);
  if (!topology) return topology.error();
  model->topology = std::move(topology).value();
  Result<Bumps> bumps = place_bumps(model->description);
  if (!bumps) return bumps.error();
  model->bumps = std::move(bumps).value();
  for (const Wall& wall : model->description.walls) {
    model->mirrors.emplace_back(wall);
    model->has_one_sided = model->has_one_sided || wall.one_sided;
  }
  return World(std::move(model));
}

const WorldDescription& World::description() const {
  return model_->description;
}

std::span<const Vertex> World::vertices() const {
  return model_->topology.vertices;
}

std::span<const Scatterer> World::scatterers() const {
  return model_->bumps.points;
}

const WorldModel& World::model() const {
  return *model_;
}

std::vector<Disc> World::moving_at(double time_s) const {
  std::vector<Disc> discs;
  for (const MovingDisc& disc : model_->description.moving) discs.push_back(disc.at(time_s));
  return discs;
}

std::optional<RayHit> World::first_hit(Vec2 origin, Vec2 direction, double max_m, std::span<const Disc> moving) const {
  const Ray ray{origin, direction, eye_m, max_m};
  const SpatialIndex::Hit hit = model_->index.first_hit(ray);
  RayHit nearest{hit.t, hit.t < never ? model_->material_of(hit.item) : MaterialId{0}};
  for (const Disc& disc : moving)
    if (const double t = crossing(ray, disc); t < nearest.distance_m) nearest = {t, disc.material};
  if (nearest.distance_m == never) return {};
  return nearest;
}

bool World::visible(Vec2 a, Vec2 b, std::span<const Disc> moving) const {
  return model_->visible(a, b, moving);
}

double World::clearance(Vec2 point, double max_m, std::span<const Disc> moving) const {
  double nearest_m = model_->index.nearest(point, max_m);
  for (const Disc& disc : moving)
    nearest_m = std::min(nearest_m, std::max(0.0, norm(point - disc.centre) - disc.radius_m));
  return nearest_m;
}

}  // namespace echoarc::sim
