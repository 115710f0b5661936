// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/triangulation_window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace echoarc {
namespace {

WindowArc window_arc(Vec2 sensor, Angle axis, double range_m, double half_width_rad) {
  WindowArc arc;
  arc.sensor = sensor;
  arc.axis = unit(axis);
  arc.range_m = range_m;
  arc.half_width_rad = half_width_rad;
  arc.midpoint = sensor + range_m * arc.axis;
  arc.reach_m = 2.0 * range_m * std::sin(0.5 * half_width_rad);
  arc.along_min_m = range_m * std::cos(half_width_rad + eps_angle.rad());
  return arc;
}

}  // namespace

WindowArc WindowArc::of(const Reading& reading, double range_m) {
  const Pose2& T_world_sensor = reading.T_world_tx;
  WindowArc arc = window_arc(T_world_sensor.position, T_world_sensor.heading, range_m, 0.5 * reading.beam_width.rad());
  arc.ping = reading.ping;
  arc.id = reading.rx;
  return arc;
}

double WindowArc::off_axis_rad(Vec2 p) const {
  return std::abs(std::atan2(cross(axis, p - sensor), dot(axis, p - sensor)));
}

TriangulationWindow::Place TriangulationWindow::place_of(const Reading& reading) const {
  if (used_ == 0) return Place::new_column;
  const Column& newest = column(0);
  const Pose2& T_world_robot = reading.T_world_robot;
  // With the tolerances: scans taken every 5 cm are columns 5 cm apart, however their positions are rounded.
  const double moved_m = norm(T_world_robot.position - newest.T_world_robot.position);
  const Angle turned = abs(wrap(T_world_robot.heading - newest.T_world_robot.heading));
  if (moved_m >= shape_.column_m - eps_length_m || turned >= shape_.column_turn - eps_angle) return Place::new_column;
  const bool taken = std::ranges::find(newest.arcs, reading.rx, &WindowArc::id) != newest.arcs.end();
  return taken || newest.arcs.size() >= std::size_t(shape_.rows) ? Place::none : Place::newest_column;
}

void TriangulationWindow::put(const Reading& reading, const WindowArc& arc, Place place) {
  if (place == Place::new_column) {
    newest_ = (newest_ + 1) % columns_.size();
    used_ = std::min(used_ + 1, columns_.size());
    columns_[newest_].T_world_robot = reading.T_world_robot;
    columns_[newest_].arcs.clear();
  }
  columns_[newest_].arcs.push_back(arc);
}

void TriangulationWindow::save(ByteWriter& out) const {
  out.put<std::uint64_t>(used_);
  for (std::size_t age = used_; age-- > 0;) {
    const Column& saved = column(age);
    out.put(saved.T_world_robot);
    out.put<std::uint64_t>(saved.arcs.size());
    for (const WindowArc& arc : saved.arcs) {
      out.put(arc.sensor);
      out.put(arc.axis);
      out.put(arc.range_m);
      out.put(arc.half_width_rad);
      out.put(arc.ping);
      out.put<std::uint64_t>(arc.id);
    }
  }
}

bool TriangulationWindow::restore(ByteReader& in) {
  const auto used = in.get<std::uint64_t>();
  if (!in.ok() || used > columns_.size()) return false;
  const auto read_arc = [&]() -> std::optional<WindowArc> {
    const auto sensor = in.get<Vec2>();
    const auto axis = in.get<Vec2>();
    const auto range_m = in.get<double>();
    const auto half_width_rad = in.get<double>();
    const bool sound = is_finite(sensor) && std::abs(squared_norm(axis) - 1.0) < 1e-9 && std::isfinite(range_m) &&
                       range_m > 0.0 && half_width_rad > 0.0 && half_width_rad < 0.5 * std::numbers::pi;
    if (!in.ok() || !sound) return std::nullopt;
    WindowArc arc = window_arc(sensor, Angle{}, range_m, half_width_rad);
    arc.axis = axis;
    arc.midpoint = sensor + range_m * axis;
    arc.ping = in.get<PingId>();
    arc.id = static_cast<SensorId>(in.get<std::uint64_t>());
    return arc;
  };
  for (std::uint64_t k = 0; k < used; ++k) {
    Column& column = columns_[k];
    column.T_world_robot = in.get<Pose2>();
    const auto count = in.get<std::uint64_t>();
    if (!in.ok() || !is_finite(column.T_world_robot) || count == 0 || count > std::uint64_t(shape_.rows)) return false;
    for (std::uint64_t n = 0; n < count; ++n) {
      const auto arc = read_arc();
      if (!arc) return false;
      column.arcs.push_back(*arc);
    }
  }
  used_ = used;
  newest_ = used > 0 ? used - 1 : 0;
  return in.ok();
}

}  // namespace echoarc
