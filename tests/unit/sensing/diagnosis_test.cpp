// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

std::optional<Finding> find(const std::vector<Finding>& findings, std::string_view name) {
  const auto found = std::ranges::find(findings, name, &Finding::name);
  return found == findings.end() ? std::nullopt : std::optional{*found};
}

/// A drive without faults: see `test::drive`.
Log healthy() {
  return test::drive(test::inf, test::model_of(0.2, 4.0));
}

/// Asserts that `spoil` makes a healthy log show the finding, and that nothing else does.
void expect_finding(std::string_view name, Severity severity, const std::function<void(Log&)>& spoil,
                    std::string_view part = "") {
  EXPECT_FALSE(find(diagnose(healthy()), name)) << name << " in a healthy log";
  Log log = healthy();
  spoil(log);
  const std::optional<Finding> finding = find(diagnose(log), name);
  ASSERT_TRUE(finding) << name;
  EXPECT_EQ(finding->severity, severity) << name;
  EXPECT_NE(finding->message.find(part), std::string::npos) << finding->message;
  EXPECT_FALSE(finding->remedy.empty());
}

void for_sensor(Log& log, SensorId sensor, const std::function<void(Ping&)>& change) {
  for (Ping& ping : log.pings)
    if (ping.rx == sensor) change(ping);
}

Sensor with_model(const std::function<void(Sensor&)>& change) {
  Sensor sensor{0, {.z_m = 0.0}, test::model_of(0.2, 4.0)};
  change(sensor);
  return sensor;
}

RobotDescription robot_of(std::vector<Sensor> sensors) {
  RobotDescription robot;
  robot.sensors = SensorArray::make(std::move(sensors)).value();
  return robot;
}

TEST(Diagnosis, HealthyLogHasNotesAlone) {
  for (const Finding& finding : diagnose(healthy()))
    EXPECT_EQ(finding.severity, Severity::note) << finding.name << ": " << finding.message;
}

TEST(Diagnosis, Clocks) {
  expect_finding("zero_stamps", Severity::error, [](Log& log) {
    for (std::size_t k = 0; k < log.pings.size(); k += 2) log.pings[k].time_s = 0.0;
  });
  expect_finding("separate_clocks", Severity::error, [](Log& log) {
    for (Ping& ping : log.pings) ping.time_s += 1.6e9;
  });
  expect_finding("separate_clocks", Severity::warning, [](Log& log) {
    for (Ping& ping : log.pings) ping.time_s += 8.0;
  });
  // Four sweeps are read from the buffer at once.
  expect_finding(
      "receive_time_stamps", Severity::warning,
      [](Log& log) {
        for (Ping& ping : log.pings)
          ping.time_s = std::ceil(ping.time_s) + 0.001 * (ping.time_s - std::floor(ping.time_s));
      },
      "sensors 0-3");
  expect_finding("repeated_stamps", Severity::warning, [](Log& log) {
    for (Ping& ping : log.pings) ping.time_s = std::floor(ping.time_s);
  });
  expect_finding("slow_pings", Severity::warning, [](Log& log) {
    for (Ping& ping : log.pings) ping.time_s *= 1000.0;
  });
}

TEST(Diagnosis, Odometry) {
  expect_finding("no_odometry", Severity::error, [](Log& log) { log.odometry.clear(); });
  expect_finding("odometry_too_fast", Severity::warning, [](Log& log) {
    for (Odometry& sample : log.odometry) sample.T_world_robot.position = 1000.0 * sample.T_world_robot.position;
  });
  expect_finding(
      "pose_jumps", Severity::warning,
      [](Log& log) {
        for (std::size_t k = 80; k < log.odometry.size(); ++k) log.odometry[k].T_world_robot.position.x += 3.0;
      },
      "first at line 161");
  expect_finding("odometry_turns_too_fast", Severity::warning, [](Log& log) {
    for (Odometry& sample : log.odometry)
      sample.T_world_robot.heading = radians(2.0 * sample.T_world_robot.heading.deg());
  });
  expect_finding("robot_stands_still", Severity::warning, [](Log& log) {
    for (Odometry& sample : log.odometry) sample.T_world_robot.position = {};
  });
  expect_finding("odometry_sparse", Severity::note, [](Log& log) {
    std::vector<Odometry> few;
    for (std::size_t k = 0; k < log.odometry.size(); k += 30) few.push_back(log.odometry[k]);
    log.odometry = few;
  });
}

TEST(Diagnosis, Units) {
  for (const auto& [factor, unit] : {std::pair{1000.0, "millimetres"}, std::pair{100.0, "centimetres"}})
    expect_finding(
        "wrong_unit", Severity::error,
        [factor = factor](Log& log) {
          for (Ping& ping : log.pings) ping.range_m *= factor;
        },
        unit);
}

TEST(Diagnosis, Sensors) {
  expect_finding(
      "sensor_missing", Severity::warning,
      [](Log& log) { std::erase_if(log.pings, [](const Ping& ping) { return ping.rx == 2; }); }, "sensor 2 never");
  expect_finding(
      "sensor_not_described", Severity::warning,
      [](Log& log) { for_sensor(log, 1, [](Ping& ping) { ping.tx = ping.rx = 9; }); }, "sensor 9 ");
  expect_finding(
      "never_an_echo", Severity::warning,
      [](Log& log) { for_sensor(log, 0, [](Ping& ping) { ping.range_m = test::inf; }); }, "sensor 0 ");
  expect_finding(
      "sensor_stuck", Severity::warning, [](Log& log) { for_sensor(log, 3, [](Ping& ping) { ping.range_m = 1.25; }); },
      "sensor 3 ");
  expect_finding(
      "sensors_alike", Severity::warning,
      [](Log& log) {
        for (std::size_t k = 0; k < log.pings.size(); k += 4) log.pings[k + 3].range_m = log.pings[k].range_m;
      },
      "sensors 0,3 ");
  expect_finding("hears_floor", Severity::warning, [](Log& log) {
    std::vector<Sensor> sensors(log.robot.sensors.sensors().begin(), log.robot.sensors.sensors().end());
    for (Sensor& sensor : sensors) sensor.mount.z_m = 0.3;
    log.robot.sensors = SensorArray::make(sensors).value();
    const double floor_m = 0.3 / std::sin(degrees(12.5).rad());
    Rng rng(7);
    for_sensor(log, 1, [&](Ping& ping) { ping.range_m = floor_m + rng.uniform(-0.01, 0.01); });
  });
}

TEST(Diagnosis, RejectionsAreGraveByTheirShare) {
  const auto severity_of = [](std::size_t every) {
    Log log = healthy();
    for (std::size_t k = 0; k < log.pings.size(); k += every) log.pings[k].range_m = test::nan;
    return find(diagnose(log), "invalid").value().severity;
  };
  EXPECT_EQ(severity_of(200), Severity::note);
  EXPECT_EQ(severity_of(10), Severity::warning);
  EXPECT_EQ(severity_of(1), Severity::error);
}

TEST(Diagnosis, GravestFirst) {
  Log log = healthy();
  log.odometry.clear();
  const std::vector<Finding> findings = diagnose(log);
  EXPECT_TRUE(std::ranges::is_sorted(findings, std::greater{}, &Finding::severity));
  EXPECT_EQ(findings.front().severity, Severity::error);
}

TEST(Diagnosis, FloorInTheBeam) {
  const auto floor_of = [](double z_m, Angle pitch, Angle beam) {
    return find(diagnose(robot_of({with_model([&](Sensor& s) {
                  s.mount.z_m = z_m;
                  s.mount.pitch = pitch;
                  s.model.beam_width = beam;
                })})),
                "floor_in_beam");
  };
  // z / sin(pitch + beam/2): 0.25 m / sin 15 deg = 0.97 m; nose 15 deg down: 0.25 m / sin 30 deg = 0.5 m.
  EXPECT_NE(floor_of(0.25, {}, degrees(30)).value().message.find("at 0.97 m"), std::string::npos);
  EXPECT_NE(floor_of(0.25, degrees(15), degrees(30)).value().message.find("at 0.5 m"), std::string::npos);
  EXPECT_FALSE(floor_of(0.25, degrees(-15), degrees(30))) << "the lower edge is level";
  EXPECT_FALSE(floor_of(0.0, {}, degrees(30))) << "no height is given";
  EXPECT_FALSE(floor_of(1.2, {}, degrees(30))) << "the floor is out of reach";
}

TEST(Diagnosis, Descriptions) {
  const auto finds = [](std::string_view name, const std::function<void(Sensor&)>& change) {
    return find(diagnose(robot_of({with_model(change)})), name).has_value();
  };
  EXPECT_TRUE(finds("beam_narrow", [](Sensor& s) { s.model.beam_width = radians(0.01); }));
  EXPECT_TRUE(finds("beam_wide", [](Sensor& s) { s.model.beam_width = degrees(120); }));
  EXPECT_TRUE(finds("no_minimum_range", [](Sensor& s) { s.model.range_min_m = 0.0; }));
  EXPECT_TRUE(finds("maximum_range_large", [](Sensor& s) { s.model.range_max_m = 400.0; }));
  EXPECT_TRUE(finds("mount_far", [](Sensor& s) { s.mount.x_m = 120.0; }));
  EXPECT_TRUE(diagnose(robot_of({with_model([](Sensor&) {})})).empty());
  EXPECT_TRUE(find(diagnose(RobotDescription{}), "no_sensors"));
}

TEST(Diagnosis, SharedMountsAreToldOnce) {
  std::vector<Sensor> sensors(100, with_model([](Sensor&) {}));
  for (SensorId k = 0; k < 100; ++k) sensors[k].id = k;
  const std::vector<Finding> findings = diagnose(robot_of(sensors));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_NE(findings[0].message.find("sensors 0-99"), std::string::npos) << findings[0].message;
}

TEST(Diagnosis, SensorsThatAreReadAlikeAreToldTogether) {
  const Log log = test::drive(5.11, test::model_of(0.2, 4.0));
  const std::vector<std::string> sentences = no_echo_sentences(decide_no_echo(log.robot.sensors, log.pings));
  ASSERT_EQ(sentences.size(), 1U);
  EXPECT_TRUE(sentences[0].starts_with("sensors 0-3: 5.11 m is read as no echo")) << sentences[0];
}

TEST(Diagnosis, SurvivesNumbersThatAreNone) {
  Log log = healthy();
  for (std::size_t k = 0; k < log.pings.size(); k += 3) log.pings[k].time_s = test::nan;
  for (std::size_t k = 0; k < log.odometry.size(); k += 3) log.odometry[k].T_world_robot.position.x = test::inf;
  log.pings[1].range_m = std::numeric_limits<double>::max();
  log.pings[2].time_s = -std::numeric_limits<double>::max();
  for (const Finding& finding : diagnose(log)) EXPECT_FALSE(finding.message.empty()) << finding.name;
}

}  // namespace
}  // namespace echoarc
