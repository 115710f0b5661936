// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/range_quantum.hpp"

namespace echoarc {

constexpr std::array<Choice<Quantisation>, 2> choices(Quantisation /*tag*/) {
  return {{{Quantisation::round, "round"}, {Quantisation::truncate, "truncate"}}};
}

}  // namespace echoarc

namespace echoarc::sim {

/// Who listens after a transmission.
enum class Listening : std::uint8_t {
  own,  ///< the firing sensor alone
  all,  ///< every sensor of the array ([Barshan07] 2)
};

constexpr std::array<Choice<Listening>, 2> choices(Listening /*tag*/) {
  return {{{Listening::own, "own"}, {Listening::all, "all"}}};
}

/// Transducer, air, electronics and firing of the simulated sonars: the table `[sonar]` of a scene. One profile serves
/// every scene; what a scene changes is a property of the paper's robot.
struct SonarOptions {
  // Transducer and air.
  double frequency_hz = 49'400.0;
  double aperture_radius_m = 0.020;
  double temperature_k = 293.0;          // of the air
  double assumed_temperature_k = 293.0;  // what the robot computes ranges with
  // Echoes.
  int max_order = 3;
  double threshold_db = 35.0;
  double edge_gain_db = -15.0;
  double flat_range_m = 6.0;
  double residual_db_per_m = 3.0;
  // Errors.
  double range_noise_share = 0.003;
  double dropout_share = 0.01;
  double outlier_share = 0.02;
  double quantum_m = 0.0;
  Quantisation quantisation = Quantisation::round;
  double floor_share = 0.03;
  double floor_height_m = 0.26035;
  Angle floor_angle = degrees(22.5);
  Angle pitch_sigma = degrees(0.7);
  double pitch_correlation_m = 0.3;
  // Firing.
  Listening listening = Listening::own;
  double interval_s = 0.04;
  bool cross_talk = true;

};

}  // namespace echoarc::sim
