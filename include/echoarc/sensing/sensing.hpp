// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose_track.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/core/speed_of_sound.hpp"
#include "echoarc/sensing/jump_filter.hpp"
#include "echoarc/sensing/laser_limiter.hpp"
#include "echoarc/sensing/poll_stamper.hpp"
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

  /// Before anything is pushed: also makes laser-limited readings, by the rule of the options or `cone_min`. Pings then
  /// wait until odometry is `laser_max_age_s` past them, so that the scans around them are known.
  void use_lasers(const std::vector<LaserMount>& lasers);

  void push(const Odometry& sample);
  void push(const WallNote& note);
  /// Without `use_lasers` scans are of no use and not counted.
  void push(const Scan& scan);
  /// Shown from then on every ping that is rejected, with its number and why, after the readings before it are in
  /// `readings`; an empty visitor ends it. It must not push.
  void watch_rejections(std::function<void(const Ping&, PingId, Rejection)> watcher) { watcher_ = std::move(watcher); }

  /// Pings are numbered as they come: the reading's `ping` is the count of pings before it.
  void push(const Ping& ping);
  /// Registers of the sensors in order of id, which is the order in which they fire. The firings that can be told from
  /// them become pings, one or two polls' flight times later.
  void push(const Poll& poll);
  /// No more polls will come: what they told so far becomes pings.
  void end_of_polls();
  /// No more odometry will come: waiting pings are decided now and later ones at once.
  void end_of_odometry();

  /// Readings since the last `clear_readings`, in the order of the pings.
  [[nodiscard]] std::span<const Reading> readings() const { return readings_; }
  /// The same readings, shortened to what the lasers saw nearer. With the option `laser_limit` all readings are.
  [[nodiscard]] std::span<const Reading> limited_readings() const { return limited_beside_ ? limited_ : readings_; }
  void clear_readings() {
    readings_.clear();
    limited_.clear();
  }

  [[nodiscard]] const SensingReport& report() const { return report_; }
  [[nodiscard]] const PoseTrack& track() const { return track_; }

 private:
  struct Waiting {
    Ping ping;
    PingId id;
    double stamp_half_width_s = 0.0;  ///< of a polled ping: how far its firing may be from the stamp
  };

  void queue(const Ping& ping, double stamp_half_width_s);
  void push_naive(const Poll& poll);
  void take_firings();
  [[nodiscard]] bool stamped_too_loosely(const Waiting& waiting) const;
  [[nodiscard]] bool can_settle(const Waiting& waiting) const;
  void drain();
  void settle(const Waiting& waiting);
  [[nodiscard]] std::optional<Rejection> check_identity(const Ping& ping) const;
  [[nodiscard]] Reading make_reading(const Waiting& waiting, const Pose2& T_world_robot, const Outcome& outcome,
                                     std::uint32_t scan) const;
  [[nodiscard]] DecodedRange decode(const Ping& ping) const;
  [[nodiscard]] WallSide wall_at(double time_s) const;
  [[nodiscard]] std::optional<Rejection> filter(const Reading& reading);
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
  std::optional<PollStamper> stamper_;
  std::vector<double> registers_;  // naive polling
  std::optional<double> newest_poll_s_;
  JumpFilter jumps_;
  std::optional<LaserLimiter> limiter_;
  bool limited_beside_ = false;
  std::vector<Reading> readings_;
  std::vector<Reading> limited_;
  SensingReport report_;
  std::function<void(const Ping&, PingId, Rejection)> watcher_;
};

/// Sensing for the pings of a whole log: the no-echo decisions come from all its values; odometry, wall notes and,
/// where readings are to be laser-limited (by the options, or because `limited_beside` asks for both kinds), laser
/// scans are in, pings follow.
[[nodiscard]] Sensing sensing_for(const Log& log, const SensingOptions& options = {}, bool limited_beside = false);

/// Every register that changed from one poll to the next, as a ping at the time of the later one.
[[nodiscard]] std::vector<Ping> register_changes(const SensorArray& sensors, std::span<const Poll> polls);

/// A whole log: the no-echo decisions from all its values, then every ping. The polls of a log are used when it has no
/// pings of its own.
struct SensedLog {
  std::vector<Reading> readings;
  SensingReport report;
};
[[nodiscard]] SensedLog sense(const Log& log, const SensingOptions& options = {});

}  // namespace echoarc
