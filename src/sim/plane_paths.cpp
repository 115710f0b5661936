// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/plane_paths.hpp"

#include <algorithm>

namespace echoarc::sim {
namespace {

/// Where a wall goes from an apex at one of its ends; the zero vector in its middle, from where it goes both ways.
Vec2 away_from(const Mirror& wall, Vec2 apex) {
  constexpr double end_m = 1e-6;
  const double along = dot(apex - wall.a, wall.direction);
  if (along <= end_m) return wall.direction;
  return along >= wall.length_m - end_m ? -wall.direction : Vec2{};
}

/// Whether sound that goes on in `direction` after the first wall can meet the second one, both reflections being in
/// their common apex. Moved a little aside it runs from a point of the first to a point of the second: in a concave
/// corner those are there, beyond a convex one the walls would have to be longer.
bool turns_in(Vec2 apex, const Mirror& first, const Mirror& second, Vec2 direction) {
  constexpr double slack = 1e-9;
  const Vec2 u = away_from(first, apex);
  const Vec2 v = away_from(second, apex);
  const double wedge = cross(u, v);
  if (wedge == 0.0) return true;
  const double scale = slack * norm(direction);
  const double on_first = cross(v, direction) / wedge;
  const double on_second = cross(u, direction) / wedge;
  return on_first >= -scale && on_second >= -scale;
}

}  // namespace

void PlaneSearch::run(PingSearch& ping) {
  last_walls_.clear();
  ping.for_each_lit(ping.listener_view(), [&](std::uint32_t item) {
    if (item < ping.world.index.first_chunk() && ping.world.mirrors[item].reflects(ping.listener.position))
      last_walls_.push_back(item);
  });
  listen(ping, ping.sender.position, 0);
  if (ping.limits.max_order < 2 || last_walls_.empty()) return;
  for (const View::Sector& sector : ping.sender_view().sectors()) reflect(ping, sector.beam, sector.lit, 0);
}

/// Everything that a beam lights mirrors it on.
void PlaneSearch::reflect(PingSearch& ping, const Beam& beam, const std::vector<Lit>& lit, std::size_t depth) {
  for (const Lit& one : lit) {
    if (one.item >= ping.world.index.first_chunk()) continue;
    const Mirror& mirror = ping.world.mirrors[one.item];
    if (depth > 0 && !ping.world.mirrors[walls_[depth - 1]].lights(mirror, beam.eye)) continue;
    if (!mirror.reflects(beam.eye)) continue;
    walls_[depth] = one.item;
    images_[depth] = mirror.image(beam.eye);
    listen(ping, images_[depth], depth + 1);
    if (static_cast<int>(depth) + 2 >= ping.limits.max_order || !ping.within_bounds()) continue;
    Level& level = levels_[depth];
    Beam next = reflected(beam, one.item, mirror, one.low, one.high);
    next.reach_m = ping.reach_m(next.eye);
    ping.sweep.sweep(next, level.depth, level.lit, ping.work);
    reflect(ping, next, level.lit, depth + 1);
  }
}

/// All walls that the listener may hear, as the last after `depth` reflections that made `source`.
void PlaneSearch::listen(PingSearch& ping, Vec2 source, std::size_t depth) {
  for (const std::uint32_t wall : last_walls_) {
    const Mirror& mirror = ping.world.mirrors[wall];
    if (depth > 0 && !ping.world.mirrors[walls_[depth - 1]].lights(mirror, source)) continue;
    if (!mirror.reflects(source)) continue;
    if (!ping.count_image()) return;
    walls_[depth] = wall;
    images_[depth] = mirror.image(source);
    follow_back(ping, depth + 1);
  }
}

/// From the listener back through the images; then forth, whether nothing stands in the way.
void PlaneSearch::follow_back(PingSearch& ping, std::size_t order) {
  const Vec2 ear = ping.listener.position;
  const double squared_length = squared_norm(images_[order - 1] - ear);
  if (squared_length > ping.limits.max_length_m * ping.limits.max_length_m) return;
  Vec2 target = ear;
  for (std::size_t k = order; k-- > 0;) {
    if (!ping.world.mirrors[walls_[k]].bounce(target, images_[k], bounces_[k])) return;
    target = bounces_[k];
  }
  for (std::size_t k = 1; k < order; ++k) {
    constexpr double one_point_m = 1e-7;
    const Vec2 apex = bounces_[k];
    if (squared_norm(apex - bounces_[k - 1]) > one_point_m * one_point_m) continue;
    const Mirror& first = ping.world.mirrors[walls_[k - 1]];
    if (!turns_in(apex, first, ping.world.mirrors[walls_[k]], apex - images_[k - 1])) return;
  }
  if (!ping.listener.hears(bounces_[order - 1]) || !ping.sender.hears(bounces_[0])) return;
  Vec2 from = ping.sender.position;
  for (std::size_t k = 0; k < order; ++k) {
    if (!ping.sees(from, bounces_[k])) return;
    from = bounces_[k];
  }
  // A single echo to where it came from goes back the way it came.
  if (!(order == 1 && ping.one_place) && !ping.sees(from, ear)) return;
  double loss_db = 0.0;
  for (std::size_t k = 0; k < order; ++k)
    loss_db += ping.world.loss_db(ping.world.description.walls[walls_[k]].material);
  ping.add(bounces_[0], bounces_[order - 1], std::sqrt(squared_length), -loss_db, cause(ping.world, order), order);
}

EchoCause PlaneSearch::cause(const WorldModel& world, std::size_t order) const {
  if (order == 1) return EchoCause::wall;
  for (std::size_t k = 1; k < order; ++k)
    if (!world.share_vertex(walls_[k - 1], walls_[k])) return EchoCause::multiple;
  return EchoCause::corner;
}

}  // namespace echoarc::sim
