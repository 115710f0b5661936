// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/sensor_array.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// V1.5: the chord between neighbours of the Nomad ring.
TEST(SensorArray, NomadNeighboursAreNineCentimetresApart) {
  const SensorArray nomad = *array_preset("nomad200");
  ASSERT_EQ(nomad.size(), 16U);
  for (std::size_t k = 0; k < 16; ++k) {
    const Pose2 here = nomad.sensors()[k].mount.T_robot_sensor();
    const Pose2 next = nomad.sensors()[(k + 1) % 16].mount.T_robot_sensor();
    EXPECT_NEAR(norm(next.position - here.position), 0.08974155, 5e-9) << k;
    EXPECT_NEAR(wrap(next.heading - here.heading).deg(), 22.5, 1e-9) << k;
    EXPECT_NEAR(wrap(here.heading - bearing(here.position)).deg(), 0.0, 1e-9) << "looks outward";
    EXPECT_NEAR(wrap(here.heading - degrees(22.5 * double(k))).deg(), 0.0, 1e-9);
  }
}

TEST(SensorArray, FrontArraysAreCentredOnTheFront) {
  for (const auto& [name, count] : {std::pair{"nomad200_front3", 3}, {"nomad200_front5", 5}}) {
    const SensorArray front = *array_preset(name);
    ASSERT_EQ(front.size(), std::size_t(count));
    for (int k = 0; k < count; ++k) {
      const Pose2 mount = front.find(SensorId(k))->mount.T_robot_sensor();
      EXPECT_NEAR(mount.heading.deg(), 22.5 * (k - count / 2), 1e-9);
      EXPECT_NEAR(norm(mount.position), 0.23, 1e-12);
    }
  }
}

TEST(SensorArray, EveryArrayPresetIsComplete) {
  for (const ArrayPreset& preset : array_presets()) {
    const auto array = array_preset(preset.name);
    ASSERT_TRUE(array) << preset.name;
    EXPECT_FALSE(array->empty());
    EXPECT_FALSE(preset.description.empty());
    EXPECT_FALSE(preset.source.empty());
  }
  EXPECT_NEAR(array_preset("nomad_choset")->sensors()[0].model.beam_width.deg(), 22.5, 1e-12);
  EXPECT_NEAR(array_preset("b14r")->sensors()[0].model.beam_width.deg(), 25.0, 1e-12);
  EXPECT_EQ(array_preset("scout2")->sensors()[3].mount.z_m, 0.26035);
  EXPECT_FALSE(array_preset("nomad"));
}

TEST(SensorArray, EverySensorPresetIsLegalAndSourced) {
  for (const SensorPreset& preset : sensor_presets()) {
    const auto model = sensor_preset(preset.name);
    ASSERT_TRUE(model) << preset.name;
    EXPECT_EQ(model->preset, preset.name);
    EXPECT_TRUE(SensorArray::make({{0, {}, *model}})) << preset.name;
    EXPECT_LE(model->trusted_range_m, model->range_max_m) << preset.name;
    EXPECT_FALSE(preset.source.empty());
  }
  EXPECT_EQ(sensor_preset("hc-sr04")->range_max_m, 4.0);
  EXPECT_FALSE(sensor_preset("HC-SR05"));
}

TEST(SensorArray, SortsById) {
  const Result<SensorArray> array = SensorArray::make({{7, {}, {}}, {2, {}, {}}, {5, {}, {}}});
  ASSERT_TRUE(array);
  EXPECT_EQ(array->sensors()[0].id, 2U);
  EXPECT_EQ(array->sensors()[2].id, 7U);
  EXPECT_EQ(array->find(5)->id, 5U);
  EXPECT_EQ(array->find(3), nullptr);
  EXPECT_EQ(array->find(8), nullptr);
}

TEST(SensorArray, RowCountsFromTheRight) {
  const std::vector<Sensor> sensors = row(4, 0.1, 0.2, {});
  ASSERT_EQ(sensors.size(), 4U);
  EXPECT_NEAR(sensors[0].mount.y_m, -0.15, 1e-12);
  EXPECT_NEAR(sensors[3].mount.y_m, 0.15, 1e-12);
  EXPECT_EQ(sensors[2].mount.x_m, 0.2);
  EXPECT_EQ(sensors[2].mount.yaw.rad(), 0.0);
  EXPECT_TRUE(row(0, 0.1, 0.2, {}).empty());
}

struct BadSensor {
  const char* what;
  std::function<void(Sensor&)> spoil;
  const char* message_part;
};

class BadSensorTest : public testing::TestWithParam<BadSensor> {};

TEST_P(BadSensorTest, IsRefusedByName) {
  Sensor sensor{.id = 3, .mount = {}, .model = {}};
  GetParam().spoil(sensor);
  const Result<SensorArray> array = SensorArray::make({{1, {}, {}}, sensor});
  ASSERT_FALSE(array);
  EXPECT_NE(array.error().message.find("sensor 3"), std::string::npos) << array.error().message;
  EXPECT_NE(array.error().message.find(GetParam().message_part), std::string::npos) << array.error().message;
  EXPECT_FALSE(array.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    SensorArray, BadSensorTest,
    testing::Values(
        BadSensor{"beam_1e9", [](Sensor& s) { s.model.beam_width = radians(1e9); }, "beam width"},
        BadSensor{"beam_zero", [](Sensor& s) { s.model.beam_width = Angle{}; }, "beam width"},
        BadSensor{"beam_180", [](Sensor& s) { s.model.beam_width = degrees(180); }, "beam width"},
        BadSensor{"beam_nan", [](Sensor& s) { s.model.beam_width = radians(nan_value); }, "beam width"},
        BadSensor{"ranges_swapped", [](Sensor& s) { std::swap(s.model.range_min_m, s.model.range_max_m); }, "ranges"},
        BadSensor{"range_negative", [](Sensor& s) { s.model.range_min_m = -0.1; }, "ranges"},
        BadSensor{"range_5_km", [](Sensor& s) { s.model.range_max_m = 5000; }, "ranges"},
        BadSensor{"range_nan", [](Sensor& s) { s.model.range_max_m = nan_value; }, "ranges"},
        BadSensor{"trust_nan", [](Sensor& s) { s.model.trusted_range_m = nan_value; }, "trusted"},
        BadSensor{"limit_nan", [](Sensor& s) { s.model.no_echo = {NoEchoRule::Kind::above, nan_value}; }, "no-echo"},
        BadSensor{"mount_far", [](Sensor& s) { s.mount.x_m = 1001; }, "mount"},
        BadSensor{"mount_nan", [](Sensor& s) { s.mount.z_m = nan_value; }, "mount"},
        BadSensor{"yaw_inf", [](Sensor& s) { s.mount.yaw = radians(HUGE_VAL); }, "angle"}),
    [](const auto& instance) { return std::string(instance.param.what); });

TEST(SensorArray, DuplicateIdIsNamed) {
  const Result<SensorArray> array = SensorArray::make({{4, {}, {}}, {1, {}, {}}, {4, {}, {}}});
  ASSERT_FALSE(array);
  EXPECT_NE(array.error().message.find("sensor 4: the id is used twice"), std::string::npos);
}

TEST(SensorArray, AMillionSensorsAreRefused) {
  EXPECT_FALSE(SensorArray::make(std::vector<Sensor>(1'000'000)));
  EXPECT_TRUE(SensorArray::make(ring(1024, 1.0, Angle{}, {})));
}

}  // namespace
}  // namespace echoarc
