// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace echoarc::sim {

/// A move from rest to rest under a limit of speed and one of acceleration: speed over time is a trapezoid, or a
/// triangle where the way is too short to reach full speed. Of a distance in metres or of an angle in radians.
class SpeedProfile {
 public:
  /// Requires way >= 0, max_speed > 0, acceleration > 0.
  SpeedProfile(double way, double max_speed, double acceleration);

  [[nodiscard]] double way() const { return way_; }
  [[nodiscard]] double duration_s() const { return 2.0 * ramp_s_ + cruise_s_; }
  /// The way made by a time; before the start 0, after the end all of it.
  [[nodiscard]] double way_at(double time_s) const;
  /// When so much of the way is made, 0 <= way <= way().
  [[nodiscard]] double time_at(double way) const;

 private:
  double way_;
  double acceleration_;
  double top_speed_;  // reached
  double ramp_s_;     // of speeding up, and of slowing down
  double cruise_s_;
};

}  // namespace echoarc::sim
