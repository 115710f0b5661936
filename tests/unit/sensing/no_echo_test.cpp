// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/no_echo.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

using test::inf;
using test::nan;
using Kind = NoEchoRule::Kind;

/// What a raw value becomes: the outcome's name or the reason's.
std::string verdict(double raw, const NoEchoDecision& decision, const SensorModel& model) {
  const DecodedRange decoded = decode_range(raw, decision, model);
  return std::string(decoded.rejection ? name(*decoded.rejection) : name(decoded.outcome));
}

struct RuleCase {
  NoEchoRule rule;
  // of +Inf, -Inf, NaN, 0, -1, -0.3, 0.1, 2, 4 (the maximum), 4.5, 9, 5110
  std::array<std::string_view, 12> verdicts;
};

class ExplicitRule : public testing::TestWithParam<RuleCase> {};

TEST_P(ExplicitRule, DoesJustWhatItSays) {
  const SensorModel model = test::model_of(0.2, 4.0, GetParam().rule);
  const NoEchoDecision decision = describe_no_echo({0, {}, model});
  constexpr std::array values{inf, -inf, nan, 0.0, -1.0, -0.3, 0.1, 2.0, 4.0, 4.5, 9.0, 5110.0};
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(verdict(values[i], decision, model), GetParam().verdicts[i]) << values[i] << ": " << decision.sentence;
}

constexpr std::string_view no = "no_echo", echo = "echo", near = "too_close", bad = "invalid", low = "below_min_range",
                           high = "above_max_range", wild = "implausible_range";
INSTANTIATE_TEST_SUITE_P(
    NoEcho, ExplicitRule,
    testing::Values(RuleCase{{Kind::inf, 0}, {no, near, bad, low, bad, bad, low, echo, echo, high, wild, wild}},
                    RuleCase{{Kind::nan, 0}, {no, near, no, low, bad, bad, low, echo, echo, high, wild, wild}},
                    RuleCase{{Kind::zero, 0}, {no, near, bad, no, no, no, low, echo, echo, high, wild, wild}},
                    RuleCase{{Kind::max, 0}, {no, near, bad, low, bad, bad, low, echo, no, no, no, no}},
                    RuleCase{{Kind::above, 3.5}, {no, near, bad, low, bad, bad, low, echo, no, no, no, no}},
                    RuleCase{{Kind::above, 8.5}, {no, near, bad, low, bad, bad, low, echo, echo, high, no, no}},
                    RuleCase{{Kind::automatic, 0}, {no, near, bad, no, no, bad, low, echo, no, no, wild, wild}}));

TEST(NoEcho, MinusOneInAnyUnitIsMinusOne) {
  const SensorModel model = test::model_of(0.2, 4.0);
  const NoEchoDecision decision = describe_no_echo({0, {}, model});
  for (const double raw : {-1.0, -0.1, -0.01, -0.001}) EXPECT_EQ(verdict(raw, decision, model), "no_echo") << raw;
  for (const double raw : {-2.0, -0.5, -0.002, -1e300}) EXPECT_EQ(verdict(raw, decision, model), "invalid") << raw;
}

TEST(NoEcho, LimitsWrittenInMillimetresAreHit) {
  const SensorModel model = test::model_of(170 * 0.001, 5110 * 0.001, {Kind::inf, 0});
  const NoEchoDecision decision = describe_no_echo({0, {}, model});
  EXPECT_EQ(verdict(0.17, decision, model), "echo");
  EXPECT_EQ(verdict(5.11, decision, model), "echo");
}

RC_GTEST_PROP(NoEcho, DecodedEchoesAreInRange, (double raw)) {
  const SensorModel model = test::model_of(0.2, 4.0);
  const DecodedRange decoded = decode_range(raw, describe_no_echo({0, {}, model}), model);
  if (const auto range_m = echo_range_m(decoded.outcome))
    RC_ASSERT(!decoded.rejection && *range_m >= 0.2 - 1e-8 && *range_m < 4.0);
  else
    RC_ASSERT(decoded.rejection.has_value() != is_no_echo(decoded.outcome));
}

/// The outcomes of a drive whose silent pings say `silence`, one per ping.
std::vector<std::string> outcomes_with(double silence, NoEchoRule rule) {
  const Log log = test::drive(silence, test::model_of(0.2, 4.0, rule));
  std::vector<std::string> outcomes(log.pings.size(), "rejected");
  for (const Reading& reading : sense(log).readings) {
    const auto range_m = echo_range_m(reading.outcome);
    outcomes[reading.ping] = std::string(name(reading.outcome)) + (range_m ? std::to_string(*range_m) : "");
  }
  return outcomes;
}

TEST(NoEcho, SevenSpellingsOfOneLogAreOneLog) {
  const std::vector<std::string> expected = outcomes_with(inf, {});
  EXPECT_EQ(std::ranges::count(expected, "no_echo"), 34);
  EXPECT_EQ(std::ranges::count(expected, "rejected"), 0);
  EXPECT_EQ(outcomes_with(nan, {Kind::nan, 0}), expected);
  EXPECT_EQ(outcomes_with(0.0, {}), expected);
  EXPECT_EQ(outcomes_with(-1.0, {}), expected);
  EXPECT_EQ(outcomes_with(4.0, {}), expected) << "the maximum";
  EXPECT_EQ(outcomes_with(4.02, {}), expected) << "slightly above the maximum";
  EXPECT_EQ(outcomes_with(10.0, {}), expected) << "a number of the driver's own";
  EXPECT_EQ(outcomes_with(4.0, {Kind::max, 0}), expected);
  EXPECT_EQ(outcomes_with(9.9, {Kind::above, 9.0}), expected);
}

TEST(NoEcho, AutoSaysWhatItDecided) {
  const auto sentence = [](double silence) {
    const Log log = test::drive(silence, test::model_of(0.2, 4.0));
    return decide_no_echo(log.robot.sensors, log.pings)[0].sentence;
  };
  EXPECT_EQ(sentence(10.0),
            "sensor 0: 10 m (8 of 60 readings) is read as no echo: the most frequent value and nothing lies beyond it");
  EXPECT_EQ(sentence(0.0), "sensor 0: 0 (8 of 60 readings) is read as no echo");
  EXPECT_EQ(sentence(-1.0), "sensor 0: -1 (8 of 60 readings) is read as no echo");
  EXPECT_EQ(sentence(inf), "sensor 0: +Inf (8 of 60 readings) is read as no echo (REP 117)");
  EXPECT_EQ(sentence(nan),
            "sensor 0: NaN (8 of 60 readings) is read as a failed measurement; if it means no echo, set no_echo = "
            "\"nan\"");
  EXPECT_EQ(sentence(2.0123).substr(0, 35), "sensor 0: no value stands for no ec") << "others lie beyond 2.0123";
}

TEST(NoEcho, ACodeBelowTheDescribedMaximumIsFound) {
  // A plain log without description: the model says 10.7 m, the sensor's code is 5.11 m.
  Log log = test::drive(5.11, test::model_of(0.2, 5.0));
  std::vector<Sensor> sensors(log.robot.sensors.sensors().begin(), log.robot.sensors.sensors().end());
  for (Sensor& sensor : sensors) sensor.model.range_max_m = 10.7;
  const SensorArray array = SensorArray::make(sensors).value();
  for (const NoEchoDecision& decision : decide_no_echo(array, log.pings)) {
    EXPECT_EQ(decision.code_m, 5.11) << decision.sentence;
    EXPECT_EQ(verdict(5.11, decision, sensors[0].model), "no_echo");
    EXPECT_EQ(verdict(5.10, decision, sensors[0].model), "echo");
    EXPECT_EQ(verdict(5.2, decision, sensors[0].model), "no_echo");
  }
}

TEST(NoEcho, ARobotThatStandsStillHasNoCode) {
  // Every reading is a wall at 2.50 m or the step beside it: frequency alone is no evidence.
  std::vector<Ping> pings;
  for (int k = 0; k < 500; ++k) pings.push_back(test::ping_at(k, 0, k % 50 == 0 ? 2.49 : 2.50));
  const SensorArray array = SensorArray::make({{0, {}, test::model_of(0.2, 4.0)}}).value();
  const NoEchoDecision decision = decide_no_echo(array, pings)[0];
  EXPECT_EQ(verdict(2.50, decision, array.sensors()[0].model), "echo") << decision.sentence;
}

TEST(NoEcho, AFlatWallIsNotACode) {
  std::vector<Ping> pings;
  Rng rng(3);
  for (int k = 0; k < 2000; ++k)  // steps of a centimetre about the farthest wall, spread over five of them
    pings.push_back(test::ping_at(k, 0, k % 2 ? rng.uniform(0.5, 2.0) : std::round(rng.normal(250, 2)) / 100));
  const SensorArray array = SensorArray::make({{0, {}, test::model_of(0.2, 4.0)}}).value();
  EXPECT_TRUE(std::isnan(decide_no_echo(array, pings)[0].code_m));
}

TEST(NoEcho, MillimetresReadAsMetresAreRejectedNotSilence) {
  const Log log = test::drive(5110.0, test::model_of(0.2, 5.0));
  Log wrong = log;
  for (Ping& ping : wrong.pings)
    if (ping.range_m != 5110.0) ping.range_m *= 1000.0;
  const SensingReport report = sense(wrong).report;
  EXPECT_EQ(report.rejected_pings[Rejection::implausible_range].count, wrong.pings.size());
  EXPECT_NE(report.no_echo[0].sentence.find("check the unit"), std::string::npos) << report.no_echo[0].sentence;
}

TEST(NoEcho, AWallFiveKilometresAwayIsImplausible) {
  Log log = test::drive(inf, test::model_of(0.2, 4.0));
  log.pings[9].range_m = 5000.0;
  const SensingReport report = sense(log).report;
  const RejectionTally& tally = report.rejected_pings[Rejection::implausible_range];
  EXPECT_EQ(tally.count, 1U);
  EXPECT_EQ(tally.first_line, log.pings[9].line);
  EXPECT_EQ(tally.first_index, 9U);
  EXPECT_NE(describe(Rejection::implausible_range, tally, "ping").find("unit"), std::string::npos);
}

TEST(NoEcho, SensorsOfOneModelShareTheirEvidence) {
  // Sensor 0 alone met silence often; sensor 1 met it twice and would not be believed by itself.
  std::vector<Ping> pings;
  Rng rng(1);
  for (int k = 0; k < 400; ++k) {
    pings.push_back(test::ping_at(k, 0, k % 2 ? 9.9 : rng.uniform(0.3, 3.9)));
    pings.push_back(test::ping_at(k, 1, k % 200 == 7 ? 9.9 : rng.uniform(0.3, 3.9)));
  }
  const SensorArray array = SensorArray::make(row(2, 0.1, 0.0, test::model_of(0.2, 4.0))).value();
  const auto decisions = decide_no_echo(array, pings);
  EXPECT_EQ(decisions[1].code_m, 9.9) << decisions[1].sentence;
  EXPECT_NE(decisions[1].sentence.find("9.9 m (2 of 400 readings)"), std::string::npos) << decisions[1].sentence;
}

RC_GTEST_PROP(NoEcho, DecisionsDependOnValuesNotOnOrder, (std::vector<std::uint8_t> values, std::uint64_t seed)) {
  std::vector<Ping> pings;
  for (const std::uint8_t value : values) pings.push_back(test::ping_at(0, value % 2, value * 0.05));
  const SensorArray array = SensorArray::make(row(2, 0.1, 0.0, test::model_of(0.2, 4.0))).value();
  const auto forward = decide_no_echo(array, pings);
  Rng rng(seed);
  for (std::size_t i = pings.size(); i > 1; --i) std::swap(pings[i - 1], pings[rng.below(i)]);
  const auto shuffled = decide_no_echo(array, pings);
  for (std::size_t k = 0; k < 2; ++k) RC_ASSERT(forward[k].sentence == shuffled[k].sentence);
}

}  // namespace
}  // namespace echoarc
