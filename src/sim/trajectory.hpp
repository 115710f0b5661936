// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/pose2.hpp"
#include "sim/speed_profile.hpp"

namespace echoarc::sim {

/// A robot's way through time: rests, straight lines and turns on the spot, one after another.
class Trajectory {
 public:
  /// One of them. Only one of `direction` and `turn_sign` is not zero; a rest has neither.
  struct Move {
    double begin_s;
    double travelled_m;   ///< before it
    Pose2 T_world_robot;  ///< at its begin
    Vec2 direction;       ///< of a straight line, length 1
    double turn_sign;
    SpeedProfile profile;
    std::uint64_t line;  ///< of the leg it belongs to
  };

  explicit Trajectory(const Pose2& start) : end_(start) {}

  void add_rest(double duration_s);
  void add_line(Vec2 to, double max_speed_m_s, double acceleration_m_s2, std::uint64_t line);
  void add_turn(Angle by, Angle max_rate_per_s, Angle acceleration_per_s2, std::uint64_t line);

  [[nodiscard]] double end_s() const { return end_s_; }
  /// T_world_robot after everything added so far.
  [[nodiscard]] const Pose2& end() const { return end_; }
  [[nodiscard]] double length_m() const { return length_m_; }
  [[nodiscard]] std::span<const Move> moves() const { return moves_; }

  /// T_world_robot at a time; before 0 the start, later the end.
  [[nodiscard]] Pose2 at(double time_s) const;
  /// Distance driven by then.
  [[nodiscard]] double travelled_m(double time_s) const;

 private:
  void add(Move move);
  [[nodiscard]] const Move* move_at(double time_s) const;

  std::vector<Move> moves_;
  Pose2 end_;
  double end_s_ = 0.0;
  double length_m_ = 0.0;
};

}  // namespace echoarc::sim
