// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Memory of an evidence grid of 1 cm cells as a drive of 10^6 readings covers 5000 m2. Figures go to stdout as JSON.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/measure.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/core/sensor_array.hpp"
#include "echoarc/mapping/evidence_grid.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

constexpr double lane_length_m = 100.0;
constexpr double lane_spacing_m = 5.0;
constexpr int lanes = 10;  // 100 x 50 m
constexpr std::size_t total_readings = 1'000'000;
constexpr std::size_t sonars = 16;

/// Reading k of a drive up and down ten lanes, ranges drawn between 1 and 4 m.
Reading reading_on_lane(std::size_t k, const Sensor& sensor, Rng& rng) {
  const double driven_m = double(k) / double(total_readings) * lanes * lane_length_m;
  const double lane = std::floor(driven_m / lane_length_m);
  const double along_m = driven_m - lane * lane_length_m;
  const bool back = std::fmod(lane, 2.0) > 0.5;
  Reading r;
  r.ping = k;
  r.rx = r.tx = sensor.id;
  r.T_world_robot = {{back ? lane_length_m - along_m : along_m, lane_spacing_m * lane}, degrees(back ? 180.0 : 0.0)};
  r.T_world_tx = r.T_world_rx = r.T_world_robot * sensor.mount.T_robot_sensor();
  r.outcome = Echo{rng.uniform(1.0, 4.0)};
  return r;
}

double touched_m2(const EvidenceGrid& grid) {
  double cells = 0.0;
  grid.map().for_each_nonzero([&](Cell, std::int16_t) { cells += 1.0; });
  return cells * grid.options().cell_m * grid.options().cell_m;
}

void add_figures(const EvidenceGrid& grid, std::size_t readings, std::vector<Figure>& figures) {
  const double area_m2 = touched_m2(grid);
  const auto bytes = double(grid.map().memory_bytes());
  const std::string name = "memory_" + std::to_string(readings / 1000) + "k";
  figures.push_back({name + "_area", "m2", {area_m2}});
  figures.push_back({name + "_total", "MB", {1e-6 * bytes}});
  figures.push_back({name + "_per_m2", "kB/m2", {1e-3 * bytes / area_m2}});
}

}  // namespace

int main() {
  const std::vector<Sensor> ring16 = ring(int(sonars), 0.23, degrees(0.0), {});
  EvidenceGrid grid({.cell_m = 0.01, .profile = BeamProfile::uniform});
  InlineExecutor executor;
  Rng rng(1);
  std::vector<Figure> figures;
  std::vector<Reading> batch;
  for (std::size_t k = 0; k < total_readings; ++k) {
    batch.push_back(reading_on_lane(k, ring16[k % sonars], rng));
    const std::size_t count = k + 1;
    const bool stop = count == 100'000 || count == 300'000 || count == total_readings;
    if (batch.size() < 10'000 && !stop) continue;
    grid.insert(batch, executor);
    batch.clear();
    if (stop) add_figures(grid, count, figures);
  }
  if (grid.counters().used != total_readings) {
    std::fprintf(stderr, "error: the grid left out %zu readings\n", std::size_t(total_readings - grid.counters().used));
    return EXIT_FAILURE;
  }
  print_json(figures);
}
