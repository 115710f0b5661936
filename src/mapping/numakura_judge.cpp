// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/numakura_judge.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {
namespace {

/// Sensors remembered; a log whose every reading comes from another sensor does not fill the memory with them.
constexpr std::size_t max_sensors = 4096;
/// Test 2 leaves out the ends of the beam's axis: the robot's own surroundings and the wall that the reading itself
/// saw.
constexpr double end_margin_m = 0.1;
constexpr double end_margin_cells = 2.0;
/// A cell is a mapped obstacle for test 2 when it is below minus this many readings.
constexpr double obstacle_readings = 2.0;

}  // namespace

SurfacePoint surface_point(const Arc& arc) {
  return {arc.centre(), unit(arc.axis()), arc.is_circular() ? arc.range_m() : norm(arc.midpoint() - arc.centre())};
}

double surface_angle(const SurfacePoint& before, const SurfacePoint& now, double min_baseline_m) {
  const Vec2 v = now.position() - before.position();
  const double baseline_m = norm(v);
  if (!(baseline_m > 0.0) || baseline_m < min_baseline_m) return std::numeric_limits<double>::quiet_NaN();
  return std::acos(std::clamp(dot(now.axis, v) / baseline_m, -1.0, 1.0));
}

Numakura::Judge::Judge(const NumakuraOptions& options) : options_(options) {}

void Numakura::Judge::begin_scan(std::uint32_t scan) {
  scan_ = scan;
  ++scans_;
}

const Numakura::Judge::Seen* Numakura::Judge::scan_before(const Reading& reading) const {
  const auto found = seen_.find({reading.tx, reading.rx});
  return found != seen_.end() && found->second.scan + 1 == reading.scan ? &found->second : nullptr;
}

OutlierVerdict Numakura::Judge::judge(const Reading& reading, const Arc& arc, const ValueBefore& before) const {
  OutlierVerdict verdict;
  const Seen* last = scan_before(reading);
  if (last == nullptr) return verdict;
  const SurfacePoint now = surface_point(arc);
  // [Numakura] 5.1: outlier unless 90 deg - h < theta < 90 deg + h.
  verdict.surface_angle_rad = surface_angle({last->sensor, last->axis, last->range_m}, now, options_.min_baseline_m);
  const double from_perpendicular = std::abs(verdict.surface_angle_rad - degrees(90.0).rad());
  verdict.geometry = options_.geometry_test && from_perpendicular >= arc.half_width().rad();
  // [Numakura] 5.2: looked at when the range jumps or follows an outlier.
  const std::uint64_t complete_scans = knows_scan(reading.scan) ? scans_ - 1 : scans_;
  const bool suspicious = last->outlier != 0 || std::abs(last->range_m - now.range_m) > options_.jump_m;
  verdict.consistency = options_.consistency_test && suspicious &&
                        complete_scans >= std::uint64_t(options_.beginning_scans) && passes_obstacle(now, before);
  return verdict;
}

bool Numakura::Judge::passes_obstacle(const SurfacePoint& now, const ValueBefore& before) const {
  const double length_m = now.range_m - end_margin_m - std::max(end_margin_m, end_margin_cells * options_.cell_m);
  if (length_m <= 0.0) return false;
  const GridGeometry geometry = geometry_of(options_);
  const Vec2 from = now.sensor + end_margin_m * now.axis;
  const Vec2 to = from + length_m * now.axis;
  const CellBox within = geometry.cells_of(
      {{std::min(from.x, to.x), std::min(from.y, to.y)}, {std::max(from.x, to.x), std::max(from.y, to.y)}});
  const double obstacle = -obstacle_readings * options_.obstacle_step / numakura_unit;
  RayRaster raster(geometry);
  return std::ranges::any_of(raster.cells(from, now.axis, length_m, within),
                             [&](Cell cell) { return before(cell) < obstacle; });
}

void Numakura::Judge::remember(const Reading& reading, const Arc& arc, const OutlierVerdict& verdict) {
  outliers_.geometry += verdict.geometry ? 1 : 0;
  outliers_.consistency += verdict.consistency ? 1 : 0;
  if (seen_.size() >= max_sensors)
    std::erase_if(seen_,
                  [&](const auto& entry) { return entry.second.scan != scan_ && entry.second.scan + 1 != scan_; });
  if (seen_.size() >= max_sensors) return;
  const SurfacePoint now = surface_point(arc);
  seen_[{reading.tx, reading.rx}] = {now.sensor, now.axis, now.range_m, reading.scan, verdict.outlier() ? 1U : 0U};
}

void Numakura::Judge::save(ByteWriter& out) const {
  out.put(scans_);
  out.put(scan_);
  out.put(outliers_);
  out.put<std::uint64_t>(seen_.size());
  for (const auto& [sensors, seen] : seen_) {
    out.put(sensors.first);
    out.put(sensors.second);
    out.put(seen);
  }
}

bool Numakura::Judge::restore(ByteReader& in) {
  scans_ = in.get<std::uint64_t>();
  scan_ = in.get<std::uint32_t>();
  outliers_ = in.get<OutlierCounters>();
  const auto count = in.get<std::uint64_t>();
  if (!in.ok() || count > max_sensors) return false;
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    const auto tx = in.get<SensorId>();
    const auto rx = in.get<SensorId>();
    const auto seen = in.get<Seen>();
    if (!is_finite(seen.sensor) || !is_finite(seen.axis) || !std::isfinite(seen.range_m)) return false;
    seen_[{tx, rx}] = seen;
  }
  return in.ok();
}

}  // namespace echoarc
