// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/consensus_evidence.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mapping/consensus/evidence_beam.hpp"
#include "support/random_readings.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

using consensus::EvidenceBeam;
using consensus::make_bins;
using consensus::touch_point;

ConsensusEvidence mapped(const ConsensusEvidenceOptions& options, std::span<const Reading> readings) {
  ConsensusEvidence method(options);
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);
  return method;
}

std::uint64_t tally(const ConsensusEvidence& method, std::string_view name) {
  for (const Tally& found : method.tallies())
    if (found.name == name) return found.count;
  return 0;
}

consensus::EchoArc ahead(double range_m) {
  return {Arc::circular({}, Angle{}, range_m, degrees(20.0)), {}, 0, degrees(20.0), 0};
}

/// Bearings of +-15 degrees.
consensus::BeamBins bins_of(const consensus::EchoArc& echo, const ConsensusEvidenceOptions& options) {
  return make_bins(options, {.sigma_beams = 0.4, .search_beams = 0.75}, echo.beam_width);
}

/// A posterior over +-15 degrees with all of its mass on some bearings.
std::vector<float> posterior_on(std::initializer_list<int> bearings_deg) {
  std::vector<float> posterior(31, 0.0F);
  for (const int t : bearings_deg) posterior[std::size_t(t + 15)] = 1.0F / float(bearings_deg.size());
  return posterior;
}

double change(const EvidenceBeam& beam, double distance_m, double theta_deg) {
  return increment(beam, distance_m * unit(degrees(theta_deg))) * log_odds_unit;
}

TEST(ConsensusEvidence, WorkedNumbers) {
  const ConsensusEvidenceOptions options;
  const consensus::EchoArc echo = ahead(2.0);
  const consensus::BeamBins bins = bins_of(echo, options);
  ASSERT_EQ(bins.count(), 31);
  // 10 cm along an arc of 2 m are 2.9 degrees: two bins to either side.
  const EvidenceBeam sure = echo_beam(echo, bins, posterior_on({4}), 0.1, options);
  EXPECT_NEAR(change(sure, 2.0, 4.0), 1.7346, log_odds_unit);  // ln(.85 / .15)
  EXPECT_NEAR(change(sure, 2.0, 6.4), 1.7346, log_odds_unit);  // within 2.5 degrees of it
  EXPECT_EQ(change(sure, 2.0, 6.6), 0.0);
  EXPECT_EQ(change(sure, 2.0, 0.0), 0.0);                       // on the axis: it did not come from there
  EXPECT_NEAR(change(sure, 2.02, 4.0), 0.9065, log_odds_unit);  // one sigma: p = .5 + .35 exp(-1/2) = .7123
  EXPECT_EQ(change(sure, 2.05, 4.0), 0.0);                      // behind the band
  EXPECT_EQ(change(sure, 1.95, 4.0), 0.0);                      // before it, but not by 10 cm
  EXPECT_NEAR(change(sure, 1.8, 4.0), -1.0986, log_odds_unit);  // ln(.25 / .75)
  EXPECT_EQ(change(sure, 1.8, 0.0), 0.0);                       // the sound did not go there
  EXPECT_EQ(change(sure, 0.09, 4.0), 0.0);                      // too near for the sensor

  // Two bearings as likely as one another: p = .5 + .35 / 2 on both, and free to .5 - .25 / 2.
  const EvidenceBeam torn = echo_beam(echo, bins, posterior_on({-8, 8}), 0.1, options);
  EXPECT_NEAR(change(torn, 2.0, -8.0), 0.7309, log_odds_unit);
  EXPECT_NEAR(change(torn, 1.0, 8.0), -0.5108, log_odds_unit);
  EXPECT_EQ(change(torn, 2.0, 0.0), 0.0);
}

TEST(ConsensusEvidence, AllOfTheBeamBecomesFreeOnRequest) {
  ConsensusEvidenceOptions options;
  options.free_beam = 1.0;
  options.profile = BeamProfile::uniform;
  const consensus::EchoArc echo = ahead(2.0);
  const EvidenceBeam beam = echo_beam(echo, bins_of(echo, options), posterior_on({4}), 0.1, options);
  EXPECT_NEAR(change(beam, 1.0, -9.0), -1.0986, log_odds_unit);
  EXPECT_EQ(change(beam, 1.0, -12.0), 0.0) << "outside the beam, and the echo not from there";
}

/// An ellipse: W is asked by the direction of its normal, cells by their bearing from between the sensors.
TEST(ConsensusEvidence, BistaticEchoRaisesWhereItsNormalPoints) {
  const ConsensusEvidenceOptions options;
  const auto arc = Arc::elliptical({{0.0, -0.2}, Angle{}}, {{0.0, 0.2}, Angle{}}, 1.0, degrees(20.0));
  ASSERT_TRUE(arc);
  const consensus::EchoArc echo{*arc, {}, 1, degrees(20.0), 0};
  const EvidenceBeam beam = echo_beam(echo, bins_of(echo, options), posterior_on({10}), 0.1, options);
  EXPECT_NEAR(increment(beam, touch_point(*arc, unit(degrees(10.0)))) * log_odds_unit, 1.7346, log_odds_unit);
  EXPECT_EQ(increment(beam, touch_point(*arc, unit(degrees(-10.0)))), 0);
}

TEST(ConsensusEvidence, SilenceClearsAsInTheEvidenceGrid) {
  Reading silence = test::monostatic_reading({{0.013, 0.021}, degrees(31.0)}, NoEcho{});
  silence.trusted_range_m = 2.0;
  ConsensusEvidenceOptions options;
  options.no_echo_weight = 0.5;
  options.profile = BeamProfile::uniform;
  EvidenceGrid plain(EvidenceGridOptions{.profile = BeamProfile::uniform});
  InlineExecutor here;
  plain.insert(std::span(&silence, 1), here);
  const ConsensusEvidence grid = mapped(options, std::span(&silence, 1));
  int cleared = 0;
  plain.map().for_each_nonzero([&](Cell cell, std::int16_t value) {
    ++cleared;
    EXPECT_EQ(grid.map().value(cell), value);
  });
  EXPECT_GT(cleared, 100);
  grid.map().for_each_nonzero([&](Cell cell, std::int16_t) { EXPECT_NE(plain.map().value(cell), 0); });
}

TEST(ConsensusEvidence, WallComesOutThin) {
  Rng rng(3);
  std::vector<Reading> facing = test::wall_drive(rng, 40);
  std::erase_if(facing, [](const Reading& reading) { return reading.rx == 0 || reading.rx == 4; });
  const ConsensusEvidence grid = mapped({}, facing);
  const auto map = grid.export_map();
  ASSERT_TRUE(map);
  int on_the_wall = 0;
  for (const MapPoint& point : map->points.points())
    on_the_wall += std::abs(point.position.y - test::wall_y_m) < 0.05 ? 1 : 0;
  EXPECT_GT(on_the_wall, 10);
  EXPECT_GE(on_the_wall, int(0.9 * double(map->points.size())));
}

/// A wall, then echoes from behind it that agree with one another: mirrored, and voted out.
TEST(ConsensusEvidence, OutliersSayNothing) {
  Rng rng(3);
  std::vector<Reading> readings = test::wall_drive(rng, 40);
  const std::size_t real = readings.size();
  for (std::size_t k = 0; k < real; ++k) {
    if (readings[k].rx != 2) continue;  // the one that looks at the wall squarely
    Reading ghost = readings[k];
    ghost.ping = readings.size();
    ghost.tx = ghost.rx = 9;
    ghost.outcome = Echo{*echo_range_m(ghost.outcome) + 1.0};
    readings.push_back(ghost);
  }
  const ConsensusEvidence grid = mapped({}, readings);
  EXPECT_GT(tally(grid, "arcs_voted_out"), 20U);
  const auto map = grid.export_map();
  ASSERT_TRUE(map);
  int walls = 0;
  for (const MapPoint& point : map->points.points()) {
    EXPECT_LT(point.position.y, test::wall_y_m + 0.3);
    walls += std::abs(point.position.y - test::wall_y_m) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(walls, 10) << "their rays cleared the wall";
}

/// A drive to and fro, long enough that arcs settle again and again.
std::vector<Reading> long_drive() {
  Rng rng(5);
  std::vector<Reading> readings;
  for (int lap = 0; lap < 8; ++lap)
    for (Reading& reading : test::wall_drive(rng, 80)) {
      reading.ping = readings.size();
      readings.push_back(reading);
    }
  return readings;
}

ConsensusEvidenceOptions short_history() {
  ConsensusEvidenceOptions options;
  options.history = 40;
  options.neighbours = 24;
  return options;
}

TEST(ConsensusEvidence, SettledArcsAndOpenOnesMakeTheSameMapHoweverOftenItIsAsked) {
  const std::vector<Reading> readings = long_drive();
  const ConsensusEvidence batch = mapped(short_history(), readings);
  EXPECT_GT(batch.counters().used, 2000U);
  ConsensusEvidence pieces(short_history());
  InlineExecutor here;
  for (std::size_t k = 0; k < readings.size(); k += 211) {
    pieces.insert(std::span(readings).subspan(k, std::min<std::size_t>(211, readings.size() - k)), here);
    pieces.finish(here);
    pieces.finish(here);
  }
  EXPECT_EQ(pieces.save(), batch.save());
  EXPECT_EQ(pieces.tallies(), batch.tallies());
  const std::uint64_t arcs =
      tally(batch, "arcs_believed") + tally(batch, "arcs_unsure") + tally(batch, "arcs_voted_out");
  EXPECT_EQ(arcs, batch.counters().used) << "every arc is counted once";
  batch.map().for_each_nonzero(
      [&](Cell cell, std::int16_t value) { ASSERT_EQ(pieces.map().value(cell), value) << cell.i << " " << cell.j; });
}

TEST(ConsensusEvidence, RestoresInTheMiddleOfALongDrive) {
  const std::vector<Reading> readings = long_drive();
  const auto half = std::span(readings).first(readings.size() / 2);
  const auto rest = std::span(readings).subspan(readings.size() / 2);
  ConsensusEvidence original = mapped(short_history(), half);
  auto copy = ConsensusEvidence::restore(original.save());
  ASSERT_TRUE(copy);
  InlineExecutor here;
  for (ConsensusEvidence* method : {&original, &*copy}) {
    method->insert(rest, here);
    method->finish(here);
  }
  EXPECT_EQ(copy->save(), original.save());
  std::vector<std::byte> damaged = original.save();
  damaged.resize(damaged.size() / 3);
  EXPECT_FALSE(ConsensusEvidence::restore(damaged));
}

TEST(ConsensusEvidence, TraceForetellsALoneSilenceAndSupportsItsArc) {
  Reading silence = test::monostatic_reading({{}, Angle{}}, NoEcho{});
  silence.trusted_range_m = 1.0;
  const ConsensusEvidence empty;
  const Trace trace = empty.trace(silence);
  EXPECT_FALSE(trace.cells.empty());
  const ConsensusEvidence grid = mapped({}, std::span(&silence, 1));
  for (const CellChange& cell : trace.cells) EXPECT_EQ(grid.cell_log_odds(cell.cell), cell.after);

  const Reading echo = test::monostatic_reading({{}, Angle{}}, Echo{1.0});
  EXPECT_TRUE(empty.supports(echo, {1.0, 0.0}));
  EXPECT_FALSE(empty.supports(echo, {0.5, 0.0}));
  EXPECT_FALSE(empty.supports(silence, {0.5, 0.0}));
}

TEST(ConsensusEvidence, HostileReadingsAreCountedAndChangeNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::vector<Reading> hostile;
  const auto add = [&](auto spoil) {
    for (const Outcome& outcome : {Outcome{Echo{1.0}}, Outcome{NoEcho{}}}) {
      hostile.push_back(test::monostatic_reading({{}, Angle{}}, outcome));
      spoil(hostile.back());
    }
  };
  add([&](Reading& r) { r.T_world_tx.position.x = r.T_world_rx.position.x = nan; });
  add([&](Reading& r) { r.T_world_tx.position.y = r.T_world_rx.position.y = 1e15; });
  add([](Reading& r) { r.beam_width = Angle{}; });
  add([](Reading& r) { r.beam_width = degrees(360.0); });
  hostile.push_back(test::monostatic_reading({{}, Angle{}}, Echo{nan}));
  hostile.push_back(test::monostatic_reading({{}, Angle{}}, Echo{inf}));
  hostile.push_back(test::monostatic_reading({{}, Angle{}}, Echo{-1.0}));
  const ConsensusEvidence grid = mapped({}, hostile);
  EXPECT_EQ(grid.counters().used, 0U);
  int cells = 0;
  grid.map().for_each_nonzero([&](Cell, std::int16_t) { ++cells; });
  EXPECT_EQ(cells, 0);
}

}  // namespace
}  // namespace echoarc
