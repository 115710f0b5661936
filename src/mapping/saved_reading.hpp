// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <optional>

#include "echoarc/core/bytes.hpp"
#include "echoarc/core/reading.hpp"

/// Readings in saved states: what a method with a history keeps of each.
namespace echoarc {

inline void save_reading(ByteWriter& out, const Reading& r) {
  out.put(r.ping);
  out.put(r.time_s);
  for (const std::uint32_t id : {r.scan, r.tx, r.rx}) out.put(id);
  for (const Pose2* pose : {&r.T_world_robot, &r.T_world_tx, &r.T_world_rx}) {
    out.put(pose->position);
    out.put(pose->heading);
  }
  out.put(r.beam_width);
  for (const double range_m : {r.range_min_m, r.range_max_m, r.trusted_range_m}) out.put(range_m);
  out.put<std::uint64_t>(r.outcome.index());
  out.put(echo_range_m(r.outcome).value_or(0.0));
  out.put<std::uint8_t>(r.laser_limited ? 1 : 0);
  out.put<std::uint8_t>(static_cast<std::uint8_t>(r.wall));
}

namespace detail {

/// An outcome by its place in the variant; Invalid for a number that is none.
[[nodiscard]] inline Outcome outcome_at(std::uint64_t index, double range_m) {
  switch (index) {
    case 0: return NoEcho{};
    case 1: return Echo{range_m};
    case 2: return TooClose{};
    default: return Invalid{};
  }
}

[[nodiscard]] inline bool is_sound(const Reading& r) {
  const auto range_m = echo_range_m(r.outcome);
  const bool poses = is_finite(r.T_world_robot) && is_finite(r.T_world_tx) && is_finite(r.T_world_rx);
  const bool beam = r.beam_width > Angle{} && r.beam_width < degrees(180.0);
  return poses && beam && (!range_m || (*range_m > 0.0 && std::isfinite(*range_m)));
}

}  // namespace detail

/// No value when the bytes run out or the reading is one that no sensor could have given.
[[nodiscard]] inline std::optional<Reading> restore_reading(ByteReader& in) {
  Reading r;
  r.ping = in.get<PingId>();
  r.time_s = in.get<double>();
  for (std::uint32_t* id : {&r.scan, &r.tx, &r.rx}) *id = in.get<std::uint32_t>();
  for (Pose2* pose : {&r.T_world_robot, &r.T_world_tx, &r.T_world_rx}) {
    pose->position = in.get<Vec2>();
    pose->heading = in.get<Angle>();
  }
  r.beam_width = in.get<Angle>();
  for (double* range_m : {&r.range_min_m, &r.range_max_m, &r.trusted_range_m}) *range_m = in.get<double>();
  const auto index = in.get<std::uint64_t>();
  r.outcome = detail::outcome_at(index, in.get<double>());
  r.laser_limited = in.get<std::uint8_t>() != 0;
  const auto wall = in.get<std::uint8_t>();
  r.wall = static_cast<WallSide>(wall);
  if (!in.ok() || wall > static_cast<std::uint8_t>(WallSide::right) || !detail::is_sound(r)) return std::nullopt;
  return r;
}

}  // namespace echoarc
