// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/robot_toml.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

RobotDescription robot_of(std::string_view text) {
  const auto robot = parse_robot_toml(text, "robot.toml");
  EXPECT_TRUE(robot) << robot.error().where << ": " << robot.error().message;
  return robot ? *robot : RobotDescription{};
}

TEST(RobotToml, ExplicitSensorsWithOwnNumbers) {
  const RobotDescription robot = robot_of(R"(
name = "cart"
radius_m = 0.2
[[sensors]]
id = 3
x = 0.1
y_m = -0.05
z = 0.3
yaw_deg = 90
pitch = 0.1
beam_width_deg = 30
range_min = 0.02
range_max_m = 4
trusted_range = 2.5
no_echo = { above = 3.9 }
[[sensors]]
[[lasers]]
x = 0.125
range_max = 10
)");
  EXPECT_EQ(robot.name, "cart");
  EXPECT_EQ(robot.radius_m, 0.2);
  ASSERT_EQ(robot.sensors.size(), 2U);
  const Sensor& sensor = *robot.sensors.find(3);
  EXPECT_EQ(sensor.mount.x_m, 0.1);
  EXPECT_EQ(sensor.mount.y_m, -0.05);
  EXPECT_EQ(sensor.mount.z_m, 0.3);
  EXPECT_NEAR(sensor.mount.yaw.rad(), std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(sensor.mount.pitch.rad(), 0.1);
  EXPECT_NEAR(sensor.model.beam_width.deg(), 30.0, 1e-12);
  EXPECT_EQ(sensor.model.range_min_m, 0.02);
  EXPECT_EQ(sensor.model.range_max_m, 4.0);
  EXPECT_EQ(sensor.model.trusted_range_m, 2.5);
  EXPECT_EQ(sensor.model.no_echo, (NoEchoRule{NoEchoRule::Kind::above, 3.9}));
  EXPECT_NE(robot.sensors.find(4), nullptr) << "an id that is left out counts on";
  ASSERT_EQ(robot.lasers.size(), 1U);
  EXPECT_EQ(robot.lasers[0].mount.x_m, 0.125);
  EXPECT_EQ(robot.lasers[0].range_max_m, 10.0);
}

TEST(RobotToml, ARingLooksOutward) {
  const RobotDescription robot = robot_of(R"(ring = { count = 4, radius_m = 0.2, start_deg = 90, range_max = 5 })");
  ASSERT_EQ(robot.sensors.size(), 4U);
  const Pose2 T_robot_sensor = robot.sensors.find(1)->mount.T_robot_sensor();
  EXPECT_NEAR(T_robot_sensor.position.x, -0.2, 1e-12);
  EXPECT_NEAR(T_robot_sensor.position.y, 0.0, 1e-12);
  EXPECT_NEAR(wrap(T_robot_sensor.heading).deg(), 180.0, 1e-9);
  EXPECT_EQ(robot.sensors.find(1)->model.range_max_m, 5.0);
}

TEST(RobotToml, SeveralGroupsCountOn) {
  const RobotDescription robot = robot_of(R"(
[[row]]
count = 2
spacing_m = 0.1
[[row]]
count = 1
[[row]]
count = 1
first_id = 10
)");
  ASSERT_EQ(robot.sensors.size(), 4U);
  EXPECT_EQ(robot.sensors.sensors()[2].id, 2U);
  EXPECT_EQ(robot.sensors.sensors()[3].id, 10U);
}

TEST(RobotToml, DefaultsPresetsAndOwnNumbersInThisOrder) {
  const RobotDescription robot = robot_of(R"(
[sensor_defaults]
beam_width_deg = 40
no_echo = "max"
[[sensors]]
[[sensors]]
preset = "hc-sr04"
range_max = 1.0
)");
  EXPECT_NEAR(robot.sensors.find(0)->model.beam_width.deg(), 40.0, 1e-12);
  EXPECT_EQ(robot.sensors.find(0)->model.no_echo.kind, NoEchoRule::Kind::max);
  SensorModel expected = sensor_preset("hc-sr04").value();
  expected.range_max_m = 1.0;
  expected.trusted_range_m = std::min(expected.trusted_range_m, 1.0);
  EXPECT_EQ(robot.sensors.find(1)->model, expected);
}

TEST(RobotToml, EverySpellingOfNoEcho) {
  const std::pair<std::string_view, NoEchoRule> cases[] = {
      {R"("auto")", {NoEchoRule::Kind::automatic}},
      {R"("inf")", {NoEchoRule::Kind::inf}},
      {R"("nan")", {NoEchoRule::Kind::nan}},
      {R"("zero")", {NoEchoRule::Kind::zero}},
      {R"("max")", {NoEchoRule::Kind::max}},
      {"{ above = 5.0 }", {NoEchoRule::Kind::above, 5.0}},
      {"{ above_m = 5 }", {NoEchoRule::Kind::above, 5.0}},
  };
  for (const auto& [text, rule] : cases)
    EXPECT_EQ(robot_of("[[sensors]]\nno_echo = " + std::string(text)).sensors.find(0)->model.no_echo, rule) << text;
}

TEST(RobotToml, AWholeArrayByName) {
  for (const ArrayPreset& preset : array_presets())
    EXPECT_EQ(robot_of("array = \"" + std::string(preset.name) + "\"").sensors, *array_preset(preset.name));
}

TEST(RobotToml, TheTemplateReadsBackForEveryPreset) {
  for (const SensorPreset& preset : sensor_presets())
    for (const SensorLayout layout : {SensorLayout::ring, SensorLayout::row}) {
      const auto text = robot_toml_template(preset.name, 5, layout);
      ASSERT_TRUE(text);
      const RobotDescription robot = robot_of(*text);
      ASSERT_EQ(robot.sensors.size(), 5U) << preset.name;
      SensorModel expected = sensor_preset(preset.name).value();
      expected.no_echo = {};
      EXPECT_EQ(robot.sensors.find(4)->model, expected) << preset.name;
    }
}

/// Every commented setting of the template, with the comment sign taken away, is legal, too.
TEST(RobotToml, TheTemplatesCommentsAreLegalSettings) {
  std::string text = robot_toml_template("hc-sr04", 3, SensorLayout::ring).value();
  for (const char* key : {"beam_width_deg", "range_min", "range_max", "trusted_range", "[[sensors]]", "id", "x", "y",
                          "z", "yaw_deg", "pitch_deg", "preset", "[[lasers]]"})
    for (std::size_t at = 0; (at = text.find("\n# " + std::string(key), at)) != std::string::npos;)
      text.erase(at + 1, 2);
  const RobotDescription robot = robot_of(text);
  ASSERT_EQ(robot.sensors.size(), 4U) << text;
  EXPECT_EQ(robot.lasers.size(), 1U);
  ASSERT_NE(robot.sensors.find(0), nullptr);
  EXPECT_EQ(robot.sensors.find(0)->model.range_max_m, sensor_preset("hc-sr04")->range_max_m);
}

TEST(RobotToml, TheTemplateRefusesAbsurdWishes) {
  EXPECT_FALSE(robot_toml_template("hc-sr05", 4, SensorLayout::ring));
  EXPECT_FALSE(robot_toml_template("hc-sr04", 0, SensorLayout::ring));
  EXPECT_FALSE(robot_toml_template("hc-sr04", 1'000'000, SensorLayout::row));
}

struct BadToml {
  std::string_view text;
  std::string_view message;
  std::string_view where;
};

TEST(RobotToml, ErrorsNameLineAndRemedy) {
  const BadToml cases[] = {
      {"name = 3\n[[sensors]]\n", "name of robot has the wrong type", "robot.toml:1"},
      {"nam = \"a\"\n[[sensors]]\n", "there is no key nam in robot", "robot.toml:1"},
      {"[[sensors]]\nx = \"0.1\"\n", "x of sensor has the wrong type", "robot.toml:2"},
      {"[[sensors]]\nyaw = 1\nyaw_deg = 2\n", "sensor gives both yaw and yaw_deg", "robot.toml:3"},
      {"[[sensors]]\n[[sensors]]\nfov = 15\n", "there is no key fov in sensor", "robot.toml:3"},
      {"sensors = 8\n", "sensors of robot has the wrong type", "robot.toml:1"},
      {"[[sensors]]\nx = nan\n", "x = nan of sensor is out of range", "robot.toml:2"},
      {"[[sensors]]\nid = -1\n", "id = -1 of sensor is out of range", "robot.toml:2"},
      {"[[sensors]]\nid = 1\n[[sensors]]\nid = 1\n", "two sensors have the id 1", "robot.toml:3"},
      {"[[sensors]]\npreset = \"hc-sr05\"\n", "there is no sensor preset \"hc-sr05\"", "robot.toml:2"},
      {"[[sensors]]\nno_echo = \"never\"\n", "no_echo is none of the known spellings", "robot.toml:2"},
      {"[[sensors]]\nno_echo = { abov = 5 }\n", "there is no key abov in no_echo", "robot.toml:2"},
      {"ring = { radius_m = 0.2 }\n", "count is missing", "robot.toml:1"},
      {"ring = { count = 1000000 }\n", "count = 1000000 of ring is out of range", "robot.toml:1"},
      {"array = \"nomad\"\n", "there is no sensor array \"nomad\"", "robot.toml:1"},
      {"[[lasers]]\n[[lasers]]\nid = 0\n[[sensors]]\n", "two lasers have the id 0", "robot.toml:2"},
      {"", "the robot has no sensors", "robot.toml"},
  };
  for (const BadToml& bad : cases) {
    const auto robot = parse_robot_toml(bad.text, "robot.toml");
    ASSERT_FALSE(robot) << bad.text;
    EXPECT_EQ(robot.error().message, bad.message);
    EXPECT_EQ(robot.error().where, bad.where) << bad.text;
    EXPECT_FALSE(robot.error().remedy.empty()) << bad.text;
  }
}

TEST(RobotToml, AnAbsurdBeamIsAnErrorOnItsLine) {
  const auto robot = parse_robot_toml("name = \"a\"\n[[sensors]]\nbeam_width = 1e9\n", "robot.toml");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.error().where, "robot.toml:2");
  EXPECT_NE(robot.error().message.find("beam width"), std::string::npos);
}

TEST(RobotToml, AMillionSensorsAreRefused) {
  std::string text = "sensors = [";
  for (int k = 0; k < 20'000; ++k) text += "{},";
  EXPECT_FALSE(parse_robot_toml(text + "]", "robot.toml"));
  std::string rings;
  for (int k = 0; k < 1000; ++k) rings += "[[ring]]\ncount = 1000\n";
  EXPECT_FALSE(parse_robot_toml(rings, "robot.toml"));
}

TEST(RobotToml, JunkIsNoToml) {
  const auto robot = parse_robot_toml("name = \"a\"\nsensors = [ {\n", "robot.toml");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.error().code, ErrorCode::bad_format);
  EXPECT_EQ(robot.error().where.substr(0, 11), "robot.toml:");
  EXPECT_FALSE(parse_robot_toml(std::string("\x7f"
                                            "ELF\0\1",
                                            6),
                                "robot.toml"));
}

TEST(RobotToml, ALogIsNoDescription) {
  const test::TempFolder folder;
  test::put(folder / "robot.toml", std::string((1U << 20U) + 1, '\n'));
  const auto robot = read_robot_toml(folder / "robot.toml");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.error().code, ErrorCode::too_large);
  EXPECT_EQ(read_robot_toml(folder / "absent.toml").error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace echoarc::io
