// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "echoarc/io/scene_toml.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/live/replay_source.hpp"
#include "echoarc/sim/simulate.hpp"

namespace echoarc::live::test {

/// The demo scene's drive, up to a time: simulated once a program.
inline const Log& demo_log() {
  static const Log log = [] {
    auto scene = io::read_scene_file(std::filesystem::path(ECHOARC_SOURCE_DIR) / "scenes/demo.toml");
    auto simulation = sim::simulate(scene.value().scene, 1);
    return std::move(simulation).value().log;
  }();
  return log;
}

inline Log demo_log_until(double time_s) {
  Log log = demo_log();
  const auto cut = [&](auto& records) { std::erase_if(records, [&](const auto& r) { return r.time_s > time_s; }); };
  cut(log.odometry);
  cut(log.pings);
  cut(log.scans);
  cut(log.truth);
  cut(log.walls);
  return log;
}

struct Played {
  SourceDescription description;
  std::vector<Record> records;
};

inline Played play(const Log& log) {
  auto source = ReplaySource::make(log);
  Played played{source.value()->description(), {}};
  (void)source.value()->advance(1e9, played.records);
  return played;
}

template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const T& x, const T& y) { return x == y || (x != x && y != y); });
}

inline bool same_number(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

inline bool same_map(const MapExport& a, const MapExport& b) {
  const auto same_point = [](const MapPoint& p, const MapPoint& q) {
    return p.position == q.position && p.label == q.label && same_number(p.bound_m, q.bound_m) &&
           same_number(p.time_s, q.time_s) && p.ping == q.ping && p.support_count == q.support_count;
  };
  if (a.points.size() != b.points.size() || a.values.index() != b.values.index()) return false;
  for (std::size_t k = 0; k < a.points.size(); ++k)
    if (!same_point(a.points.points()[k], b.points.points()[k])) return false;
  if (!(a.states.geometry() == b.states.geometry()) || !same_bits(a.states.values(), b.states.values())) return false;
  if (const auto* grid = std::get_if<DenseGrid<float>>(&a.values))
    return same_bits(grid->values(), std::get<DenseGrid<float>>(b.values).values());
  if (const auto* grid = std::get_if<DenseGrid<std::uint16_t>>(&a.values))
    return same_bits(grid->values(), std::get<DenseGrid<std::uint16_t>>(b.values).values());
  return true;
}

}  // namespace echoarc::live::test
