// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Where the robot truly was when a ping was fired.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "echoarc/live/inquiry.hpp"
#include "echoarc/live/truth_log.hpp"
#include "unit/live/mapper_fixture.hpp"

namespace echoarc::live {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(TruthLog, IsInterpolatedBetweenItsPosesAndNotBeyond) {
  TruthLog truth;
  EXPECT_FALSE(truth.at(0.0));
  truth.push({1.0, {{0.0, 0.0}, degrees(170.0)}});
  truth.push({3.0, {{4.0, 2.0}, degrees(-170.0)}});
  const auto middle = truth.at(1.5);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->position.x, 1.0, 1e-12);
  EXPECT_NEAR(middle->position.y, 0.5, 1e-12);
  EXPECT_NEAR(wrap(middle->heading - degrees(175.0)).deg(), 0.0, 1e-9) << "by the shorter turn";
  EXPECT_EQ(truth.at(3.0)->position.x, 4.0);
  EXPECT_EQ(truth.at(1.0)->position.x, 0.0);
  EXPECT_FALSE(truth.at(0.999));
  EXPECT_FALSE(truth.at(3.001));
  EXPECT_FALSE(truth.at(nan));
}

TEST(TruthLog, TakesNeitherNonsenseNorThePast) {
  TruthLog truth;
  truth.push({nan, {}});
  truth.push({1.0, {{nan, 0.0}, {}}});
  truth.push({1.0, {{0.0, 0.0}, radians(std::numeric_limits<double>::infinity())}});
  EXPECT_FALSE(truth.at(1.0));
  truth.push({2.0, {{2.0, 0.0}, {}}});
  truth.push({1.0, {{1.0, 0.0}, {}}});
  truth.push({2.0, {{5.0, 0.0}, {}}});
  EXPECT_FALSE(truth.at(1.0));
  EXPECT_EQ(truth.at(2.0)->position.x, 2.0);
}

TEST(TruthLog, ACopyStaysAsItWas) {
  TruthLog truth;
  for (int k = 0; k <= 1500; ++k) truth.push({double(k), {{double(k), 0.0}, {}}});
  const TruthLog copy = truth;
  truth.push({1501.0, {{7.0, 0.0}, {}}});
  EXPECT_FALSE(copy.at(1501.0));
  EXPECT_EQ(copy.at(1023.5)->position.x, 1023.5) << "over the end of a chunk";
  EXPECT_EQ(truth.at(1501.0)->position.x, 7.0);
}

TEST(Truth, IsToldWithTheStepThatItBelongsTo) {
  const test::Played played = test::play(test::demo_log_until(6.0));
  ASSERT_TRUE(played.description.has_truth);
  InlineExecutor executor;
  auto mapper = Mapper::make(played.description, {}, std::vector<MethodChoice>{{"evidence", {}}}, executor).value();
  for (const Record& record : played.records) mapper.push(record);
  mapper.end_of_records();
  Evidence evidence;
  evidence.readings = mapper.readings();
  evidence.methods = {{"evidence", {}}};
  evidence.maps = {nullptr};
  evidence.truth = mapper.truth();
  const JudgedPing& ping = evidence.readings[evidence.readings.size() / 2];
  const auto step = step_ping(evidence, "evidence", ping.reading.ping);
  ASSERT_TRUE(step && step->T_world_true);
  const double off_m = norm(step->T_world_true->position - ping.reading.T_world_robot.position);
  EXPECT_LT(off_m, 0.2) << "odometry drifts, but not as fast";
  EXPECT_EQ(step->T_world_true->position, evidence.truth.at(ping.reading.time_s)->position);
  mapper.restart();
  EXPECT_FALSE(mapper.truth().at(ping.reading.time_s));
  evidence.truth.clear();
  EXPECT_FALSE(step_ping(evidence, "evidence", ping.reading.ping)->T_world_true) << "not known";
}

}  // namespace
}  // namespace echoarc::live
