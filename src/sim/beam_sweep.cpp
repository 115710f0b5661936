// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/beam_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace echoarc::sim {

namespace {

constexpr double touch_m = 1e-9;
constexpr double edge_on = 1e-12;      // slopes closer than this: the wall shows its end
constexpr double bump_reach_m = 0.01;  // bumps stand out by at most half of this

/// The part of a wall before the eye and before the beam's mirror; none if there is no such part.
std::optional<Sight> sight_of(const Beam& beam, const Segment& wall) {
  Vec2 a = wall.a - beam.eye;
  Vec2 b = a + wall.along;
  const auto keep = [&](double height_a,
                        double height_b) {  // the part where the height, linear along the wall, is not negative
    if (height_a < 0.0 && height_b < 0.0) return false;
    if (height_a < 0.0)
      a = a + height_a / (height_a - height_b) * (b - a);
    else if (height_b < 0.0)
      b = b + height_b / (height_b - height_a) * (a - b);
    return true;
  };
  if (beam.mirror != Beam::none) {
    const Vec2 on_mirror = beam.mirror_point - beam.eye;
    const double height_a = dot(a - on_mirror, beam.mirror_normal);
    const double height_b = dot(b - on_mirror, beam.mirror_normal);
    if (std::max(height_a, height_b) <= touch_m) return {};  // behind the mirror, or lies on it
    keep(height_a + touch_m, height_b + touch_m);
  }
  if (!keep(dot(a, beam.forward) - touch_m, dot(b, beam.forward) - touch_m)) return {};
  const double za = std::max(touch_m, dot(a, beam.forward));
  const double zb = std::max(touch_m, dot(b, beam.forward));
  const double ua = dot(a, beam.aside) / za;
  const double ub = dot(b, beam.aside) / zb;
  if (std::abs(ua - ub) <= edge_on) return Sight{ua, std::min(za, zb), ua, std::min(za, zb)};
  return ua < ub ? Sight{ua, za, ub, zb} : Sight{ub, zb, ua, za};
}

/// The part of a sight between the beam's slopes, which it meets.
Sight within(const Sight& s, const Beam& beam) {
  if (s.u2 - s.u1 <= edge_on) return s;
  const double rise = (1.0 / s.z2 - 1.0 / s.z1) / (s.u2 - s.u1);
  Sight part = s;
  if (s.u1 < beam.low) part = {beam.low, 1.0 / (1.0 / s.z1 + rise * (beam.low - s.u1)), part.u2, part.z2};
  if (s.u2 > beam.high) part = {part.u1, part.z1, beam.high, 1.0 / (1.0 / s.z2 - rise * (s.u2 - beam.high))};
  return part;
}

/// A rough wall's bumps stand beside the wall and before it: wider, nearer, and not quite hidden by what hides the
/// wall.
BeamSweep::Found bumpy(const Beam& beam, std::uint32_t item, const std::optional<Sight>& wall) {
  const double nearest_m = wall ? std::min(wall->z1, wall->z2) - bump_reach_m : 0.0;
  if (nearest_m <= bump_reach_m) return {item, {beam.low, touch_m, beam.high, touch_m}, 0.0};
  const double reach = bump_reach_m * (1.0 + std::max(std::abs(wall->u1), std::abs(wall->u2))) / nearest_m;
  return {item, {wall->u1 - reach, nearest_m, wall->u2 + reach, nearest_m}, 2.0 * bump_reach_m};
}

/// Whether bumps of a wall behind the eye may stand before it.
bool reaches_before(const Beam& beam, const Segment& wall) {
  const double z = dot(wall.a - beam.eye, beam.forward);
  return std::max(z, z + dot(wall.along, beam.forward)) > -bump_reach_m;
}

/// Distance along the columns' axis at which a reflected beam leaves its mirror; 0 for others.
double start_of(const Beam& beam, double major_low, double major_high) {
  if (beam.mirror == Beam::none) return 0.0;
  const double behind_m = dot(beam.mirror_point - beam.eye, beam.mirror_normal);
  double start = never;
  for (const auto& [slope, major] : {std::pair(beam.low, major_low), std::pair(beam.high, major_high)}) {
    const double climb = dot(beam.forward + slope * beam.aside, beam.mirror_normal);
    start = std::min(start, climb > 0.0 ? behind_m / climb * major : 0.0);
  }
  return std::max(0.0, start - touch_m);
}

/// Calls `visit(cell)` for the cells of a beam, column by column from near to far along the world's axis nearest to the
/// beam's own, until `depth` closes.
template <class Visit>
void walk_beam(const SpatialIndex& index, const Beam& beam, const BeamDepth& depth, const Visit& visit) {
  const bool by_x = std::abs(beam.forward.x) >= std::abs(beam.forward.y);
  const auto major = [by_x](Vec2 v) { return by_x ? v.x : v.y; };
  const auto minor = [by_x](Vec2 v) { return by_x ? v.y : v.x; };
  const double sign = major(beam.forward) < 0.0 ? -1.0 : 1.0;
  const auto direction = [&](double slope) { return beam.forward + slope * beam.aside; };
  const double major_low = sign * major(direction(beam.low));
  const double major_high = sign * major(direction(beam.high));
  const double cell_m = index.cell_m();
  const Vec2 eye = (beam.eye - index.origin()) / cell_m;  // in cells
  const int columns = by_x ? index.columns() : index.rows();
  const int rows = by_x ? index.rows() : index.columns();
  const double start = start_of(beam, major_low, major_high) / cell_m;
  const double first = std::clamp(std::floor(major(eye) + sign * start), -1.0, static_cast<double>(columns));
  const double reach = beam.reach_m / cell_m;
  const double steepest = std::max(major_low, major_high);
  int open_low = 0;
  int open_high = BeamDepth::slices - 1;
  for (int column = static_cast<int>(first); sign > 0.0 ? column < columns : column >= 0;
       column += sign > 0.0 ? 1 : -1) {
    if (column < 0 || column >= columns) continue;
    const double near = std::max(start, sign * (column + (sign > 0.0 ? 0 : 1) - major(eye)));
    const double far = sign * (column + (sign > 0.0 ? 1 : 0) - major(eye));
    if (far < near) continue;
    const double nearest_m = near * cell_m / steepest - 2.0 * bump_reach_m;
    while (open_low <= open_high && depth.depth(open_low) < nearest_m) ++open_low;
    while (open_low <= open_high && depth.depth(open_high) < nearest_m) --open_high;
    if (open_low > open_high || near > reach) return;
    double bottom = never;
    double top = -never;
    for (const double slope : {depth.slope(open_low), depth.slope(open_high + 1)}) {
      const Vec2 ray = direction(slope);
      const double climb = minor(ray) / (sign * major(ray));
      bottom = std::min(bottom, minor(eye) + climb * (climb > 0.0 ? near : far));
      top = std::max(top, minor(eye) + climb * (climb > 0.0 ? far : near));
    }
    const int last_row = static_cast<int>(std::clamp(std::floor(top + 1e-6), -1.0, rows - 1.0));
    for (int row = static_cast<int>(std::clamp(std::floor(bottom - 1e-6), 0.0, static_cast<double>(rows)));
         row <= last_row; ++row)
      visit(by_x ? SpatialIndex::Cell{column, row} : SpatialIndex::Cell{row, column});
  }
}

}  // namespace

BeamSweep::BeamSweep(const WorldModel& world) : world_(&world), seen_in_(world.index.count(), 0) {}

void BeamSweep::sweep(const Beam& beam, BeamDepth& depth, std::vector<Lit>& lit, std::uint64_t& work) {
  if (++sweep_ == 0) {  // the count wrapped around: forget all marks
    std::ranges::fill(seen_in_, 0);
    sweep_ = 1;
  }
  found_.clear();
  lit.clear();
  depth.open(beam);
  walk_beam(world_->index, beam, depth, [&](SpatialIndex::Cell cell) {
    for (const std::uint32_t item : world_->index.items(cell)) {
      if (std::exchange(seen_in_[item], sweep_) == sweep_) continue;
      ++work;
      look_at(beam, depth, item);
    }
  });
  for (const Found& f : found_) {
    Lit one{f.item};
    if (f.sight.u1 <= beam.high && f.sight.u2 >= beam.low && depth.may_see(f.sight, f.slack_m, one.low, one.high))
      lit.push_back(one);
  }
}

void BeamSweep::look_at(const Beam& beam, BeamDepth& depth, std::uint32_t item) {
  const SpatialIndex& index = world_->index;
  if (item < index.first_chunk()) {
    if (item != beam.mirror) look_at_wall(beam, depth, item);
    return;
  }
  if (beam.mirror != Beam::none) return;  // reflected beams look for walls alone
  if (item < index.first_disc()) {
    const CurveChunk& chunk = index.chunks()[item - index.first_chunk()];
    return look_at_box(beam, item, chunk.centre, chunk.radius_m + bump_reach_m);
  }
  const Disc& disc = world_->description.discs[item - index.first_disc()];
  look_at_box(beam, item, disc.centre, disc.radius_m + touch_m);
}

void BeamSweep::look_at_wall(const Beam& beam, BeamDepth& depth, std::uint32_t item) {
  const Segment& wall = world_->index.segments()[item];
  const bool rough = wall.rough && beam.mirror == Beam::none;  // bumps are looked for directly alone
  const std::optional<Sight> whole = sight_of(beam, wall);
  if (rough && (whole || reaches_before(beam, wall))) found_.push_back(bumpy(beam, item, whole));
  if (!whole || whole->u1 > beam.high || whole->u2 < beam.low) return;
  const Sight sight = within(*whole, beam);
  if (!rough) found_.push_back({item, sight, 0.0});
  const bool stops_light = !wall.one_sided || (cross(wall.along, beam.eye - wall.a) > 0.0) != beam.inward;
  if (stops_light && sight.u2 - sight.u1 > edge_on && std::min(sight.z1, sight.z2) > 2e-6) depth.close(sight);
}

/// A chunk of a curve or a disc, as the square around it.
void BeamSweep::look_at_box(const Beam& beam, std::uint32_t item, Vec2 centre, double radius_m) {
  const double z = dot(centre - beam.eye, beam.forward);
  const double y = dot(centre - beam.eye, beam.aside);
  const double near = z - radius_m;
  if (z + radius_m <= 0.0) return;
  if (near <= touch_m) return found_.push_back({item, {beam.low, touch_m, beam.high, touch_m}, 0.0});
  const double far = z + radius_m;
  const double u1 = (y - radius_m) / (y > radius_m ? far : near);
  const double u2 = (y + radius_m) / (y < -radius_m ? far : near);
  if (u1 > beam.high || u2 < beam.low) return;
  found_.push_back({item, {std::max(u1, beam.low), near, std::min(u2, beam.high), near}, 0.0});
}

}  // namespace echoarc::sim
