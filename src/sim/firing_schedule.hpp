// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"
#include "sim/drive_plan.hpp"
#include "sim/sonar.hpp"

namespace echoarc::sim {

/// Who fires when on a drive: sensor after sensor at the interval, all the time; with stops one round a stop, and on
/// and on in the rest at the end.
class FiringSchedule {
 public:
  /// `plan` must outlive it; stops must rest for a round. Error: more than `max_firings`.
  [[nodiscard]] static Result<FiringSchedule> make(const DrivePlan& plan, std::size_t sensors, double interval_s,
                                                   double dwell_s);

  [[nodiscard]] std::uint64_t count() const { return in_stops_ + after_; }
  /// The firing of that number, < count().
  [[nodiscard]] Firing firing(std::uint64_t number) const;
  /// When the drive is over and the last firing was made.
  [[nodiscard]] double end_s() const { return end_s_; }

 private:
  explicit FiringSchedule(const DrivePlan& plan) : plan_(&plan) {}

  const DrivePlan* plan_;
  std::size_t sensors_ = 0;
  double interval_s_ = 0.0;
  std::uint64_t in_stops_ = 0;  // firings in stops
  std::uint64_t after_ = 0;     // those that follow at the interval
  double after_begin_s_ = 0.0;
  double end_s_ = 0.0;
};

}  // namespace echoarc::sim
