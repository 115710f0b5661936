// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/triangulation_fusion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mapping/point_export.hpp"
#include "mapping/saved_points.hpp"
#include "mapping/saved_state.hpp"
#include "mapping/triangulation_hypotheses.hpp"

namespace echoarc {
namespace {

/// Memory that a point takes with the pings that speak for it.
constexpr std::size_t bytes_of_point(std::size_t support) {
  return sizeof(MapPoint) + support * sizeof(PingId);
}

using Place = TriangulationWindow::Place;

WindowShape shape_of(const TriangulationOptions& options) {
  return {options.rows, options.columns, options.column_m, options.column_turn};
}

/// What makes a monostatic echo a circular arc that can be reckoned with.
bool has_arc(const Reading& reading, double range_m) {
  const double beam_rad = reading.beam_width.rad();
  return std::isfinite(range_m) && range_m > 0.0 && beam_rad > 0.0 && beam_rad < std::numbers::pi &&
         is_finite(reading.T_world_tx) && is_finite(reading.T_world_robot);
}

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(middle));
  const double upper = values[middle];
  if (values.size() % 2 == 1) return upper;
  return 0.5 * (upper + *std::max_element(values.begin(), values.begin() + std::ptrdiff_t(middle)));
}

/// The median of each coordinate along and across the beam, so that it turns with the world.
Vec2 median_position(const std::vector<Vec2>& points, const WindowArc& own) {
  std::vector<double> along;
  std::vector<double> across;
  for (const Vec2 p : points) {
    along.push_back(dot(p - own.sensor, own.axis));
    across.push_back(cross(own.axis, p - own.sensor));
  }
  return own.sensor + median(std::move(along)) * own.axis + median(std::move(across)) * perpendicular(own.axis);
}

/// Distances of a point from both ends of an arc, the smaller first.
std::pair<double, double> ends_m(const WindowArc& arc, Vec2 p) {
  const Vec2 along = arc.range_m * std::cos(arc.half_width_rad) * arc.axis;
  const Vec2 across = arc.range_m * std::sin(arc.half_width_rad) * perpendicular(arc.axis);
  return std::minmax({norm(arc.sensor + along + across - p), norm(arc.sensor + along - across - p)});
}

/// From a point to the nearest of an arc.
double distance_m(const WindowArc& arc, Vec2 p) {
  if (arc.off_axis_rad(p) <= arc.half_width_rad) return std::abs(norm(p - arc.sensor) - arc.range_m);
  return ends_m(arc, p).first;
}

}  // namespace

TriangulationFusion::TriangulationFusion(Options options) : options_(options), window_(shape_of(options)) {}

void TriangulationFusion::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) {
    const auto range_m = echo_range_m(reading.outcome);
    if (!range_m) {
      ++counters_.no_information;
    } else if (!reading.monostatic()) {
      ++counters_.bistatic;
    } else if (!has_arc(reading, *range_m)) {
      ++counters_.no_arc;
    } else {
      const Place place = window_.place_of(reading);
      if (place == Place::none || *range_m > options_.range_max_m) {
        ++counters_.passed_over;
        continue;
      }
      const WindowArc arc = WindowArc::of(reading, *range_m);
      const auto found = triangulate(arc, place);
      const bool kept = !found || !shown(*found) || remember(reading, arc, *found);
      window_.put(reading, arc, place);
      ++(kept ? counters_.used : counters_.memory_limit);
    }
  }
}

std::optional<Triangulation> TriangulationFusion::triangulate(const WindowArc& arc, Place place) const {
  TriangulationHypotheses hypotheses(options_.gate_m, max_hypotheses);
  const auto [newest, end] = window_.older_columns(place);
  for (std::size_t age = newest; age < end; ++age)
    for (const WindowArc& other : window_.column(age).arcs)
      if (const ArcMeetings met = meetings_of(arc, other, options_.baseline_min_m); met.count > 0)
        hypotheses.add(hypotheses.choose(met, arc, other), other);
  const auto* best = hypotheses.best();
  if (best == nullptr) return std::nullopt;

  Triangulation found;
  for (const auto& meeting : best->meetings) {
    found.meetings.push_back(meeting.position);
    found.support.push_back(meeting.other->ping);
  }
  found.successes = static_cast<int>(best->meetings.size());
  found.max_deviation_m = best->max_deviation_m();
  found.edge = found.max_deviation_m <= options_.edge_m;
  const bool use_median = options_.position == TriangulationPosition::median;
  found.position = use_median ? median_position(found.meetings, arc) : best->mean();
  if (options_.refine) found.position = refined_position(found.position, arc, *best, options_.refine_sigma_m);
  return found;
}

std::optional<Triangulation> TriangulationFusion::triangulate(const Reading& reading) const {
  const auto range_m = echo_range_m(reading.outcome);
  if (!range_m || !reading.monostatic() || !has_arc(reading, *range_m) || *range_m > options_.range_max_m)
    return std::nullopt;
  const Place place = window_.place_of(reading);
  if (place == Place::none) return std::nullopt;
  return triangulate(WindowArc::of(reading, *range_m), place);
}

bool TriangulationFusion::shown(const Triangulation& found) const {
  return found.successes >= options_.threshold && (found.edge || options_.show == TriangulationShow::all);
}

bool TriangulationFusion::remember(const Reading& reading, const WindowArc& arc, const Triangulation& found) {
  const std::size_t bytes = bytes_of_point(found.support.size() + 1);
  if (map_bytes_ + bytes > memory_limit_bytes(options_)) return false;
  map_bytes_ += bytes;
  MapPoint point;
  point.position = found.position;
  point.label = found.edge ? PointLabel::edge : PointLabel::triangulated;
  point.bound_m = ends_m(arc, found.position).second;
  point.time_s = reading.time_s;
  point.sensor = reading.rx;
  point.ping = reading.ping;
  std::vector<PingId> support{reading.ping};
  support.insert(support.end(), found.support.begin(), found.support.end());
  map_.add(point, support);
  return true;
}

Result<MapExport> TriangulationFusion::export_map() const {
  return export_points(map_, options_, name);
}

Trace TriangulationFusion::trace(const Reading& reading) const {
  Trace trace;
  const auto found = triangulate(reading);
  if (const auto range_m = echo_range_m(reading.outcome); range_m && reading.monostatic() && has_arc(reading, *range_m))
    trace.arc = arc_of(reading);
  if (found && shown(*found)) trace.points.push_back(found->position);
  return trace;
}

bool TriangulationFusion::supports(const Reading& reading, Vec2 position) const {
  const auto range_m = echo_range_m(reading.outcome);
  if (!range_m || !reading.monostatic() || !has_arc(reading, *range_m)) return false;
  return distance_m(WindowArc::of(reading, *range_m), position) <= options_.gate_m;
}

std::vector<std::byte> TriangulationFusion::save() const {
  ByteWriter out;
  save_head<TriangulationFusion>(out, options_, counters_);
  window_.save(out);
  save_first_points(out, map_, map_.size());
  return std::move(out).take();
}

Result<TriangulationFusion> TriangulationFusion::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<TriangulationFusion>(in, options, counters)) return damaged_state(name);
  TriangulationFusion method(options);
  method.counters_ = counters;
  if (!method.window_.restore(in) || !restore_first_points(in, method.map_) || !in.done()) return damaged_state(name);
  for (const MapPoint& point : method.map_.points()) method.map_bytes_ += bytes_of_point(point.support_count);
  return method;
}

}  // namespace echoarc
