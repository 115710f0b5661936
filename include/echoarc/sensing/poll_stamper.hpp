// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/log.hpp"

namespace echoarc {

/// From when to when, s.
struct TimeInterval {
  double lo_s = 0.0;
  double hi_s = 0.0;
  [[nodiscard]] double middle_s() const { return 0.5 * (lo_s + hi_s); }
  [[nodiscard]] double half_width_s() const { return 0.5 * (hi_s - lo_s); }
  [[nodiscard]] bool empty() const { return hi_s < lo_s; }
};

/// A firing that polling found out about.
struct StampedFiring {
  std::uint64_t sequence = 0;  ///< counts firings; sensor = sequence mod number of sensors, in firing order
  std::size_t sensor = 0;      ///< place in the firing order
  double register_m = 0.0;     ///< what the sensor's register said then, uninterpreted
  TimeInterval fired;          ///< the firing time lies in it
  std::uint64_t line = 0;
};

/// How the array fires: sensor after sensor, the register of each filled when its echo arrives or its time is out.
struct FiringTiming {
  double gap_min_s = 0.038;  ///< between one firing and the next
  double gap_max_s = 0.042;
  std::vector<double> time_out_s;  ///< per sensor in firing order, 2 r_max / c
};

/// When the firing numbered `sequence` took place that lies between two known ones.
[[nodiscard]] TimeInterval firing_between(const StampedFiring& before, const StampedFiring& after,
                                          std::uint64_t sequence, const FiringTiming& timing);

/// Finds out when sensors fired whose registers are merely polled ([Silver04] App. A).
///
/// A register that changes dates its firing: the echo arrived between two polls, and the flight time of the new value
/// says when it left. All sensors between the last one known to have fired and this one have fired, too, with registers
/// unchanged, and the gaps of the array bound when. The same bounds tell sensors apart that might have fired now or a
/// round ago (a late echo). Nothing is known before the first change, nor again after a silence so long that a change
/// could belong to either of two rounds; the next change then starts afresh.
class PollStamper {
 public:
  struct Counters {
    std::uint64_t polls = 0;
    std::uint64_t bad_polls = 0;     ///< wrong number of registers, or a time that is absurd or not later than before
    std::uint64_t anomalies = 0;     ///< changes that contradict the gaps; dated by the echo alone
    std::uint64_t late_echoes = 0;   ///< changes of a firing that was already counted
    std::uint64_t fresh_starts = 0;  ///< the first change, and every one after too long a silence
  };

  explicit PollStamper(FiringTiming timing);

  /// `flight_s[k]`: flight time of register k's present value, the time-out where it says no echo; NaN where it says
  /// nothing sensible, then any time up to the time-out is possible.
  void push(const Poll& poll, std::span<const double> flight_s);
  /// No more polls: everything known is handed out.
  void finish();

  /// Firings that no later poll can change, in firing order, since the last `clear`.
  [[nodiscard]] std::span<const StampedFiring> firings() const { return done_; }
  void clear() { done_.clear(); }
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  struct Change {
    std::size_t sensor;
    TimeInterval window = {};  // when it fired, by the echo alone
    std::uint64_t sequence = 0;
  };

  [[nodiscard]] std::size_t sensors() const { return timing_.time_out_s.size(); }
  [[nodiscard]] std::vector<Change> changes_of(const Poll& poll, std::span<const double> flight_s) const;
  [[nodiscard]] TimeInterval after_last(std::uint64_t steps) const;
  [[nodiscard]] StampedFiring* pending_at(std::uint64_t sequence);
  [[nodiscard]] std::uint64_t sequence_of(const Change& change);
  void start_afresh(std::vector<Change>& changes, const Poll& poll);
  void apply(const Change& change, const Poll& poll);
  void apply_late(const Change& change, const Poll& poll);
  void add_silent(const StampedFiring& next);
  void add_overdue(const Poll& poll);
  void hand_out(double time_s);
  void hand_out_all();

  FiringTiming timing_;
  std::vector<double> registers_;
  double previous_s_ = 0.0;
  std::optional<StampedFiring> last_;  // the last one surely fired
  std::deque<StampedFiring> pending_;  // up to the last one, not handed out yet
  std::uint64_t silent_ = 0;           // firings since the last change
  std::uint64_t next_round_ = 0;       // after everything handed out
  std::vector<StampedFiring> done_;
  Counters counters_;
};

}  // namespace echoarc
