// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/local_maps.hpp"

#include <algorithm>
#include <utility>

namespace echoarc::studies {
namespace {

template <class Options>
Options local_options() {
  Options options;
  options.archive = false;
  return options;
}

std::vector<MapPoint> in_company(const PointMap& map, const NeighbourRule& rule) {
  const PointMap kept = with_neighbours(map, rule);
  return {kept.points().begin(), kept.points().end()};
}

PointMap map_of(std::span<const MapPoint> points) {
  PointMap map;
  for (const MapPoint& point : points) map.add(point);
  return map;
}

}  // namespace

std::vector<MapPoint> labelled(std::span<const MapPoint> points, std::initializer_list<PointLabel> labels) {
  std::vector<MapPoint> chosen;
  for (const MapPoint& point : points)
    if (std::ranges::find(labels, point.label) != labels.end()) chosen.push_back(point);
  return chosen;
}

std::vector<Vec2> positions(std::span<const MapPoint> points) {
  std::vector<Vec2> places;
  places.reserve(points.size());
  for (const MapPoint& point : points) places.push_back(point.position);
  return places;
}

LocalMapper::LocalMapper(NeighbourRule rule)
    : rule_(rule),
      atm_(local_options<AtmSilver::Options>()),
      carve_(local_options<CarveOptions>()),
      combined_(local_options<CombinedOptions>()) {
  static_assert(AtmSilver::Options{}.history_arcs == history && CarveOptions{}.history == history &&
                CombinedOptions{}.history == history);
}

void LocalMapper::insert(std::span<const Reading> readings) {
  InlineExecutor executor;
  atm_.insert(readings, executor);
  carve_.insert(readings, executor);
  combined_.insert(readings, executor);
  centerline_.insert(readings, executor);
}

LocalMaps LocalMapper::maps() {
  InlineExecutor executor;
  atm_.finish(executor);
  carve_.finish(executor);
  combined_.finish(executor);
  centerline_.finish(executor);
  const auto all_centers = centerline_.map().points();
  const auto newest = all_centers.last(std::min(all_centers.size(), std::size_t{history}));
  LocalMaps maps;
  maps.centerline = in_company(map_of(newest), rule_);
  maps.atm_centerline = in_company(atm_.map(), rule_);
  maps.carved_centerline = in_company(carve_.map(), rule_);
  maps.combined = in_company(combined_.map(), rule_);
  maps.atm = labelled(maps.atm_centerline, {PointLabel::atm});
  maps.carved = labelled(maps.carved_centerline, {PointLabel::carved});
  maps.atm_carved = labelled(maps.combined, {PointLabel::atm, PointLabel::carved});
  return maps;
}

void look_along(std::span<const Reading> readings, double step_m, LocalMapper& mapper,
                const std::function<void(const Reading&)>& look) {
  if (readings.empty()) return;
  Vec2 last = readings.front().T_world_robot.position;
  for (const Reading& reading : readings) {
    mapper.insert(std::span(&reading, 1));
    if (norm(reading.T_world_robot.position - last) < step_m) continue;
    last = reading.T_world_robot.position;
    look(reading);
  }
}

}  // namespace echoarc::studies
