// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/poll_stamper.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace echoarc {
namespace {

/// Stamps beyond this (3000 years) leave nothing of a millisecond.
constexpr double latest_s = 1e11;
/// After so many rounds without a change nothing is handed out either, however steady the array.
constexpr std::uint64_t most_silent_rounds = 64;
/// Registers are filled a little after the time is out.
constexpr double time_out_slack_s = 0.002;

bool same_register(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

TimeInterval intersection(const TimeInterval& a, const TimeInterval& b) {
  return {std::max(a.lo_s, b.lo_s), std::min(a.hi_s, b.hi_s)};
}

/// 0 where they overlap.
double apart_s(const TimeInterval& a, const TimeInterval& b) {
  return std::max({0.0, a.lo_s - b.hi_s, b.lo_s - a.hi_s});
}

}  // namespace

TimeInterval firing_between(const StampedFiring& before, const StampedFiring& after, std::uint64_t sequence,
                            const FiringTiming& timing) {
  const auto since = double(sequence - before.sequence);
  const auto until = double(after.sequence - sequence);
  return {std::max(before.fired.lo_s + since * timing.gap_min_s, after.fired.lo_s - until * timing.gap_max_s),
          std::min(before.fired.hi_s + since * timing.gap_max_s, after.fired.hi_s - until * timing.gap_min_s)};
}

PollStamper::PollStamper(FiringTiming timing) : timing_(std::move(timing)) {
  assert(!timing_.time_out_s.empty() && timing_.gap_min_s > 0.0 && timing_.gap_min_s <= timing_.gap_max_s);
}

void PollStamper::push(const Poll& poll, std::span<const double> flight_s) {
  ++counters_.polls;
  const bool first = registers_.empty();
  if (poll.ranges_m.size() != sensors() || flight_s.size() != sensors() || !(std::abs(poll.time_s) <= latest_s) ||
      (!first && poll.time_s <= previous_s_)) {
    ++counters_.bad_polls;
    return;
  }
  if (first) {
    registers_ = poll.ranges_m;
  } else {
    std::vector<Change> changes = changes_of(poll, flight_s);
    if (!last_ && !changes.empty()) start_afresh(changes, poll);
    for (Change& change : changes) change.sequence = sequence_of(change);
    std::ranges::sort(changes, {}, &Change::sequence);
    for (const Change& change : changes) apply(change, poll);
    add_overdue(poll);
    hand_out(poll.time_s);
  }
  previous_s_ = poll.time_s;
}

std::vector<PollStamper::Change> PollStamper::changes_of(const Poll& poll, std::span<const double> flight_s) const {
  std::vector<Change> changes;
  for (std::size_t k = 0; k < sensors(); ++k) {
    if (same_register(poll.ranges_m[k], registers_[k])) continue;
    const bool known = !std::isnan(flight_s[k]);
    const double longest_s = known ? flight_s[k] : timing_.time_out_s[k] + time_out_slack_s;
    const double shortest_s = known ? flight_s[k] : 0.0;
    changes.push_back({.sensor = k, .window = {previous_s_ - longest_s, poll.time_s - shortest_s}});
  }
  return changes;
}

/// When the firing `steps` after the last one known is due.
TimeInterval PollStamper::after_last(std::uint64_t steps) const {
  return {last_->fired.lo_s + double(steps) * timing_.gap_min_s, last_->fired.hi_s + double(steps) * timing_.gap_max_s};
}

StampedFiring* PollStamper::pending_at(std::uint64_t sequence) {
  if (pending_.empty() || sequence < pending_.front().sequence || sequence > pending_.back().sequence) return nullptr;
  return &pending_[sequence - pending_.front().sequence];
}

/// The change belongs to the sensor's next firing or, a late echo, to the one before: whichever is nearer in time.
std::uint64_t PollStamper::sequence_of(const Change& change) {
  const std::uint64_t n = sensors();
  const std::uint64_t steps = (change.sensor + n - last_->sensor - 1) % n + 1;
  const std::uint64_t forward = last_->sequence + steps;
  const StampedFiring* before = pending_at(forward - n);
  if (before == nullptr) return forward;
  return apart_s(before->fired, change.window) < apart_s(after_last(steps), change.window) ? forward - n : forward;
}

/// The earliest change is where counting starts; its number leaves room for a round before it.
void PollStamper::start_afresh(std::vector<Change>& changes, const Poll& poll) {
  ++counters_.fresh_starts;
  const auto earliest = std::ranges::min_element(changes, {}, [](const Change& c) { return c.window.middle_s(); });
  silent_ = 0;
  next_round_ += 2;  // numbers go on after a fresh start, whatever was missed
  last_ = StampedFiring{.sequence = next_round_ * sensors() + earliest->sensor,
                        .sensor = earliest->sensor,
                        .register_m = poll.ranges_m[earliest->sensor],
                        .fired = earliest->window,
                        .line = poll.line};
  registers_[earliest->sensor] = last_->register_m;
  pending_.push_back(*last_);
  changes.erase(earliest);
}

void PollStamper::apply(const Change& change, const Poll& poll) {
  registers_[change.sensor] = poll.ranges_m[change.sensor];
  silent_ = 0;
  if (change.sequence <= last_->sequence) return apply_late(change, poll);
  StampedFiring fired{.sequence = change.sequence,
                      .sensor = change.sensor,
                      .register_m = poll.ranges_m[change.sensor],
                      .fired = intersection(change.window, after_last(change.sequence - last_->sequence)),
                      .line = poll.line};
  if (fired.fired.empty()) {
    ++counters_.anomalies;
    fired.fired = change.window;
  }
  add_silent(fired);
  pending_.push_back(fired);
  last_ = fired;
}

void PollStamper::apply_late(const Change& change, const Poll& poll) {
  ++counters_.late_echoes;
  StampedFiring& firing = *pending_at(change.sequence);
  firing.register_m = poll.ranges_m[change.sensor];
  firing.line = poll.line;
  const TimeInterval both = intersection(firing.fired, change.window);
  if (!both.empty()) firing.fired = both;
  if (change.sequence == last_->sequence) last_ = firing;
}

/// The sensors between the last one known and `next` have fired, too, and their registers did not change.
void PollStamper::add_silent(const StampedFiring& next) {
  for (std::uint64_t m = last_->sequence + 1; m < next.sequence; ++m) {
    const std::size_t sensor = m % sensors();
    TimeInterval fired = firing_between(*last_, next, m, timing_);
    if (fired.empty()) fired = after_last(m - last_->sequence);  // an anomaly, counted with `next`
    pending_.push_back(
        {.sequence = m, .sensor = sensor, .register_m = registers_[sensor], .fired = fired, .line = next.line});
  }
}

/// Sensors whose firing is so long ago that a change would have shown have fired with their registers unchanged.
void PollStamper::add_overdue(const Poll& poll) {
  while (last_) {
    const std::size_t sensor = (last_->sensor + 1) % sensors();
    const TimeInterval due = after_last(1);
    if (!(poll.time_s > due.hi_s + timing_.time_out_s[sensor] + time_out_slack_s)) return;
    const bool ambiguous = 2.0 * due.half_width_s() > 0.5 * double(sensors()) * timing_.gap_min_s;
    if (ambiguous || ++silent_ > most_silent_rounds * sensors()) {
      // A change could soon belong to either of two rounds: better to say nothing until there is one.
      hand_out_all();
      last_.reset();
      return;
    }
    last_ = StampedFiring{.sequence = last_->sequence + 1,
                          .sensor = sensor,
                          .register_m = registers_[sensor],
                          .fired = due,
                          .line = poll.line};
    pending_.push_back(*last_);
  }
}

/// What no late echo can change any more.
void PollStamper::hand_out(double time_s) {
  while (!pending_.empty()) {
    const StampedFiring& firing = pending_.front();
    if (!(time_s > firing.fired.hi_s + timing_.time_out_s[firing.sensor] + time_out_slack_s)) return;
    done_.push_back(firing);
    next_round_ = firing.sequence / sensors() + 1;
    pending_.pop_front();
  }
}

void PollStamper::hand_out_all() {
  done_.insert(done_.end(), pending_.begin(), pending_.end());
  if (!pending_.empty()) next_round_ = pending_.back().sequence / sensors() + 1;
  pending_.clear();
}

void PollStamper::finish() {
  hand_out_all();
  last_.reset();
}

}  // namespace echoarc
