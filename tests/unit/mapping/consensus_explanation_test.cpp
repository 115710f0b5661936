// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/consensus_explanation.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/consensus.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A drive past a wall, its pings numbered.
std::vector<Reading> drive() {
  Rng rng(7);
  std::vector<Reading> readings = test::wall_drive(rng, 12);
  for (std::size_t k = 0; k < readings.size(); ++k) readings[k].ping = k;
  return readings;
}

EchoExplanation explained(const std::vector<Reading>& readings, const ConsensusOptions& options, PingId ping) {
  InlineExecutor here;
  return explain_echo(readings, options, ping, here).value();
}

TEST(ConsensusExplanation, SaysWhatTheMapHolds) {
  const std::vector<Reading> readings = drive();
  InlineExecutor here;
  Consensus method;
  method.insert(readings, here);
  method.finish(here);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < method.map().size() && compared < 5; ++k) {
    const MapPoint& point = method.map().points()[k];
    if (point.label != PointLabel::wall) continue;
    const EchoExplanation why = explained(readings, {}, point.ping);
    EXPECT_NEAR(norm(why.position - point.position), 0.0, 1e-9);
    EXPECT_EQ(why.sweeps.size(), 2U);
    EXPECT_GT(why.sweeps.back().wall_share, 0.5);
    ++compared;
  }
  EXPECT_EQ(compared, 5U);
}

/// Q_W p_w : Q_P (1 - p_w) is e^(L_W - L_P), whose terms are the voices.
TEST(ConsensusExplanation, VoicesAddUpToTheOdds) {
  const ConsensusOptions options;
  const std::vector<Reading> readings = drive();
  std::size_t compared = 0;
  for (const Reading& reading : readings) {
    InlineExecutor here;
    const auto answer = explain_echo(readings, options, reading.ping, here);
    if (!answer || compared == 20) continue;
    const SweepBelief& last = answer->sweeps.back();
    EXPECT_NEAR(sum(answer->prior), 1.0, 1e-5);
    EXPECT_NEAR(sum(last.wall), 1.0, 1e-5);
    EXPECT_NEAR(sum(last.point), 1.0, 1e-5);
    EXPECT_EQ(answer->bearings.size(), last.wall.size());
    const auto k = std::size_t(std::lround(answer->t / options.step) + long(answer->bearings.size() / 2));
    double odds = 0.0;
    for (const NeighbourVoice& voice : answer->voices)
      odds += options.independence * (voice.wall - voice.point) + voice.wall_free - voice.point_free;
    odds *= answer->neighbour_weight;
    const double share = last.wall_share;
    if (share < 0.051 || share > 0.949 || last.point[k] < 1e-6 || last.wall[k] < 1e-6) continue;  // clipped
    EXPECT_NEAR(std::log(last.wall[k] * share / (last.point[k] * (1.0 - share))), odds, 1e-3);
    ++compared;
  }
  EXPECT_GT(compared, 4U);
}

TEST(ConsensusExplanation, SaysWhyThereIsNone) {
  InlineExecutor here;
  std::vector<Reading> readings = drive();
  readings.push_back(readings.back());
  readings.back().ping = 1000;
  readings.push_back(readings.back());
  readings.back().ping = 1001;
  readings.back().outcome = NoEcho{};
  EXPECT_NE(explain_echo(readings, {}, 5000, here).error().message.find("no such ping"), std::string::npos);
  EXPECT_NE(explain_echo(readings, {}, 1000, here).error().message.find("says the same"), std::string::npos);
  EXPECT_NE(explain_echo(readings, {}, 1001, here).error().message.find("no echo"), std::string::npos);
  EXPECT_FALSE(explain_echo({}, {}, 0, here));
}

TEST(ConsensusExplanation, AnArcAloneKeepsItsBeam) {
  const std::vector<Reading> readings{test::monostatic_reading({}, Echo{1.0})};
  const EchoExplanation why = explained(readings, {}, readings[0].ping);
  EXPECT_TRUE(why.voices.empty());
  EXPECT_NEAR(why.t.rad(), 0.0, 1e-6);
  for (std::size_t k = 0; k < why.prior.size(); ++k) EXPECT_NEAR(why.sweeps.back().wall[k], why.prior[k], 1e-6);
}

}  // namespace
}  // namespace echoarc
