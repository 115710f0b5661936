// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/io/jsonl.hpp"
#include "log_text.hpp"

namespace echoarc::io {
namespace {

/// Equal bit for bit, but for the payload of a NaN.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}
bool same(const Odometry& a, const Odometry& b) {
  return same(a.time_s, b.time_s) && a.T_world_robot == b.T_world_robot;
}
bool same(const Ping& a, const Ping& b) {
  return same(a.time_s, b.time_s) && a.tx == b.tx && a.rx == b.rx && same(a.range_m, b.range_m) &&
         same(a.time_of_flight_s, b.time_of_flight_s) && a.echo_index == b.echo_index && a.cause == b.cause;
}
bool same(const Scan& a, const Scan& b) {
  const auto same_beam = [](float p, float q) { return same(p, q); };
  return same(a.time_s, b.time_s) && a.laser == b.laser && a.angle_min == b.angle_min && a.angle_step == b.angle_step &&
         std::ranges::equal(a.ranges_m, b.ranges_m, same_beam);
}
bool same(const Poll& a, const Poll& b) {
  const auto same_register = [](double p, double q) { return same(p, q); };
  return same(a.time_s, b.time_s) && std::ranges::equal(a.ranges_m, b.ranges_m, same_register);
}
bool same(const WallNote& a, const WallNote& b) {
  return same(a.time_s, b.time_s) && a.side == b.side;
}
template <class Record>
bool same(const std::vector<Record>& a, const std::vector<Record>& b) {
  return std::ranges::equal(a, b, [](const Record& p, const Record& q) { return same(p, q); });
}
bool same(const Log& a, const Log& b) {
  return a.frame == b.frame && same(a.temperature_k, b.temperature_k) && a.robot == b.robot &&
         same(a.odometry, b.odometry) && same(a.pings, b.pings) && same(a.scans, b.scans) && same(a.polls, b.polls) &&
         same(a.truth, b.truth) && same(a.walls, b.walls) && a.unknown_lines == b.unknown_lines;
}

Result<Log> write_and_read(const Log& log) {
  StringSink sink;
  if (const auto written = write_jsonl(log, sink); !written) return written.error();
  return read_text(sink.text());
}

double any_finite() {
  // All bit patterns: subnormal numbers, -0 and numbers of 17 digits are where a printer fails.
  const auto value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isfinite(value) ? value : *rc::gen::arbitrary<double>();
}
double any_range() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  switch (*rc::gen::inRange(0, 6)) {
    case 0: return inf;
    case 1: return -inf;
    case 2: return std::numeric_limits<double>::quiet_NaN();
    default: return any_finite();
  }
}
float any_beam() {
  const auto value = static_cast<float>(*rc::gen::inRange(0, 80'000)) / 1000.0F;
  return *rc::gen::inRange(0, 5) == 0 ? std::numeric_limits<float>::quiet_NaN() : value;
}

template <class Make>
auto some_of(const Make& make) {
  std::vector<decltype(make())> records(*rc::gen::inRange<std::size_t>(0, 6));
  for (auto& record : records) record = make();
  return records;
}

Sensor any_sensor(SensorId id) {
  Sensor sensor;
  sensor.id = id;
  sensor.mount = {
      *rc::gen::inRange(-900, 900) / 7.0, 0.1, -0.3, radians(0.1), radians(any_finite()), radians(1.0 / 3.0)};
  sensor.model.beam_width = degrees(*rc::gen::inRange(1, 179));
  sensor.model.range_max_m = 1.0 + *rc::gen::inRange(0, 900) / 11.0;
  sensor.model.preset = *rc::gen::element<std::string>("", "hc-sr04", "my own \"one\"");
  sensor.model.no_echo = *rc::gen::element(
      NoEchoRule{}, NoEchoRule{NoEchoRule::Kind::inf}, NoEchoRule{NoEchoRule::Kind::nan},
      NoEchoRule{NoEchoRule::Kind::zero}, NoEchoRule{NoEchoRule::Kind::max}, NoEchoRule{NoEchoRule::Kind::above, 5.11});
  return sensor;
}

Log any_log() {
  Log log;
  log.frame = *rc::gen::element<std::string>("odom", "map", "a \"quoted\"\n frame \xC3\xA9");
  log.temperature_k = any_finite();
  std::vector<Sensor> sensors;
  for (SensorId id = 0; id < *rc::gen::inRange<SensorId>(0, 4); ++id) sensors.push_back(any_sensor(5 * id));
  log.robot.sensors = SensorArray::make(sensors).value();
  const auto pose = [] { return Odometry{any_finite(), {{any_finite(), any_finite()}, radians(any_finite())}, 0}; };
  log.odometry = some_of(pose);
  log.truth = some_of(pose);
  log.pings = some_of([] {
    return Ping{any_finite(),
                *rc::gen::arbitrary<SensorId>(),
                *rc::gen::arbitrary<SensorId>(),
                any_range(),
                *rc::gen::element(0.01, std::numeric_limits<double>::quiet_NaN()),
                *rc::gen::inRange(0U, 3U),
                *rc::gen::element(EchoCause::unknown, EchoCause::wall, EchoCause::cross_talk, EchoCause::outlier),
                0};
  });
  log.scans =
      some_of([] { return Scan{any_finite(), 1, radians(any_finite()), radians(any_finite()), some_of(any_beam), 0}; });
  log.polls = some_of([] { return Poll{any_finite(), some_of(any_range), 0}; });
  log.walls = some_of(
      [] { return WallNote{any_finite(), *rc::gen::element(WallSide::unknown, WallSide::left, WallSide::right), 0}; });
  log.unknown_lines = some_of([] { return std::string(R"({"type":"bumper","t":1,"left":true})"); });
  return log;
}

RC_GTEST_PROP(WriteJsonl, ReadsBackEqual, ()) {
  const Log log = any_log();
  const Result<Log> back = write_and_read(log);
  RC_ASSERT(back.has_value());
  RC_ASSERT(same(log, *back));
  RC_ASSERT(back->report.bad_lines == 0U);
}

TEST(WriteJsonl, MergesRecordsByTime) {
  Log log;
  log.odometry = {{0.0, {}, 0}, {1.0, {}, 0}};
  log.pings = {{.time_s = 0.5, .range_m = 0.1}, {.time_s = 1.0, .range_m = std::numeric_limits<double>::infinity()}};
  StringSink sink;
  ASSERT_TRUE(write_jsonl(log, sink));
  const std::string body = sink.text().substr(sink.text().find('\n') + 1);
  EXPECT_EQ(body,
            "{\"type\":\"odom\",\"t\":0,\"x\":0,\"y\":0,\"yaw\":0}\n"
            "{\"type\":\"ping\",\"t\":0.5,\"tx\":0,\"rx\":0,\"range\":0.1}\n"
            "{\"type\":\"odom\",\"t\":1,\"x\":0,\"y\":0,\"yaw\":0}\n"
            "{\"type\":\"ping\",\"t\":1,\"tx\":0,\"rx\":0,\"range\":\"no_echo\"}\n");
}

TEST(WriteJsonl, NumbersThatJsonCannotSayAreAnError) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  StringSink sink;
  for (const double bad : {nan, inf, -inf}) {
    Log pose;
    pose.odometry = {{0.0, {{bad, 0.0}, {}}, 0}};
    EXPECT_FALSE(write_jsonl(pose, sink));
    Log time;
    time.pings = {{.time_s = bad, .range_m = 1.0}, {.time_s = 0.0, .range_m = 1.0}};
    EXPECT_FALSE(write_jsonl(time, sink));
    Log header;
    header.source = "drive.csv";
    header.temperature_k = bad;
    const Result<void> written = write_jsonl(header, sink);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().where, "drive.csv");
  }
}

class FailingSink final : public ByteSink {
 public:
  Result<void> write(std::string_view) override { return Error{ErrorCode::unwritable, "disk full", "x", "free some"}; }
};

TEST(WriteJsonl, PassesOnWhatTheSinkSays) {
  FailingSink sink;
  const Result<void> written = write_jsonl(Log{}, sink);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "disk full");
}

}  // namespace
}  // namespace echoarc::io
