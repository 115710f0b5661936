// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What tangent consensus assumes of beams, when the log says otherwise than the sensor's makers.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/consensus.hpp"
#include "mapping/consensus/heard_beams.hpp"
#include "mapping/consensus/intake.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

constexpr double pole_y_m = 0.8;
constexpr double pole_every_m = 0.9;

/// Three sensors that state a beam of 15 degrees, 30 degrees apart, drive along a row of poles, and each hears the
/// nearest up to 28 degrees off its axis.
std::vector<Reading> along_poles() {
  Rng rng(4);
  std::vector<Reading> readings;
  for (int k = 0; k < 400; ++k)
    for (int sensor = 0; sensor < 3; ++sensor) {
      const Pose2 T_world_sensor{{0.021 * k, 0.05 * sensor}, degrees(60.0 + 30.0 * sensor)};
      std::optional<double> nearest_m;
      for (int n = -1; n <= 11; ++n) {
        const Vec2 way = Vec2{pole_every_m * n, pole_y_m} - T_world_sensor.position;
        if (abs(wrap(bearing(way) - T_world_sensor.heading)) > degrees(28.0)) continue;
        nearest_m = std::min(nearest_m.value_or(10.0), norm(way));
      }
      if (!nearest_m) continue;
      Reading reading = test::monostatic_reading(T_world_sensor, Echo{*nearest_m + rng.normal(0.0, 0.003)});
      reading.ping = readings.size();
      reading.tx = reading.rx = SensorId(sensor);
      reading.beam_width = degrees(15.0);
      readings.push_back(reading);
    }
  return readings;
}

consensus::BeamPrior heard(const std::vector<Reading>& readings, const ConsensusOptions& options = {}) {
  consensus::ArcTable arcs(options);
  InsertCounters counters;
  for (const Reading& reading : readings)
    if (const auto echo = consensus::echo_of(reading, options, counters)) arcs.add(*echo);
  return heard_beams(arcs, options);
}

Consensus mapped(const std::vector<Reading>& readings, const ConsensusOptions& options) {
  Consensus method(options);
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);
  return method;
}

/// Share of the points within 5 cm of a pole.
double near_poles(const PointMap& map) {
  const auto near = std::ranges::count_if(map.points(), [](const MapPoint& point) {
    const Vec2 pole{pole_every_m * std::round(point.position.x / pole_every_m), pole_y_m};
    return norm(point.position - pole) < 0.05;
  });
  return double(near) / double(map.size());
}

TEST(ConsensusBeams, AreWidenedWhereEchoesComeFromFarBeside) {
  const ConsensusOptions options;
  const consensus::BeamPrior prior = heard(along_poles());
  EXPECT_DOUBLE_EQ(prior.sigma_beams, 2.0 * options.sigma_beams);
  EXPECT_DOUBLE_EQ(prior.search_beams, 2.0 * options.search_beams);
}

TEST(ConsensusBeams, StayAsStatedWhereThatExplainsTheEchoes) {
  Rng rng(3);
  const ConsensusOptions options;
  EXPECT_DOUBLE_EQ(heard(test::wall_drive(rng, 100)).sigma_beams, options.sigma_beams);
  EXPECT_DOUBLE_EQ(heard({}).sigma_beams, options.sigma_beams) << "nothing to go by";
  ConsensusOptions never;
  never.wider_growth = 1e6;
  EXPECT_DOUBLE_EQ(heard(along_poles(), never).sigma_beams, options.sigma_beams);
}

TEST(ConsensusBeams, WiderOnesFindThePoles) {
  ConsensusOptions stated;
  stated.wider_growth = 1e6;
  const Consensus narrow = mapped(along_poles(), stated);
  const Consensus wide = mapped(along_poles(), {});
  ASSERT_GT(wide.map().size(), 100U);
  EXPECT_GT(near_poles(wide.map()), 0.9);
  EXPECT_GT(near_poles(wide.map()), near_poles(narrow.map()) + 0.1);
  const auto times = [](const Consensus& method) {
    const std::vector<Tally> tallies = method.tallies();
    return std::ranges::find(tallies, "times_the_stated_beam", &Tally::name)->count;
  };
  EXPECT_EQ(times(wide), 2U);
  EXPECT_EQ(times(narrow), 1U);
}

/// What the first arcs say holds when they are long forgotten, and the method is asked all the time.
TEST(ConsensusBeams, AreJudgedOnce) {
  ConsensusOptions options;
  options.history = 100;
  options.window_arcs = 1000;
  std::vector<Reading> readings = along_poles();
  ASSERT_GT(readings.size(), 1000U);
  Rng rng(3);
  for (Reading& reading : test::wall_drive(rng, 1000)) {
    reading.ping = readings.size();
    readings.push_back(reading);
  }
  for (const std::size_t step : {100, 100'000}) {
    Consensus method(options);
    InlineExecutor here;
    for (std::size_t k = 0; k < readings.size(); k += step) {
      method.insert(std::span(readings).subspan(k, std::min(step, readings.size() - k)), here);
      method.finish(here);
    }
    ASSERT_GT(method.counters().used, 4 * std::uint64_t(options.window_arcs));
    const std::vector<Tally> tallies = method.tallies();
    EXPECT_EQ(std::ranges::find(tallies, "times_the_stated_beam", &Tally::name)->count, 2U) << step;
  }
}

/// A restored method assumes of its beams what the saved one did.
TEST(ConsensusBeams, AreSaved) {
  const Consensus method = mapped(along_poles(), {});
  const Result<Consensus> restored = Consensus::restore(method.save());
  ASSERT_TRUE(restored);
  ASSERT_EQ(restored->map().size(), method.map().size());
  for (std::size_t k = 0; k < method.map().size(); ++k)
    EXPECT_EQ(restored->map().points()[k].position, method.map().points()[k].position);
}

}  // namespace
}  // namespace echoarc
