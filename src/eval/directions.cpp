// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/directions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

namespace echoarc {
namespace {

constexpr double unit_tolerance = 1e-9;
constexpr double full_turn_rad = 2.0 * std::numbers::pi;
// Where a count of lines comes out whole but for rounding.
constexpr double line_slack = 1e-9;

Error refused(std::string_view kind, std::size_t family, std::string cause, std::string remedy) {
  return {ErrorCode::bad_value, std::move(cause), std::string(kind) + " family " + std::to_string(family),
          std::move(remedy)};
}

bool is_unit(Vec2 v) {
  return std::abs(squared_norm(v) - 1.0) <= unit_tolerance;  // false for NaN
}

/// Counts beyond the limit are cut to one more than it allows, so that `validate` refuses them.
std::int32_t line_count_of(double lines) {
  return static_cast<std::int32_t>(std::clamp(lines, 0.0, double(max_direction_lines + 1)));
}

struct Interval {
  double low;
  double high;
};

/// The shadow of `box` on the axis through `origin` along `axis`.
Interval shadow(const Box& box, Vec2 origin, Vec2 axis) {
  const Vec2 corners[] = {box.low, {box.high.x, box.low.y}, {box.low.x, box.high.y}, box.high};
  Interval interval{dot(box.low - origin, axis), dot(box.low - origin, axis)};
  for (const Vec2 corner : corners) {
    interval.low = std::min(interval.low, dot(corner - origin, axis));
    interval.high = std::max(interval.high, dot(corner - origin, axis));
  }
  return interval;
}

Box region_of(const GridGeometry& geometry, std::int32_t columns, std::int32_t rows) {
  return {geometry.corner({0, 0}), geometry.corner({columns, rows})};
}

Result<void> validate_fans(std::span<const RayFamily> fans) {
  for (std::size_t k = 0; k < fans.size(); ++k) {
    const RayFamily& fan = fans[k];
    if (!is_finite(fan.centre) || !is_finite(fan.first))
      return refused("ray", k, "the centre or the first bearing is not finite", "give a position in metres");
    if (!(fan.step.rad() > 0.0)) return refused("ray", k, "rays without a width", "give a step above 0 degrees");
    if (fan.count < 0) return refused("ray", k, "a negative number of rays", "give 0 rays or more");
    if (!(fan.count * fan.step.rad() <= full_turn_rad * (1.0 + line_slack)))
      return refused("ray", k, "rays that go round more than once", "give fewer rays or a smaller step");
  }
  return {};
}

}  // namespace

std::int64_t DirectionSet::line_count() const {
  std::int64_t lines = 0;
  for (const LineFamily& family : families) lines += family.count;
  for (const RayFamily& fan : fans) lines += fan.count;
  return lines;
}

Result<void> validate(const DirectionSet& directions) {
  for (std::size_t k = 0; k < directions.families.size(); ++k) {
    const LineFamily& family = directions.families[k];
    if (!is_finite(family.corner)) return refused("line", k, "the corner is not finite", "give a position in metres");
    if (!is_unit(family.along) || !is_unit(family.across) ||
        !(std::abs(dot(family.along, family.across)) <= unit_tolerance))
      return refused("line", k, "along and across are no unit vectors at right angles", "normalise them");
    if (!(family.width_m > 0.0) || !std::isfinite(family.width_m))
      return refused("line", k, "lines of width " + std::to_string(family.width_m) + " m", "give a width above 0 m");
    if (family.count < 0) return refused("line", k, "a negative number of lines", "give 0 lines or more");
  }
  if (const Result<void> valid = validate_fans(directions.fans); !valid) return valid;
  if (directions.line_count() > max_direction_lines)
    return Error{ErrorCode::bad_value, "more than " + std::to_string(max_direction_lines) + " directions of interest",
                 "directions", "use wider lines or a smaller region"};
  return {};
}

DirectionSet column_directions(const GridGeometry& geometry, std::int32_t columns, std::int32_t rows) {
  return {
      region_of(geometry, columns, rows), {{geometry.origin, {0.0, 1.0}, {1.0, 0.0}, geometry.cell_m, columns}}, {}};
}

DirectionSet row_directions(const GridGeometry& geometry, std::int32_t columns, std::int32_t rows) {
  return {region_of(geometry, columns, rows), {{geometry.origin, {1.0, 0.0}, {0.0, 1.0}, geometry.cell_m, rows}}, {}};
}

DirectionSet axis_directions(const Box& region, Vec2 origin, Angle along, double width_m) {
  assert(width_m > 0.0 && is_finite(region.low) && is_finite(region.high));
  const Vec2 u = unit(along);
  const Vec2 n = -perpendicular(u);
  const Interval sideways = shadow(region, origin, n);
  const Interval lengthways = shadow(region, origin, u);
  // Line k has its middle at k widths from the origin: k = floor(t / width + 1/2).
  const double first = std::floor(sideways.low / width_m + 0.5 + line_slack);
  const double end = std::ceil(sideways.high / width_m + 0.5 - line_slack);
  // The lines start a little before the region, which bounds them anyway: its edge must not be lost to rounding.
  const Vec2 corner = origin + (first - 0.5) * width_m * n + (lengthways.low - width_m) * u;
  return {region, {{corner, u, n, width_m, line_count_of(end - first)}}, {}};
}

DirectionSet polar_directions(const Box& region, Vec2 centre, Angle step, Angle first, Angle last) {
  assert(step.rad() > 0.0);
  const double turn_rad = std::clamp((last - first).rad(), 0.0, full_turn_rad);
  const double rays = std::ceil(turn_rad / step.rad() - line_slack);
  const Angle width = rays > 0.0 ? radians(turn_rad / rays) : step;
  return {region, {}, {{centre, first, width, line_count_of(rays)}}};
}

DirectionSet wall_directions(std::span<const WallSpan> walls, const Box& region, double width_m) {
  assert(width_m > 0.0);
  DirectionSet directions{region, {}, {}};
  for (const WallSpan& wall : walls) {
    const double length_m = norm(wall.end - wall.begin);
    const double lines = std::round(length_m / width_m);
    if (!(lines >= 1.0)) continue;
    const Vec2 across = (wall.end - wall.begin) / length_m;
    const Vec2 outward = -perpendicular(across);
    directions.families.push_back(
        {wall.begin - wall.depth_m * outward, outward, across, width_m, line_count_of(lines)});
  }
  return directions;
}

}  // namespace echoarc
