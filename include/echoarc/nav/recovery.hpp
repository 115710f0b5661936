// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/free_way.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

/// Why what a strategy is told cannot go on from what it was told before: a time or pose that is no number, time that
/// runs backwards, a pose further away than the robot can have driven. Empty: all is well.
class PoseWatch {
 public:
  explicit PoseWatch(const RobotLimits& limits) : limits_(limits) {}
  [[nodiscard]] std::string fault(const Surroundings& surroundings);
  void reset() { before_.reset(); }

 private:
  struct Moment {
    double time_s = 0.0;
    Pose2 T_world_base;
  };
  RobotLimits limits_;
  std::optional<Moment> before_;
};

struct RecoveryOptions {
  double stuck_s = 5.0;
  double turning_s = 15.0;
  double progress_m = 0.05;
  double back_off_m = 0.3;
  double back_off_m_s = 0.1;
  Angle turn = degrees(60.0);
  Angle turn_per_s = degrees(30.0);
  double away_m = 1.0;
  int tries = 3;

  static constexpr auto fields() {
    using O = RecoveryOptions;
    return std::tuple{
        field(
            "stuck_s", &O::stuck_s,
            {.unit = "s", .min = 0.1, .max = 600.0, .doc = "wanting to go on so long without progress is being stuck"}),
        field("turning_s", &O::turning_s,
              {.unit = "s", .min = 0.1, .max = 600.0, .doc = "the same where only a turn is wanted"}),
        field("progress_m", &O::progress_m, {.unit = "m", .min = 1e-3, .max = 10.0, .doc = "less is no progress"}),
        field("back_off_m", &O::back_off_m, {.unit = "m", .min = 0.0, .max = 10.0, .doc = "way back of a try"}),
        field("back_off_m_s", &O::back_off_m_s,
              {.unit = "m/s", .min = 0.01, .max = 1.0, .doc = "speed of the way back"}),
        field("turn_deg", &O::turn,
              {.unit = "deg", .min = 0.0, .max = 180.0, .doc = "turn of a try, away from what is nearest first"}),
        field("turn_rate_deg", &O::turn_per_s, {.unit = "deg/s", .min = 1.0, .max = 360.0, .doc = "rate of that turn"}),
        field("away_m", &O::away_m,
              {.unit = "m", .min = 0.01, .max = 100.0, .doc = "so far away the tries are forgotten"}),
        field("tries", &O::tries, {.min = 0, .max = 100, .doc = "after so many in one place it gives up"})};
  }
};

/// Finds out that a robot is stuck, wanting to move without getting on, and gets it out: back off, turn, try again.
/// A robot that a cap or its bumper holds wants to move; give it what the strategy wants before any cap.
class Recovery {
 public:
  explicit Recovery(const RobotBody& body, const RecoveryOptions& options = {}, const SafetyOptions& safety = {});

  /// What to do instead of `wanted`; none: nothing, all goes well. The velocity keeps clear of the points. A failed
  /// status is final until `reset`.
  [[nodiscard]] std::optional<Steering> update(const Surroundings& surroundings, const RobotVelocity& wanted);
  void reset();

 private:
  enum class Phase : std::uint8_t { watching, backing, turning, given_up };

  [[nodiscard]] bool stuck(const Surroundings& surroundings, const RobotVelocity& wanted);
  void begin_try(const Surroundings& surroundings);
  void begin(Phase phase, const Surroundings& surroundings);
  [[nodiscard]] bool backed_off(const Surroundings& surroundings, const RobotVelocity& back) const;
  [[nodiscard]] bool turned(const Surroundings& surroundings) const;
  [[nodiscard]] Steering given_up() const;

  RobotBody body_;
  RecoveryOptions options_;
  SafetyOptions safety_;
  Phase phase_ = Phase::watching;
  double began_s_ = 0.0;                // of the phase
  Pose2 T_world_began_;                 // of the phase
  std::optional<Pose2> T_world_still_;  // where it was last seen to get on
  double last_s_ = 0.0;
  double driving_s_ = 0.0;  // forward speed was wanted so long without progress
  double wanting_s_ = 0.0;  // any motion was
  std::optional<Vec2> tried_at_;
  int tries_ = 0;
  double turn_side_ = 1.0;  // of this try's turn; left is positive
};

}  // namespace echoarc::nav
