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
  bool later_echoes = false;

  // In groups, because one list would be longer than a function should be.
  static constexpr auto transducer_fields() {
    using S = SonarOptions;
    return std::tuple{field("frequency_hz", &S::frequency_hz,
                            {.unit = "Hz",
                             .min = 1e3,
                             .max = 1e6,
                             .doc = "of the sound; with the aperture it makes the beam",
                             .source = "[Barshan07] 2"}),
                      field("aperture_radius_m", &S::aperture_radius_m,
                            {.unit = "m",
                             .min = 1e-4,
                             .max = 0.2,
                             .doc = "radius of the transducer, a piston in a wall",
                             .source = "[Barshan07] 2"}),
                      field("temperature_k", &S::temperature_k,
                            {.unit = "K", .min = 200.0, .max = 350.0, .doc = "of the air", .source = "[Barshan07] 2"}),
                      field("assumed_temperature_k", &S::assumed_temperature_k,
                            {.unit = "K",
                             .min = 200.0,
                             .max = 350.0,
                             .doc = "what the robot computes its ranges with; goes into the log"})};
  }
  static constexpr auto echo_fields() {
    using S = SonarOptions;
    return std::tuple{
        field("max_order", &S::max_order, {.min = 1, .max = 6, .doc = "most reflections of an echo on walls"}),
        field("threshold_db", &S::threshold_db,
              {.unit = "dB",
               .min = 0.0,
               .max = 120.0,
               .doc = "an echo is heard that is at most this much weaker than a smooth wall met head-on; 35 dB just "
                      "leaves the first side lobe out"}),
        field("edge_gain_db", &S::edge_gain_db,
              {.unit = "dB", .min = -120.0, .max = 0.0, .doc = "of convex edges and wall ends, which diffract"}),
        field("flat_range_m", &S::flat_range_m,
              {.unit = "m",
               .min = 0.0,
               .max = 1000.0,
               .doc = "up to here the receiver's rising gain makes up for spreading and absorption"}),
        field("residual_db_per_m", &S::residual_db_per_m,
              {.unit = "dB/m", .min = 0.0, .max = 100.0, .doc = "loss per metre of range beyond that"})};
  }
  static constexpr auto error_fields() {
    using S = SonarOptions;
    return std::tuple{
        field("range_noise_share", &S::range_noise_share,
              {.min = 0.0,
               .max = 0.5,
               .doc = "standard deviation of a range, as a share of it",
               .source = "[Barshan07] 4.1: +-1 %, taken as three sigma"}),
        field("dropout_share", &S::dropout_share,
              {.min = 0.0, .max = 1.0, .doc = "share of the windows in which nothing is heard, whatever arrives"}),
        field(
            "outlier_share", &S::outlier_share,
            {.min = 0.0,
             .max = 1.0,
             .doc =
                 "share of the firings of which a receiver reports a range at random; where all sensors listen, any of "
                 "them may"}),
        field("quantum_m", &S::quantum_m,
              {.unit = "m",
               .min = 0.0,
               .max = 1.0,
               .doc = "ranges come in whole steps of this; 0: they do not; 0.0254 on the robots of the arc papers",
               .source = "[Silver04] 2, [Choset03] IV-B"}),
        field("quantisation", &S::quantisation, {.doc = "to the nearest step, or to the one below"}),
        field("floor_share", &S::floor_share,
              {.min = 0.0,
               .max = 1.0,
               .doc = "share of the pings whose sensor may hear the floor",
               .source = "[Silver04] App. B, without a number"}),
        field("floor_height_m", &S::floor_height_m,
              {.unit = "m",
               .min = 0.01,
               .max = 10.0,
               .doc = "of sensors whose mount has no height of its own",
               .source = "[Silver04] App. B: 10.25 in"}),
        field("floor_angle_deg", &S::floor_angle,
              {.unit = "deg",
               .min = 1.0,
               .max = 89.0,
               .doc = "how steeply the floor is seen where it echoes",
               .source = "[Silver04] App. B: the floor from just over 2 ft"}),
        field("pitch_sigma_deg", &S::pitch_sigma,
              {.unit = "deg", .min = 0.0, .max = 20.0, .doc = "of the robot's pitching, which tilts that angle"}),
        field("pitch_correlation_m", &S::pitch_correlation_m,
              {.unit = "m", .min = 1e-3, .max = 1000.0, .doc = "travel over which the pitch changes"})};
  }
  static constexpr auto firing_fields() {
    using S = SonarOptions;
    return std::tuple{
        field("listening", &S::listening,
              {.doc = "who listens after a transmission: the firing sensor, or every sensor of the array",
               .source = "[Barshan07] 2: all"}),
        field("interval_s", &S::interval_s,
              {.unit = "s",
               .min = 1e-3,
               .max = 10.0,
               .doc = "between one firing and the next; 0.062 is free of cross-talk at 10.7 m",
               .source = "[Barshan07] 4.1"}),
        field("cross_talk", &S::cross_talk,
              {.doc = "windows end at the next firing, and echoes of earlier pings fall into them; false: every ping "
                      "has its full time and no earlier one is heard",
               .source = "[Barshan07] 4.1"}),
        field("later_echoes", &S::later_echoes,
              {.doc = "the log keeps the echoes after the first as well, with their index; methods ignore them",
               .source = "[Barshan07] 2"})};
  }

  static constexpr auto fields() {
    return std::tuple_cat(transducer_fields(), echo_fields(), error_fields(), firing_fields());
  }
};

}  // namespace echoarc::sim
