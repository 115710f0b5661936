// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/angle.hpp"
#include "echoarc/sim/echo_paths.hpp"
#include "echoarc/sim/sonar_options.hpp"

namespace echoarc::sim {

/// Far field of a circular piston in a wall: D(theta) = 2 J1(x) / x, x = k a sin(theta) (Kinsler et al. 2000, 7.4).
class PistonBeam {
 public:
  /// `wave_number_radius` is k a = 2 pi a / lambda, in (0, 10000].
  explicit PistonBeam(double wave_number_radius);

  /// Amplitude relative to the axis, negative in every other side lobe, within 1e-9 of the formula; 0 at and beyond 90
  /// degrees, where the wall is.
  [[nodiscard]] double amplitude(Angle off_axis) const;
  /// k a.
  [[nodiscard]] double wave_number_radius() const { return wave_number_radius_; }
  /// Direction of the first zero; 90 degrees if there is none.
  [[nodiscard]] Angle first_null() const;

 private:
  struct Knot {
    double value = 0.0;
    double slope = 0.0;  // per step
  };
  double wave_number_radius_;
  std::vector<Knot> knots_;
};

/// How loud an echo is, and whether it is heard: the transducers of one kind on one robot.
///
/// Levels are relative to a smooth wall met head-on by both axes. Spreading and absorption are made up for by the
/// receiver's rising gain to `flat_range_m`, and grow linearly from there.
class Acoustics {
 public:
  /// Requires options that `validate`.
  explicit Acoustics(const SonarOptions& options);

  /// 20 log10 |D(transmitted) D(received)| + gain - residual max(0, L / 2 - flat range), in dB.
  [[nodiscard]] double level_db(const EchoPath& path, Angle transmitter_axis, Angle receiver_axis) const;
  /// Whether `level_db` reaches minus the threshold.
  [[nodiscard]] bool heard(double level_db) const { return level_db >= -threshold_db_; }
  [[nodiscard]] double threshold_db() const { return threshold_db_; }

  /// In the air of the scene.
  [[nodiscard]] double speed_of_sound_m_s() const { return speed_of_sound_m_s_; }
  [[nodiscard]] const PistonBeam& beam() const { return beam_; }
  /// How far off its axis a transducer need listen: 25 degrees for a beam with its first zero at 12.2, past two side
  /// lobes; wider in proportion (of the sines) for wider beams. Where all sensors listen, 90 degrees: the main lobe of
  /// one and a far side lobe of its neighbour together pass the threshold.
  [[nodiscard]] Angle half_window() const { return half_window_; }
  /// For paths to `max_length_m`.
  [[nodiscard]] PathLimits limits(double max_length_m) const;

 private:
  double speed_of_sound_m_s_;
  PistonBeam beam_;
  Angle half_window_;
  double threshold_db_;
  double flat_range_m_;
  double residual_db_per_m_;
  int max_order_;
  double edge_gain_db_;
};

}  // namespace echoarc::sim
