// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose_track.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/sensing/sensing_options.hpp"

namespace echoarc {

/// Laser-limited sonar ([Yamauchi97]): where a laser sees something nearer than a sonar does, the reading becomes an
/// echo at the laser's range. Takes out what mirrored walls pretend; what is above or below the laser's plane stays.
///
/// A reading is held against the scan nearest in time of each laser, if not older or newer than `max_age_s`; the scan
/// is placed in the world by the odometry at its own time. Of a bistatic reading the path is shortened: half of
/// |P - tx| + |P - rx|, with bearings from the midpoint of the sensors.
class LaserLimiter {
 public:
  LaserLimiter(const std::vector<LaserMount>& lasers, LaserLimit rule, double max_age_s);

  /// Why a scan was not taken.
  enum class Refusal : std::uint8_t { unknown_laser, bad_time, backwards };
  /// Scans of a laser come in the order of time.
  [[nodiscard]] std::optional<Refusal> push(const Scan& scan);

  /// The reading, shortened and flagged `laser_limited` where a laser return is nearer. Silence counts as the maximum
  /// range and stays silence when nothing limits it; too close and failed readings stay as they are. Readings come in
  /// the order of time: older scans are forgotten.
  [[nodiscard]] Reading limited(const Reading& reading, const PoseTrack& track);

 private:
  struct Laser {
    LaserMount mount;
    std::deque<Scan> scans;  // from the one in use on
    double newest_s = -std::numeric_limits<double>::infinity();
    // Unit vectors of the beams, kept as long as the scans have the same shape.
    Angle angle_min;
    Angle angle_step;
    std::vector<double> beam_x, beam_y;
    // Returns of the scan in use, in the world; NaN where a beam has none. Padded for the kernels.
    std::optional<double> placed_s;
    std::vector<double> hit_x, hit_y;
  };

  void choose_scan(Laser& laser, double time_s) const;
  [[nodiscard]] bool place_scan(Laser& laser, const PoseTrack& track) const;

  std::vector<Laser> lasers_;
  LaserLimit rule_;
  double max_age_s_;
};

/// Half the path from tx over the nearest laser return to rx, of the returns inside the beam that are at least
/// `range_min_m` away; infinity where there is none. Returns as parallel arrays of world coordinates, NaN: none.
[[nodiscard]] double limit_of(const Reading& reading, LaserLimit rule, const std::vector<double>& hit_x,
                              const std::vector<double>& hit_y);

}  // namespace echoarc
