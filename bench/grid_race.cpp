// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The accumulation grid and the laser-limited grid against the evidence grid, interleaved in one run on one core: time
// per cell. The laser-limited grid pays for everything: taking the scans, placing them, shortening the readings.
// Figures go to stdout as JSON, remarks to stderr.

#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/contestant.hpp"
#include "bench/measure.hpp"
#include "bench/workload.hpp"
#include "echoarc/mapping/limited_grid.hpp"
#include "echoarc/mapping/numakura.hpp"
#include "echoarc/sensing/laser_limiter.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

constexpr std::size_t rounds = 15;
constexpr std::size_t sampled_readings = 199;  // no multiple of the ring's 16, so every sensor is among them
constexpr std::size_t ring_sensors = 16;

class Accumulation final : public Contestant {
 public:
  explicit Accumulation(double cell_m) : cell_m_(cell_m), grid_({.cell_m = cell_m}) {}

  std::string name() const override { return "numakura"; }
  void prepare(std::span<const Reading> readings) override { readings_ = readings; }
  void insert() override {
    grid_.insert(readings_, executor_);
    grid_.finish(executor_);
  }
  double cells_per_reading(std::span<const Reading> readings) const override {
    const Numakura empty({.cell_m = cell_m_});
    double cells = 0.0;
    for (const Reading& reading : readings) cells += double(empty.trace(reading).cells.size());
    return cells / double(readings.size());
  }

 private:
  double cell_m_;
  Numakura grid_;
  InlineExecutor executor_;
  std::span<const Reading> readings_;
};

/// One scan of 181 beams, 1 degree apart, from the robot's middle for every sweep of the ring.
std::vector<Scan> scans_of(std::span<const Reading> readings) {
  const Scene scene = hall();
  std::vector<Scan> scans;
  for (std::size_t k = 0; k < readings.size(); k += ring_sensors) {
    Scan scan{.time_s = readings[k].time_s, .angle_min = degrees(-90.0), .angle_step = degrees(1.0)};
    for (int beam = 0; beam <= 180; ++beam) {
      const Pose2 T_world_beam = readings[k].T_world_robot * Pose2{{}, degrees(-90.0 + beam)};
      const double range_m = nearest_surface_m(scene, T_world_beam, degrees(0.1));
      scan.ranges_m.push_back(std::isfinite(range_m) ? float(range_m) : std::numeric_limits<float>::quiet_NaN());
    }
    scans.push_back(scan);
  }
  return scans;
}

class Limited final : public Contestant {
 public:
  Limited(double cell_m, std::span<const Reading> drive) : cell_m_(cell_m), scans_(scans_of(drive)), grid_(options()) {
    for (std::size_t k = 0; k < drive.size(); k += ring_sensors)
      (void)track_.push({.time_s = drive[k].time_s, .T_world_robot = drive[k].T_world_robot});
  }

  std::string name() const override { return "limited"; }
  void prepare(std::span<const Reading> readings) override {
    readings_ = readings;
    limiter_ = make_limiter();
  }
  void insert() override {
    limited_.clear();
    for (const Scan& scan : scans_)
      if (scan.time_s >= readings_.front().time_s - 1.0 && scan.time_s <= readings_.back().time_s)
        (void)limiter_.push(scan);
    for (const Reading& reading : readings_) limited_.push_back(limiter_.limited(reading, track_));
    grid_.insert(limited_, executor_);
  }
  double cells_per_reading(std::span<const Reading> readings) const override {
    LaserLimiter limiter = make_limiter();
    for (const Scan& scan : scans_) (void)limiter.push(scan);
    const LimitedGrid empty(options());
    double cells = 0.0;
    for (const Reading& reading : readings) cells += double(empty.trace(limiter.limited(reading, track_)).cells.size());
    return cells / double(readings.size());
  }

 private:
  [[nodiscard]] EvidenceGridOptions options() const {
    EvidenceGridOptions options;
    options.cell_m = cell_m_;
    return options;
  }
  [[nodiscard]] static LaserLimiter make_limiter() {
    return {{LaserMount{.range_max_m = 30.0}}, LaserLimit::cone_min, 10.0};
  }

  double cell_m_;
  std::vector<Scan> scans_;
  PoseTrack track_;
  LimitedGrid grid_;
  LaserLimiter limiter_ = make_limiter();
  InlineExecutor executor_;
  std::span<const Reading> readings_;
  std::vector<Reading> limited_;
};

void race_at(double cell_m, std::span<const Reading> readings, std::vector<Figure>& figures) {
  std::vector<std::unique_ptr<Contestant>> contestants;
  contestants.push_back(make_evidence(cell_m, "gaussian"));
  contestants.push_back(std::make_unique<Accumulation>(cell_m));
  contestants.push_back(std::make_unique<Limited>(cell_m, readings));
  const RaceTimes times = race(contestants, readings, rounds);
  std::vector<Reading> sample;
  for (std::size_t k = 0; k < sampled_readings; ++k) sample.push_back(readings[k * readings.size() / sampled_readings]);
  const std::string size = std::to_string(std::lround(100.0 * cell_m)) + "cm";
  const auto block = double(readings.size() / rounds);
  std::vector<double> cells;
  for (const auto& contestant : contestants) cells.push_back(contestant->cells_per_reading(sample));
  for (std::size_t k = 1; k < contestants.size(); ++k) {
    const std::string name = contestants[k]->name() + "_" + size;
    std::vector<double> per_cell;
    std::vector<double> versus;
    for (std::size_t round = 0; round < rounds; ++round) {
      per_cell.push_back(1e9 * times[k][round] / (block * cells[k]));
      versus.push_back(times[k][round] / cells[k] / (times[0][round] / cells[0]));
    }
    figures.push_back({name + "_cells", "cells/reading", {cells[k]}});
    figures.push_back({name + "_per_cell", "ns/cell", per_cell});
    figures.push_back({name + "_cell_time_vs_evidence", "x", versus});
  }
}

}  // namespace

int main() {
  if (!pin_to_one_core()) std::fprintf(stderr, "remark: this process could not be kept on one core\n");
  const std::vector<Reading> readings = make_workload({.readings = 60'000});
  std::vector<Figure> figures;
  for (const double cell_m : {0.05, 0.02}) race_at(cell_m, readings, figures);
  print_json(figures);
}
