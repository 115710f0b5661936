// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/evidence_grid.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/maps/sector_raster.hpp"
#include "mapping/evidence_kernels.hpp"
#include "mapping/fitted_beam.hpp"

namespace echoarc {
namespace {

Reading echo_at(const Pose2& T_world_sensor, double range_m, Angle beam_width = degrees(25.0)) {
  Reading reading;
  reading.T_world_tx = reading.T_world_rx = T_world_sensor;
  reading.beam_width = beam_width;
  reading.outcome = Echo{range_m};
  return reading;
}

EvidenceGrid grid_with(const EvidenceGridOptions& options, std::span<const Reading> readings) {
  EvidenceGrid grid(options);
  InlineExecutor here;
  grid.insert(readings, here);
  return grid;
}

// V3.6: a cell at distance 1 m sees an echo on its axis, one 5 degrees off, and one from behind it.
TEST(InverseSonarModel, WorkedNumbers) {
  const InverseSonarModel model;
  EXPECT_NEAR(model.band_probability(0.0, degrees(0.0)), 0.85, 1e-12);
  EXPECT_NEAR(model.band_probability(0.0, degrees(5.0)), 0.754152, 1e-6);
  EXPECT_NEAR(model.free_probability(degrees(0.0)), 0.25, 1e-12);
  double l = log_odds(model.band_probability(0.0, degrees(0.0)));
  EXPECT_NEAR(l, 1.734601, 5e-7);
  EXPECT_NEAR(2.0 * probability(l) - 1.0, 0.7, 1e-12);
  l += log_odds(model.band_probability(0.0, degrees(5.0)));
  EXPECT_NEAR(l, 2.855482, 5e-7);
  EXPECT_NEAR(2.0 * probability(l) - 1.0, 0.891203, 5e-7);
  l += log_odds(model.free_probability(degrees(0.0)));
  EXPECT_NEAR(l, 1.756870, 5e-7);
  EXPECT_NEAR(2.0 * probability(l) - 1.0, 0.705634, 5e-7);
}

TEST(InverseSonarModel, ProfilesEndAtTheEdgeOfTheBeam) {
  for (const BeamProfile profile : {BeamProfile::gaussian, BeamProfile::uniform, BeamProfile::parabolic}) {
    const InverseSonarModel model{.profile = profile};
    EXPECT_DOUBLE_EQ(model.angular_factor(degrees(0.0)), 1.0);
    EXPECT_EQ(model.angular_factor(degrees(12.51)), 0.0);
  }
  EXPECT_NEAR(InverseSonarModel{.profile = BeamProfile::parabolic}.angular_factor(degrees(6.25)), 0.75, 1e-12);
}

// V3.6 in the grid itself: every step may be off by one unit of fixed point.
TEST(EvidenceGrid, WorkedNumbersInTheGrid) {
  const EvidenceGridOptions options{.cell_m = 0.01, .origin_x_m = -0.005, .origin_y_m = -0.005};
  const Cell cell{100, 0};  // centre (1, 0)
  const Reading readings[] = {echo_at({}, 1.0), echo_at({{}, degrees(5.0)}, 1.0), echo_at({}, 2.0)};
  const double expected[] = {1.734601, 2.855482, 1.756870};
  EvidenceGrid grid(options);
  InlineExecutor here;
  for (std::size_t k = 0; k < 3; ++k) {
    grid.insert(std::span(readings).subspan(k, 1), here);
    EXPECT_NEAR(grid.cell_log_odds(cell), expected[k], double(k + 1) * log_odds_unit);
  }
}

TEST(EvidenceGrid, SilenceClearsToTheTrustedRangeAtHalfWeight) {
  const EvidenceGridOptions options{.cell_m = 0.05, .origin_x_m = -0.025, .origin_y_m = -0.025};
  Reading silence = echo_at({}, 1.0);
  silence.outcome = NoEcho{};
  silence.trusted_range_m = 2.0;
  const EvidenceGrid grid = grid_with(options, std::span(&silence, 1));
  EXPECT_NEAR(grid.cell_log_odds({20, 0}), 0.5 * log_odds(0.25), log_odds_unit);
  EXPECT_EQ(grid.cell_log_odds({41, 0}), 0.0) << "2.05 m is beyond the trusted range";
  EXPECT_EQ(grid.cell_log_odds({2, 0}), 0.0) << "0.1 m is nearer than the sensor can see";
}

TEST(EvidenceGrid, SilenceWithoutATrustedRangeSaysNothing) {
  Reading silence = echo_at({}, 1.0);
  silence.outcome = NoEcho{};
  for (const double trusted_m : {0.0, silence.range_min_m}) {
    silence.trusted_range_m = trusted_m;
    const EvidenceGrid grid = grid_with({}, {&silence, 1});
    EXPECT_EQ(grid.counters().no_information, 1U);
    EXPECT_EQ(grid.counters().used, 0U);
  }
}

TEST(EvidenceGrid, ClearedThousandTimesIsOccupiedAfterAFewEchoes) {
  const EvidenceGridOptions options{.origin_x_m = -0.025, .origin_y_m = -0.025};
  const Cell cell{20, 0};  // centre (1, 0)
  const std::vector<Reading> far(1000, echo_at({}, 2.0));
  EvidenceGrid grid = grid_with(options, far);
  EXPECT_DOUBLE_EQ(grid.cell_log_odds(cell), -log_odds_clamp);
  InlineExecutor here;
  const std::vector<Reading> near(6, echo_at({}, 1.0));
  grid.insert(near, here);
  EXPECT_GE(probability(grid.cell_log_odds(cell)), options.occupied_threshold);
}

TEST(EvidenceGrid, CountsWhatItLeavesOut) {
  Reading too_close = echo_at({}, 1.0);
  too_close.outcome = TooClose{};
  Reading bistatic = echo_at({}, 0.2);
  bistatic.rx = 1;
  bistatic.T_world_rx.position = {1.0, 0.0};
  Reading beyond_the_world = echo_at({{1e300, 0.0}, {}}, 1.0);
  const Reading readings[] = {echo_at({}, 1.0), too_close, bistatic, beyond_the_world};
  const EvidenceGrid grid = grid_with({}, readings);
  EXPECT_EQ(grid.counters(), (InsertCounters{.used = 1, .no_information = 1, .no_arc = 1, .memory_limit = 1}));
}

TEST(EvidenceGrid, MemoryLimitIsKept) {
  std::vector<Reading> drive;
  for (int k = 0; k < 200; ++k) drive.push_back(echo_at({{10.0 * k, 0.0}, {}}, 8.0));
  const EvidenceGrid grid = grid_with({.cell_m = 0.01, .max_memory_mib = 4}, drive);
  EXPECT_GT(grid.counters().used, 5U);
  EXPECT_GT(grid.counters().memory_limit, 100U);
  EXPECT_LE(grid.map().memory_bytes(), std::size_t{4} << 20);
}

Reading arbitrary_reading(Rng& rng) {
  Reading reading = echo_at({{rng.uniform(-3, 3), rng.uniform(-3, 3)}, degrees(rng.uniform(-180, 180))},
                            rng.uniform(0.05, 4.0), degrees(rng.uniform(5.0, rng.below(4) == 0 ? 179.0 : 60.0)));
  if (rng.below(4) == 0) reading.outcome = NoEcho{};
  if (rng.below(4) == 0) {
    reading.rx = 1;
    reading.T_world_rx = {reading.T_world_tx.position + Vec2{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)},
                          reading.T_world_tx.heading + degrees(rng.uniform(-60, 60))};
  }
  return reading;
}

EvidenceGridOptions arbitrary_options(Rng& rng) {
  EvidenceGridOptions options{
      .cell_m = rng.uniform(0.02, 0.08), .origin_x_m = rng.uniform(-1, 1), .origin_y_m = rng.uniform(-1, 1)};
  options.profile = choices(BeamProfile{})[rng.below(3)].value;
  options.occupied_peak = rng.below(4) == 0 ? 0.998 : rng.uniform(0.55, 0.9);
  options.free_floor = rng.uniform(0.1, 0.45);
  options.range_sigma_m = rng.uniform(0.01, 0.1);
  options.range_confidence = rng.below(2) == 0;
  return options;
}

/// The obvious way: the model for every cell of the neighbourhood, rounded. Returns the largest difference in units.
double worst_difference(const EvidenceGrid& grid, const Reading& reading) {
  const EvidenceGridOptions& o = grid.options();
  const double r_max = reading.range_max_m;
  const auto echo = echo_range_m(reading.outcome);
  const double range = echo.value_or(std::min(reading.trusted_range_m, r_max));
  const double amplitude = o.range_confidence ? std::max(0.0, 1.0 - range / r_max) : 1.0;
  const InverseSonarModel model{o.profile,
                                0.5 * reading.beam_width,
                                o.angular_sigma,
                                o.range_sigma_m,
                                0.5 + amplitude * (o.occupied_peak - 0.5),
                                0.5 - amplitude * (0.5 - o.free_floor)};
  const Vec2 centre = 0.5 * (reading.T_world_tx.position + reading.T_world_rx.position);
  const Angle axis = reading.T_world_tx.heading + 0.5 * wrap(reading.T_world_rx.heading - reading.T_world_tx.heading);
  const CellBox box = grid.map().geometry().cells_of({centre - Vec2{5, 5}, centre + Vec2{5, 5}});
  double worst = 0.0;
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j)
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const Vec2 p = grid.map().geometry().centre({i, j});
      const double sigma = 0.5 * (norm(p - reading.T_world_tx.position) + norm(p - reading.T_world_rx.position));
      const Angle theta = wrap(bearing(p - centre) - axis);
      const bool in_band = echo && std::abs(sigma - range) <= band_sigmas * o.range_sigma_m;
      const double free_to = echo ? range - band_sigmas * o.range_sigma_m : range;
      double l = 0.0;
      if (in_band)
        l = log_odds(model.band_probability(sigma - range, theta));
      else if (sigma >= reading.range_min_m && sigma < free_to)
        l = (echo ? 1.0 : o.no_echo_weight) * log_odds(model.free_probability(theta));
      worst = std::max(worst, std::abs(double(grid.map().value({i, j}) - to_units(l))));
    }
  return worst;
}

RC_GTEST_PROP(EvidenceGridProperty, FastFormIsWithinOneUnitOfTheModel, (std::uint64_t seed)) {
  Rng rng(seed);
  Reading reading = arbitrary_reading(rng);
  const EvidenceGrid grid = grid_with(arbitrary_options(rng), std::span(&reading, 1));
  RC_ASSERT(grid.counters().used + grid.counters().no_arc == 1);
  if (grid.counters().used == 1) RC_ASSERT(worst_difference(grid, reading) <= 1.0);
}

RC_GTEST_PROP(EvidenceGridProperty, TraceForetellsTheChange, (std::uint64_t seed)) {
  Rng rng(seed);
  const EvidenceGridOptions options = arbitrary_options(rng);
  const Reading readings[] = {arbitrary_reading(rng), arbitrary_reading(rng)};
  EvidenceGrid grid = grid_with(options, std::span(readings).first(1));
  const Trace trace = grid.trace(readings[1]);
  InlineExecutor here;
  grid.insert(std::span(readings).subspan(1), here);
  for (const CellChange& change : trace.cells) {
    RC_ASSERT(change.after == grid.cell_log_odds(change.cell));
    if (change.after > change.before) RC_ASSERT(grid.supports(readings[1], change.centre));
  }
}

/// A sector's rows as the planner would have them, without the planner.
struct SectorColumnsAndEdges {
  SectorColumns sector;
  std::vector<std::int32_t> edges[6];

  SectorColumnsAndEdges(SectorRaster& raster, const Arc& rim, const kernels::EvidenceKernels& kernels,
                        const kernels::SplitShape& shape)
      : sector(raster.columns(rim)) {
    for (auto& edge : edges) edge.resize(sector.begin.size());
    kernels.split_rows(
        shape, runs(sector.begin.data(), sector.end.data()),
        {edges[0].data(), edges[1].data(), edges[2].data(), edges[3].data(), edges[4].data(), edges[5].data()});
  }
  [[nodiscard]] kernels::Runs runs(const std::int32_t* begin, const std::int32_t* end) const {
    return {sector.j_first, begin, end, std::int32_t(sector.begin.size())};
  }
  [[nodiscard]] kernels::Runs runs(int from, int to) const { return runs(edges[from].data(), edges[to].data()); }
};

/// Everything the kernels can do within a sector above and right of cell (0, 0), in one row of tiles.
std::vector<std::int32_t> work_of(const kernels::EvidenceKernels& kernels, std::uint64_t seed) {
  Rng rng(seed);
  const Angle half_width = degrees(rng.uniform(5.0, 20.0));
  const double reach = rng.uniform(10.0, 60.0);  // in cells of 1 cm
  const Vec2 apex{rng.uniform(0.02, 1.2), rng.uniform(0.0, 0.02)};
  const Arc rim = Arc::circular(apex, degrees(rng.uniform(25.0, 155.0)), 0.01 * reach, 2.0 * half_width);
  const GridGeometry geometry{.cell_m = 0.01, .origin = {-0.64, 0.0}};
  SectorRaster raster(geometry);
  const FittedBeam uniform = fit_beam({.profile = BeamProfile::uniform, .half_width = half_width}, 1.0);
  const FittedBeam fixed = fit_beam({.half_width = half_width}, 1.0);
  const auto floating = fit_polynomial([](double s) { return -4000.0 * std::exp(-20.0 * s); }, 0.2, 0.3);
  const Cell cell = geometry.cell_of(apex);
  const Vec2 offset = geometry.centre(cell) - apex;
  const double apex_i = (apex.x + 0.64) / 0.01 - 0.5;
  const kernels::BeamFrame frame{cell.i,
                                 cell.j,
                                 float(offset.x),
                                 float(offset.y),
                                 0.01F,
                                 float(cos(rim.axis())),
                                 float(sin(rim.axis())),
                                 float(0.01 * reach - 0.04)};
  const SectorColumnsAndEdges rows(
      raster, rim, kernels,
      {apex.y / 0.01 - 0.5, (reach - 8) * (reach - 8), 9.0, 70.0, -200, 400, apex_i + 200, 400 - apex_i});
  std::vector<std::int16_t> cells(std::size_t{4} * 64 * 64);
  for (std::int16_t& value : cells) value = std::int16_t(std::int32_t(rng.below(65536)) - 32768);
  std::int16_t* tiles[] = {cells.data(), cells.data() + 4096, cells.data() + 8192, cells.data() + 12288};
  const kernels::TileRow row{tiles, 0, 4};
  const auto runs = rows.runs(1, 2);
  kernels.add_constant(row, runs, std::int16_t(seed % 2 == 0 ? 4000 : -4000));
  kernels.add_constant(row, rows.runs(3, 4), std::get<std::int16_t>(uniform.free));
  std::vector<float> scratch(std::size_t{2} * 256 + kernels::ColumnScratch::margin);
  kernels.add_fixed(row, runs, frame, std::get<kernels::FixedPolynomial>(fixed.free), {scratch.data()});
  kernels.add_angular(row, runs, frame, *floating);
  for (const FittedBeam* beam : {&uniform, &fixed})
    kernels.add_band(row, rows.runs(0, 1), rows.runs(4, 5), frame, *beam->band);
  std::vector<std::int32_t> work(cells.begin(), cells.end());
  work.resize(cells.size() + 2);
  kernels.bounds(runs, &work[cells.size()], &work[cells.size() + 1]);
  for (const auto& edge : rows.edges) work.insert(work.end(), edge.begin(), edge.end());
  return work;
}

RC_GTEST_PROP(EvidenceGridProperty, InstructionSetsGiveTheSameBytes, (std::uint64_t seed)) {
  const kernels::EvidenceKernels* sets[4];
  const std::size_t count = kernels::available_evidence_kernels(sets, 4);
  const auto plain = work_of(*sets[0], seed);
  for (std::size_t s = 1; s < count; ++s) RC_ASSERT(work_of(*sets[s], seed) == plain);
}

TEST(FittedBeam, DefaultBeamNeedsFewTerms) {
  for (const double half_width_deg : {7.5, 12.5, 25.0})
    for (const double free_weight : {0.5, 1.0}) {
      const FittedBeam beam = fit_beam({.half_width = degrees(half_width_deg)}, free_weight);
      ASSERT_TRUE(beam.complete());
      EXPECT_LE(std::get<kernels::FixedPolynomial>(beam.free).terms, 5);
    }
  const FittedBeam uniform = fit_beam({.profile = BeamProfile::uniform}, 1.0);
  EXPECT_EQ(std::get<std::int16_t>(uniform.free), to_units(log_odds(0.25)));
}

/// How far the fixed-point polynomial of a beam strays from its model, in units, over nearly all it is ever asked.
double worst_fixed_error(const FittedBeam& beam) {
  const auto& fixed = std::get<kernels::FixedPolynomial>(beam.free);
  const double stretch = double(fixed.across_scale) * double(fixed.across_scale);
  const double bend = double(fixed.bend) * stretch;
  const double edge = sin(beam.model.half_width) * sin(beam.model.half_width);
  double worst = 0.0;
  for (int place = int(kernels::fixed_begin); place <= int(kernels::fixed_end); place += 3) {
    const double y = (place - double(kernels::fixed_begin)) / stretch;
    const double sine_squared = std::min(y / (1.0 - bend * y), edge);
    const double exact = beam.free_weight *
                         log_odds(beam.model.free_probability(radians(std::asin(std::sqrt(sine_squared))))) /
                         log_odds_unit;
    worst = std::max(worst, std::abs(fixed_value(fixed, std::int16_t(place)) - exact));
  }
  return worst;
}

TEST(FittedBeam, FixedPointStaysBesideTheRoundedModel) {
  Rng rng(5);
  int in_fixed_point = 0;
  for (int k = 0; k < 400; ++k) {
    const BeamProfile profile = k % 2 == 0 ? BeamProfile::gaussian : BeamProfile::parabolic;
    const FittedBeam beam = fit_beam(
        {.profile = profile, .half_width = degrees(rng.uniform(3.0, 60.0)), .free_floor = rng.uniform(0.1, 0.49)}, 1.0);
    if (!std::holds_alternative<kernels::FixedPolynomial>(beam.free)) continue;
    ++in_fixed_point;
    EXPECT_LT(worst_fixed_error(beam), 1.5) << beam.model.half_width.deg() << " deg, " << beam.model.free_floor;
  }
  EXPECT_GT(in_fixed_point, 200);
}

TEST(FittedBeam, WhatNoPolynomialFollowsIsAbsent) {
  EXPECT_FALSE(fit_beam(InverseSonarModel{.half_width = degrees(89.9), .angular_sigma = 0.05}, 1.0).complete());
  EXPECT_FALSE(fit_beam(InverseSonarModel{.occupied_peak = 0.999}, 1.0).complete());
}

}  // namespace
}  // namespace echoarc
