// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/navigator.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

#include "echoarc/nav/free_way.hpp"

namespace echoarc::live {
namespace {

bool knows(const MethodEntry& entry, std::string_view option) {
  return std::ranges::any_of(entry.specs(), [&](const OptionSpec& spec) { return spec.name == option; });
}

/// A method's options where they differ from the defaults: coarse cells, for its picture is not looked at, and for the
/// local map the newest arcs alone.
OptionMap navigation_options(const MethodEntry& entry, const NavigatorOptions& options, bool local) {
  const std::int64_t history = local ? options.history : options.map_history;
  OptionMap values;
  if (knows(entry, "cell_m")) values["cell_m"] = options.cell_m;
  if (local && knows(entry, "archive")) values["archive"] = false;
  if (knows(entry, "min_neighbours")) values["min_neighbours"] = std::int64_t{options.neighbours};
  if (knows(entry, "combine")) values["combine"] = "prefer_atm";
  if (knows(entry, "history_arcs")) {
    values["history"] = "total";
    values["history_arcs"] = history;
  } else if (knows(entry, "history")) {
    values["history"] = history;
  }
  return values;
}

/// The jump filter of [Silver04] App. B: leaps of a sensor's range are noise, most of them.
SensingOptions navigation_sensing() {
  SensingOptions options;
  options.jump_filter_m = 0.5;
  return options;
}

EvidenceGridOptions grid_options(const NavigatorOptions& options) {
  EvidenceGridOptions values;
  values.cell_m = options.cell_m;
  return values;
}

void include(Box& box, Vec2 place, double reach_m, bool first) {
  const Vec2 reach{reach_m, reach_m};
  const Vec2 low = place - reach;
  const Vec2 high = place + reach;
  if (first) {
    box = {low, high};
    return;
  }
  box = {{std::min(box.low.x, low.x), std::min(box.low.y, low.y)},
         {std::max(box.high.x, high.x), std::max(box.high.y, high.y)}};
}

/// How far from its sensor a reading changes an evidence grid.
double reach_of(const Reading& reading) {
  constexpr double band_m = 0.2;
  return echo_range_m(reading.outcome).value_or(reading.trusted_range_m) + band_m;
}

}  // namespace

Result<Navigator> Navigator::make(const SourceDescription& source, const NavigatorOptions& options) {
  const MethodEntry* entry = find_method(options.method);
  if (entry == nullptr) return make_method(options.method).error();
  Result<AnyMethod> local = entry->make(navigation_options(*entry, options, true));
  if (!local) return local.error();
  Result<AnyMethod> global = entry->make(navigation_options(*entry, options, false));
  if (!global) return global.error();
  return Navigator(source, options, std::move(*local), std::move(*global));
}

Navigator::Navigator(const SourceDescription& source, const NavigatorOptions& options, AnyMethod local,
                     AnyMethod global)
    : options_(options),
      sensing_(source.robot.sensors, navigation_sensing(), source.no_echo, source.temperature_k),
      local_(std::move(local)),
      global_(std::move(global)),
      evidence_(grid_options(options)),
      heard_(options.cell_m),
      from_points_(options.cell_m),
      map_time_s_(-std::numeric_limits<double>::infinity()) {
  if (options.map == PlanningMap::limited) sensing_.use_lasers(source.robot.lasers);
}

void Navigator::heed(const Record& record) {
  std::visit(
      [&](const auto& said) {
        using Kind = std::decay_t<decltype(said)>;
        if constexpr (!std::is_same_v<Kind, Truth> && !std::is_same_v<Kind, CommandNote>) sensing_.push(said);
      },
      record);
}

void Navigator::follow(std::unique_ptr<nav::Strategy> strategy, std::span<const Vec2> places) {
  strategy_ = std::move(strategy);
  places_.assign(places.begin(), places.end());
  map_time_s_ = -std::numeric_limits<double>::infinity();
}

nav::Steering Navigator::steer(double time_s, const Pose2& T_world_base, const RobotVelocity& velocity) {
  map_readings();
  refresh_points(T_world_base.position);
  if (time_s >= map_time_s_ + options_.map_period_s) refresh_map(time_s, T_world_base.position);
  return strategy_->update({.time_s = time_s,
                            .T_world_base = T_world_base,
                            .velocity = velocity,
                            .points = points_,
                            .map = map().cells().empty() ? nullptr : &map().cells(),
                            .map_version = map().version()});
}

void Navigator::rest(double time_s, Vec2 here) {
  if (time_s < map_time_s_ + options_.map_period_s) return;
  map_readings();
  refresh_map(time_s, here);
}

void Navigator::map_readings() {
  const std::span<const Reading> readings = sensing_.readings();
  local_.insert(readings, executor_);
  if (options_.map == PlanningMap::points) global_.insert(readings, executor_);
  const std::span<const Reading> mapped = sensing_.limited_readings();
  evidence_.insert(mapped, executor_);
  for (const Reading& reading : mapped) {
    include(changed_, reading.T_world_rx.position, reach_of(reading), !anything_changed_);
    anything_changed_ = true;
  }
  sensing_.clear_readings();
}

void Navigator::refresh_points(Vec2 here) {
  local_.finish(executor_);
  points_.clear();
  const Result<MapExport> map = local_.export_map();
  if (!map) return;
  // A method without a history of its own: its newest points are the local map.
  const std::span<const MapPoint> all = map->points.points();
  const std::size_t most = 2 * static_cast<std::size_t>(options_.history);  // a median and a carved point of each arc
  for (const MapPoint& point : all.last(std::min(all.size(), most)))
    if (squared_norm(point.position - here) < options_.reach_m * options_.reach_m) points_.push_back(point.position);
}

void Navigator::refresh_map(double time_s, Vec2 here) {
  map_time_s_ = time_s;
  for (const Vec2 place : places_) (void)heard_.cover({place, place});
  if (anything_changed_ && heard_.cover(changed_)) heard_.take(evidence_, changed_);
  anything_changed_ = false;
  if (options_.map == PlanningMap::points) take_points(here);
}

void Navigator::take_points(Vec2 here) {
  global_.finish(executor_);
  const Result<MapExport> map = global_.export_map();
  if (!map) return;
  std::vector<Vec2> points{};
  for (const MapPoint& point : map->points.points()) points.push_back(point.position);
  for (const Vec2 place : places_) (void)from_points_.cover({place, place});
  if (from_points_.cover({here, here})) from_points_.take(points);
}

std::optional<double> PointObstacles::free_along(const Pose2& T_world_base, const RobotVelocity& velocity,
                                                 double hull_radius_m, int /*least_hits*/) const {
  constexpr double look_m = 3.0;
  return nav::free_way_m(T_world_base, velocity, hull_radius_m, points_, look_m);
}

}  // namespace echoarc::live
