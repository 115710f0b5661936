// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/ping_search.hpp"

namespace echoarc::sim {

namespace {

void echo(PingSearch& ping, const Scatterer& bump) {
  const Vec2 from = ping.sender.position;
  const Vec2 to = ping.listener.position;
  if (!bump.echoes_to(from) || !bump.echoes_to(to)) return;
  if (!ping.sender.hears(bump.point) || !ping.sender_view().may_see(bump.point)) return;
  if (!ping.one_place && !(ping.listener.hears(bump.point) && ping.listener_view().may_see(bump.point))) return;
  const double length_m = norm(bump.point - from) + norm(bump.point - to);
  if (length_m > ping.limits.max_length_m) return;
  if (ping.sees(from, bump.point) && (ping.one_place || ping.sees(bump.point, to)))
    ping.add(bump.point, bump.point, length_m, bump.gain_db, EchoCause::scatterer, 1);
}

/// Where a line of sight meets the line of a wall, as a distance from its start; none if it runs almost along it.
std::optional<double> place_on(const Mirror& wall, const Beam& beam, double slope) {
  const Vec2 sight = beam.forward + slope * beam.aside;
  const double climb = cross(wall.direction, sight);
  const double z = cross(wall.direction, wall.a - beam.eye) / climb;
  if (std::abs(climb) < 0.05 || z < 0.0) return {};
  return cross(beam.eye - wall.a, sight) / climb;
}

/// The run of a wall's bumps that may lie between the slopes of its lit part.
std::span<const Scatterer> lit_bumps(std::span<const Scatterer> bumps, const Mirror& wall, double pitch_m,
                                     const Beam& beam, const Lit& lit) {
  const std::optional<double> one = place_on(wall, beam, lit.low);
  const std::optional<double> other = place_on(wall, beam, lit.high);
  if (!one || !other || bumps.empty()) return bumps;
  const double spare_m =
      0.15 + 2.0 * pitch_m;  // bumps stand 5 mm beside the wall, seen at a slant, and off their places
  const auto count = static_cast<double>(bumps.size());
  const auto first = static_cast<std::size_t>(std::clamp((std::min(*one, *other) - spare_m) / pitch_m, 0.0, count));
  const auto last = static_cast<std::size_t>(std::clamp((std::max(*one, *other) + spare_m) / pitch_m, 0.0, count));
  return bumps.subspan(first, last - first);
}

void echo_of_wall(PingSearch& ping, const Beam& beam, const Lit& lit) {
  const Mirror& wall = ping.world.mirrors[lit.item];
  if (!wall.reflects(ping.sender.position)) return;
  const bool right = wall.side(ping.sender.position) < 0.0;
  const double pitch_m = ping.world.description.materials[ping.world.material_of(lit.item)].rough_pitch_m;
  for (const Scatterer& bump : lit_bumps(ping.world.bumps.of(lit.item, right), wall, pitch_m, beam, lit))
    echo(ping, bump);
}

}  // namespace

void find_bump_paths(PingSearch& ping) {
  if (ping.world.bumps.points.empty()) return;
  const SpatialIndex& index = ping.world.index;
  for (const View::Sector& sector : ping.sender_view().sectors())
    for (const Lit& lit : sector.lit)
      if (lit.item < index.first_chunk() && index.segments()[lit.item].rough) echo_of_wall(ping, sector.beam, lit);
  ping.curve_marks.forget();
  ping.for_each_lit(ping.sender_view(), [&](std::uint32_t item) {
    if (item < index.first_chunk() || item >= index.first_disc()) return;
    const std::uint32_t curve = index.chunks()[item - index.first_chunk()].curve;
    if (!ping.curve_marks.mark(curve)) return;
    for (const bool right : {false, true})
      for (const Scatterer& bump : ping.world.bumps.of(ping.world.mirrors.size() + curve, right)) echo(ping, bump);
  });
}

}  // namespace echoarc::sim
