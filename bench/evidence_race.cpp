// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The evidence grid against the floor and against MRPT, interleaved in one run on one core. Figures go to stdout as
// JSON, remarks to stderr.

#include <cmath>
#include <cstdio>

#include "bench/contestant.hpp"
#include "bench/floor_kernels.hpp"
#include "bench/measure.hpp"
#include "bench/peers/mrpt_grid.hpp"
#include "bench/workload.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

constexpr std::size_t rounds = 25;
constexpr std::size_t sampled_readings = 199;  // no multiple of the ring's 16, so every sensor is among them

std::vector<Reading> evenly_sampled(std::span<const Reading> readings) {
  std::vector<Reading> sample;
  for (std::size_t k = 0; k < sampled_readings; ++k) sample.push_back(readings[k * readings.size() / sampled_readings]);
  return sample;
}

/// a[k] / b[k] for every round.
std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> quotients;
  for (std::size_t k = 0; k < a.size(); ++k) quotients.push_back(a[k] / b[k]);
  return quotients;
}

std::vector<double> scaled_inverse(const std::vector<double>& times, double count) {
  std::vector<double> rates;
  for (const double time : times) rates.push_back(count / time);
  return rates;
}

std::vector<double> scaled(const std::vector<double>& times, double factor) {
  std::vector<double> values;
  for (const double time : times) values.push_back(time * factor);
  return values;
}

void report(const std::vector<std::unique_ptr<Contestant>>& contestants, const RaceTimes& times,
            std::span<const Reading> sample, double block, const std::string& size, std::vector<Figure>& figures) {
  constexpr std::size_t floor = 0;
  for (std::size_t k = 0; k < contestants.size(); ++k) {
    const std::string name = contestants[k]->name() + "_" + size;
    const double cells = contestants[k]->cells_per_reading(sample);
    figures.push_back({name + "_rate", "readings/s", scaled_inverse(times[k], block)});
    figures.push_back({name + "_cells", "cells/reading", {cells}});
    figures.push_back({name + "_per_cell", "ns/cell", scaled(times[k], 1e9 / (block * cells))});
    const bool ours = contestants[k]->name().starts_with("evidence");
    if (ours) figures.push_back({name + "_time_vs_floor", "x", ratios(times[k], times[floor])});
    if (ours && contestants.back()->name() == "mrpt")
      figures.push_back({name + "_rate_vs_mrpt", "x", ratios(times.back(), times[k])});
  }
}

void race_at(double cell_m, std::span<const Reading> readings, std::vector<Figure>& figures) {
  std::vector<std::unique_ptr<Contestant>> contestants;
  contestants.push_back(make_floor(cell_m));
  for (const char* profile : {"uniform", "gaussian"}) contestants.push_back(make_evidence(cell_m, profile));
  if (auto mrpt = make_mrpt(cell_m)) contestants.push_back(std::move(mrpt));
  const RaceTimes times = race(contestants, readings, rounds);
  const std::vector<Reading> sample = evenly_sampled(readings);
  const auto block = double(readings.size() / rounds);
  report(contestants, times, sample, block, std::to_string(std::lround(100.0 * cell_m)) + "cm", figures);
}

}  // namespace

int main() {
  if (!pin_to_one_core()) std::fprintf(stderr, "remark: this process could not be kept on one core\n");
  if (make_mrpt(0.05) == nullptr)
    std::fprintf(stderr,
                 "remark: MRPT was not found when this was configured, so there is no comparison with it; "
                 "Debian: libmrpt-maps-dev libmrpt-obs-dev\n");
  std::fprintf(stderr, "instruction set: %s\n", floor_kernels().instruction_set);
  const std::vector<Reading> readings = make_workload();
  const WorkloadSummary summary = summarise(readings);
  std::vector<Figure> figures = {{"workload_readings", "1", {double(summary.readings)}},
                                 {"workload_mean_range", "m", {summary.mean_range_m}},
                                 {"workload_no_echo", "%", {100.0 * summary.no_echo_share}},
                                 {"workload_sector_5cm", "cells/reading", {summary.sector_area_m2 / 25e-4}},
                                 {"workload_sector_2cm", "cells/reading", {summary.sector_area_m2 / 4e-4}},
                                 {"workload_sector_1cm", "cells/reading", {summary.sector_area_m2 / 1e-4}}};
  for (const double cell_m : {0.05, 0.02, 0.01}) race_at(cell_m, readings, figures);
  print_json(figures);
}
