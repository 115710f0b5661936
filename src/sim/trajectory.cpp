// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoarc::sim {
namespace {

Pose2 pose_in(const Trajectory::Move& move, double time_s) {
  const double way = move.profile.way_at(time_s - move.begin_s);
  return {move.T_world_robot.position + way * move.direction,
          move.T_world_robot.heading + radians(way * move.turn_sign)};
}

double driven_in(const Trajectory::Move& move, double time_s) {
  return move.direction == Vec2{} ? 0.0 : move.profile.way_at(time_s - move.begin_s);
}

}  // namespace

void Trajectory::add_rest(double duration_s) {
  add({end_s_, length_m_, end_, {}, 0.0, SpeedProfile(0.0, 1.0, 1.0), 0});
  end_s_ += duration_s;
}

void Trajectory::add_line(Vec2 to, double max_speed_m_s, double acceleration_m_s2, std::uint64_t line) {
  const Vec2 way = to - end_.position;
  const double length_m = norm(way);
  if (length_m == 0.0) return;
  add({end_s_, length_m_, end_, way / length_m, 0.0, SpeedProfile(length_m, max_speed_m_s, acceleration_m_s2), line});
  end_.position = to;
}

void Trajectory::add_turn(Angle by, Angle max_rate_per_s, Angle acceleration_per_s2, std::uint64_t line) {
  const SpeedProfile profile(std::abs(by.rad()), max_rate_per_s.rad(), acceleration_per_s2.rad());
  add({end_s_, length_m_, end_, {}, std::copysign(1.0, by.rad()), profile, line});
  end_.heading += by;
}

void Trajectory::add(Move move) {
  end_s_ += move.profile.duration_s();
  if (move.direction != Vec2{}) length_m_ += move.profile.way();
  moves_.push_back(move);
}

const Trajectory::Move* Trajectory::move_at(double time_s) const {
  const auto after = std::ranges::upper_bound(moves_, time_s, {}, &Move::begin_s);
  if (after != moves_.begin()) return &*(after - 1);
  return moves_.empty() ? nullptr : moves_.data();
}

Pose2 Trajectory::at(double time_s) const {
  const Move* move = time_s < end_s_ ? move_at(time_s) : nullptr;
  return move != nullptr ? pose_in(*move, time_s) : end_;
}

double Trajectory::travelled_m(double time_s) const {
  const Move* move = time_s < end_s_ ? move_at(time_s) : nullptr;
  return move != nullptr ? move->travelled_m + driven_in(*move, time_s) : length_m_;
}

}  // namespace echoarc::sim
