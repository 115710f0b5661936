// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "echoarc/core/log.hpp"

namespace echoarc::sim {

/// The range registers of an array without time stamps ([Silver04] App. A). A sensor's register takes its new value
/// when the echo arrives, or at the time-out 2 r_max / c if none does; before that, and before the first firing, it
/// holds the old one. Later echoes do not reach a register.
class Registers {
 public:
  /// `array` must outlive it.
  Registers(const SensorArray& array, double speed_of_sound_m_s);

  /// A ping heard by its own sensor, with its time of flight; in order of time.
  void hear(const Ping& ping);
  /// What the registers hold at a time. Times must not go back, and no ping before `time_s` may come later.
  [[nodiscard]] const std::vector<double>& at(double time_s);

 private:
  struct Update {
    double time_s = 0.0;
    std::size_t sensor = 0;
    double value_m = 0.0;
  };

  const SensorArray* array_;
  double speed_of_sound_m_s_;
  std::deque<Update> updates_;  // to come, in order of time
  std::vector<double> values_m_;
};

/// The registers read at a fixed rate from 0 to `end_s`. `pings` as `Registers` wants them.
[[nodiscard]] std::vector<Poll> poll_registers(const SensorArray& array, std::span<const Ping> pings, double rate_hz,
                                               double end_s, double speed_of_sound_m_s);

}  // namespace echoarc::sim
