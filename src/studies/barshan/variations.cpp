// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <utility>

#include "echoarc/core/speed_of_sound.hpp"
#include "studies/barshan/parameter_study.hpp"
#include "studies/chart_axis.hpp"

namespace echoarc::studies::barshan {
namespace {

constexpr double curve_step_m = 0.0005;

void add(std::vector<Variation>& all, const std::string& study, const std::string& unit,
         const std::vector<double>& values, int decimals) {
  for (const double value : values)
    all.push_back({study, unit, value, fixed(value, decimals) + (unit.empty() ? "" : " ") + unit, "layout-circular"});
}

/// The surface of the scene `curve`: at `distance_m`, its shape `scale` times as high.
std::vector<Vec2> surface(double distance_m, double scale) {
  std::vector<Vec2> points;
  const auto steps = int(std::lround(2.0 / curve_step_m));
  for (int k = 0; k <= steps; ++k) {
    const double x = -1.0 + 2.0 * k / steps;
    const double shape = 0.16 * std::cos(2.6 * x + 0.5) - 0.07 * std::sin(4.3 * x);
    points.push_back({x, distance_m + scale * shape});
  }
  return points;
}

/// Beams as wide as asked for: the sensors say so, and the piston's first zero lies at half of it.
Result<void> set_beam(sim::Scene& scene, Angle beam) {
  std::vector<Sensor> sensors(scene.robot.sensors.sensors().begin(), scene.robot.sensors.sensors().end());
  for (Sensor& sensor : sensors) sensor.model.beam_width = beam;
  Result<SensorArray> array = SensorArray::make(std::move(sensors));
  if (!array) return array.error();
  scene.robot.sensors = std::move(*array);
  const double wavelength_m = speed_of_sound_m_s(scene.sonar.temperature_k) / scene.sonar.frequency_hz;
  scene.sonar.aperture_radius_m = 0.61 * wavelength_m / sin(0.5 * beam);
  return {};
}

}  // namespace

std::vector<Variation> variations() {
  std::vector<Variation> all{{"layout", "", 1, "random", "layout-random"},
                             {"layout", "", 2, "circular", "layout-circular"},
                             {"layout", "", 3, "linear", "layout-linear"}};
  add(all, "beam width", "degrees", {5, 15, 25, 45, 65, 85, 105}, 0);
  add(all, "roughness", "dB", {-30, -24, -18, -12, -6}, 0);
  add(all, "curvature", "times", {0.0, 0.5, 1.0, 1.5, 2.0}, 1);
  add(all, "distance", "m", {0.6, 1.0, 1.4, 1.8, 2.2}, 1);
  add(all, "range noise", "%", {0.0, 0.3, 1.0, 2.0, 3.0, 5.0}, 1);
  return all;
}

Result<StudyScene> varied(StudyScene scene, const Variation& variation) {
  sim::Scene& changed = scene.scene;
  if (variation.study == "beam width") {
    if (const Result<void> set = set_beam(changed, degrees(variation.value)); !set) return set.error();
  }
  if (variation.study == "roughness")
    for (const sim::SmoothCurve& curve : changed.world.curves)
      changed.world.materials[curve.material].rough_db = variation.value;
  if (variation.study == "curvature")
    for (sim::SmoothCurve& curve : changed.world.curves) curve.points = surface(1.0, variation.value);
  if (variation.study == "distance")
    for (sim::SmoothCurve& curve : changed.world.curves) curve.points = surface(variation.value, 1.0);
  if (variation.study == "range noise") changed.sonar.range_noise_share = 0.01 * variation.value;
  return scene;
}

}  // namespace echoarc::studies::barshan
