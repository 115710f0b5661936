// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose_track.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/core/speed_of_sound.hpp"
#include "echoarc/sensing/scan_numbering.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/sensing/sensing_report.hpp"

namespace echoarc {

/// Turns what the hardware said into readings: outcome, pose at the firing time, range limits, scan number, followed
/// wall. Every ping ends as a reading or under a reason.
///
/// A ping waits until odometry reaches its time; readings come out in the order of the pings. Pushed record by record
/// as they arrive, or all odometry first and the pings after `end_of_odometry`, the readings are the same, as long as
/// no ping is stamped more than `max_wait_s` ahead of the odometry before it, and fewer than `max_waiting` pings wait.
class Sensing {
 public:
  /// More waiting pings than this: the newest is given up as `no_pose`.
  static constexpr std::size_t max_waiting = std::size_t{1} << 16;

  /// `no_echo` holds one decision per sensor, as from `decide_no_echo`; empty: `describe_no_echo` of each.
  /// `recorded_temperature_k`: the air temperature for which the ranges were computed.
  explicit Sensing(SensorArray sensors, const SensingOptions& options = {}, std::vector<NoEchoDecision> no_echo = {},
                   double recorded_temperature_k = default_temperature_k);

  void push(const Odometry& sample);
  void push(const WallNote& note);
  /// Pings are numbered as they come: the reading's `ping` is the count of pings before it.
  void push(const Ping& ping);
  /// No more odometry will come: waiting pings are decided now and later ones at once.
  void end_of_odometry();

  /// Readings since the last `clear_readings`, in the order of the pings.
  [[nodiscard]] std::span<const Reading> readings() const { return readings_; }
  void clear_readings() { readings_.clear(); }

  [[nodiscard]] const SensingReport& report() const { return report_; }
  [[nodiscard]] const PoseTrack& track() const { return track_; }

 private:
  struct Waiting {
    Ping ping;
    PingId id;
  };

  [[nodiscard]] bool can_settle(const Ping& ping) const;
  void drain();
  void settle(const Waiting& waiting);
  [[nodiscard]] std::optional<Rejection> check_identity(const Ping& ping) const;
  [[nodiscard]] Reading make_reading(const Waiting& waiting, const Pose2& T_world_robot, const Outcome& outcome,
                                     std::uint32_t scan) const;
  [[nodiscard]] DecodedRange decode(const Ping& ping) const;
  [[nodiscard]] WallSide wall_at(double time_s) const;
  void accept(const Reading& reading);
  void reject(const Waiting& waiting, Rejection reason);
  [[nodiscard]] SensorTally* tally_of(SensorId sensor);

  SensorArray sensors_;
  SensingOptions options_;
  double recorded_temperature_k_;
  PoseTrack track_;
  std::vector<WallNote> walls_;
  std::deque<Waiting> waiting_;
  ScanNumbering scans_;
  std::optional<double> newest_ping_s_;
  bool odometry_ended_ = false;
  std::vector<Reading> readings_;
  SensingReport report_;
};

/// Sensing for the pings of a whole log: the no-echo decisions come from all its values; odometry and wall notes are
/// in, pings follow.
[[nodiscard]] Sensing sensing_for(const Log& log, const SensingOptions& options = {});

/// A whole log: the no-echo decisions from all its values, then every ping.
struct SensedLog {
  std::vector<Reading> readings;
  SensingReport report;
};
[[nodiscard]] SensedLog sense(const Log& log, const SensingOptions& options = {});

}  // namespace echoarc
