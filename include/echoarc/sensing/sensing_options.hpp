// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "echoarc/core/options.hpp"

namespace echoarc {

/// What an echo nearer than the sensor's minimum range means.
enum class BelowMinimum : std::uint8_t {
  reject,     ///< ring-down of the sensor's own pulse or a wrapped count: says nothing
  too_close,  ///< something stands within the minimum range
};
constexpr std::array<Choice<BelowMinimum>, 2> choices(BelowMinimum) {
  return {{{BelowMinimum::reject, "reject"}, {BelowMinimum::too_close, "too_close"}}};
}

/// Which laser returns shorten a sonar reading (laser-limited sonar, [Yamauchi97]).
enum class LaserLimit : std::uint8_t {
  none,      ///< none: readings stay as they are
  cone_min,  ///< the nearest inside the sonar's beam
  axis,      ///< where the beam's axis crosses the line between the returns of neighbouring laser beams
};
constexpr std::array<Choice<LaserLimit>, 3> choices(LaserLimit) {
  return {{{LaserLimit::none, "none"}, {LaserLimit::cone_min, "cone_min"}, {LaserLimit::axis, "axis"}}};
}

/// When polled pings are said to have been fired.
enum class Polling : std::uint8_t {
  interval,  ///< in the middle of the interval in which they must have been
  naive,     ///< at the poll that shows them
};
constexpr std::array<Choice<Polling>, 2> choices(Polling) {
  return {{{Polling::interval, "interval"}, {Polling::naive, "naive"}}};
}

/// How raw records become readings.
struct SensingOptions {
  double max_pose_gap_s = 1.0;
  double max_wait_s = 10.0;
  double max_time_jump_s = 3600.0;
  BelowMinimum below_minimum = BelowMinimum::reject;
  double air_temperature_k = 0.0;
  double trusted_range_m = 0.0;
  double range_cut_m = 0.0;
  double jump_filter_m = 0.0;
  LaserLimit laser_limit = LaserLimit::none;
  double laser_max_age_s = 0.2;
  Polling polling = Polling::interval;
  double poll_gap_min_s = 0.038;
  double poll_gap_max_s = 0.042;
  double max_stamp_error_m = 0.05;
  Angle max_stamp_turn = degrees(2.0);

  static constexpr auto fields() {
    using S = SensingOptions;
    return std::tuple{
        field("max_pose_gap_s", &S::max_pose_gap_s,
              {.unit = "s",
               .min = 0.0,
               .max = 86400.0,
               .doc = "a pose is interpolated between odometry records at most this far apart"}),
        field("max_wait_s", &S::max_wait_s,
              {.unit = "s",
               .min = 0.0,
               .max = 86400.0,
               .doc = "live only: a ping stamped this far ahead of the newest odometry waits no longer"}),
        field("max_time_jump_s", &S::max_time_jump_s,
              {.unit = "s",
               .min = 0.0,
               .max = 1e9,
               .doc = "odometry that jumps ahead by more is refused as a bad time stamp"}),
        field("below_minimum", &S::below_minimum,
              {.doc = "an echo nearer than the minimum range is rejected, or read as something too close",
               .source = "[Silver04], [Choset03]: their arrays ignore such readings"}),
        field("air_temperature_k", &S::air_temperature_k,
              {.unit = "K",
               .min = 0.0,
               .max = 350.0,
               .doc = "what the air had; ranges are corrected from the temperature the log was recorded for; 0: as "
                      "recorded",
               .source = "[Barshan07] 2, footnote 1"}),
        field("trusted_range_m", &S::trusted_range_m,
              {.unit = "m",
               .min = 0.0,
               .max = 1000.0,
               .doc = "to this range silence counts as free space, for all sensors; 0: each sensor's own"}),
        field("range_cut_m", &S::range_cut_m,
              {.unit = "m",
               .min = 0.0,
               .max = 1000.0,
               .doc = "echoes beyond this are left out; 0: none",
               .source = "[Silver04] App. B: 3.81 m (150 in)"}),
        field("jump_filter_m", &S::jump_filter_m,
              {.unit = "m",
               .min = 0.0,
               .max = 1000.0,
               .doc = "a reading that differs by more from the one before of its sensor is left out; 0: none; 0.5 is a "
                      "good value",
               .source = "[Silver04] App. B"}),
        field("laser_limit", &S::laser_limit,
              {.doc = "shorten readings of all methods to what the log's laser saw nearer; method `limited` has them "
                      "shortened anyway, with cone_min unless this says otherwise",
               .source = "[Yamauchi97]"}),
        field("laser_max_age_s", &S::laser_max_age_s,
              {.unit = "s",
               .min = 0.0,
               .max = 3600.0,
               .doc = "a ping is held against the laser scan nearest in time, if not further away than this"}),
        field("polling", &S::polling,
              {.doc = "logs with polled registers alone: date pings by when they must have been fired, or by the poll "
                      "that shows them",
               .source = "[Silver04] App. A, Fig. 14"}),
        field("poll_gap_min_s", &S::poll_gap_min_s,
              {.unit = "s",
               .min = 0.001,
               .max = 10.0,
               .doc = "polled arrays: shortest time from one firing to the next",
               .source = "[Barshan07] 4.1: 40 ms"}),
        field(
            "poll_gap_max_s", &S::poll_gap_max_s,
            {.unit = "s", .min = 0.001, .max = 10.0, .doc = "polled arrays: longest time from one firing to the next"}),
        field("max_stamp_error_m", &S::max_stamp_error_m,
              {.unit = "m",
               .min = 0.0,
               .max = 100.0,
               .doc = "a polled ping whose pose may be off by more is left out",
               .source = "[Silver04] App. A, without a number"}),
        field("max_stamp_turn_deg", &S::max_stamp_turn,
              {.unit = "deg",
               .min = 0.0,
               .max = 180.0,
               .doc = "a polled ping whose heading may be off by more is left out"})};
  }
};

}  // namespace echoarc
