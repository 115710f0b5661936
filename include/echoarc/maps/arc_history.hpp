// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "echoarc/maps/arc_hash.hpp"

namespace echoarc {

/// Which arcs a history keeps.
enum class HistoryScope {
  all,         ///< every arc
  per_sensor,  ///< the newest arcs of each receiver
  total,       ///< the newest arcs of all sensors together
};

/// The reading an arc came from.
struct ArcSource {
  PingId ping = 0;
  double time_s = 0.0;
  SensorId sensor = 0;  ///< the receiver
};

/// The arcs of the most recent readings, found by place: what methods that compare arcs with one another work on
/// ([Choset03] IV-D: ten per sensor; [Silver04] 5.C: 250 in total).
///
/// Every arc has a slot, a small number that is reused when the arc has left; users keep what they know about an arc in
/// a vector indexed by slot. An arc that enters a full history displaces the oldest one, which its user sees off first:
///
///     if (const auto old = history.leaving(source.sensor)) {
///       ...                                      // drop what is known about *old; its arc is still there
///       history.evict(*old);
///     }
///     const ArcSlot slot = history.insert(arc, source);
///
/// Few arcs are looked through one by one, many (more than `plain_limit`) by a hash of their boxes.
class ArcHistory {
 public:
  static constexpr std::size_t plain_limit = 512;

  /// `capacity` >= 1: arcs kept per sensor or in total; without meaning for `HistoryScope::all`.
  explicit ArcHistory(HistoryScope scope = HistoryScope::all, std::size_t capacity = 250);

  [[nodiscard]] HistoryScope scope() const { return scope_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  /// Whether every arc that enters now displaces another of its ring; never, where all arcs are kept.
  [[nodiscard]] bool full() const;
  /// Arcs in the history.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Every slot ever given out is below this.
  [[nodiscard]] std::size_t slot_count() const { return entries_.size(); }

  /// The arc that has to leave before one of this sensor can enter.
  [[nodiscard]] std::optional<ArcSlot> leaving(SensorId sensor) const;
  /// Requires `is_live(slot)` and that the slot is the oldest of its sensor or, in total, of all.
  void evict(ArcSlot slot);
  /// Requires `!leaving(source.sensor)` and `is_storable(arc)`.
  ArcSlot insert(const Arc& arc, const ArcSource& source);

  /// Whether the arc lies within `ArcHash::reach_m` of the origin (finite coordinates among it).
  [[nodiscard]] static bool is_storable(const Arc& arc);
  [[nodiscard]] bool is_live(ArcSlot slot) const { return entries_[slot].live; }
  [[nodiscard]] const Arc& arc(ArcSlot slot) const { return entries_[slot].arc; }
  [[nodiscard]] const ArcSource& source(ArcSlot slot) const { return entries_[slot].source; }
  /// Running number of the arc in this slot: larger is newer, never given twice, so it tells a slot's tenants apart.
  [[nodiscard]] std::uint64_t sequence(ArcSlot slot) const { return entries_[slot].sequence; }
  /// `arc(slot).bounds()`, widened by `eps_length_m` so that arcs that only touch are not missed.
  [[nodiscard]] const Box& box(ArcSlot slot) const { return boxes_[slot]; }

  /// Replaces `out` by the slots whose box overlaps `box`, oldest first, each once.
  void candidates(const Box& box, std::vector<ArcSlot>& out) const;
  /// The same in no particular order, for those to whom it does not matter.
  void unordered_candidates(const Box& box, std::vector<ArcSlot>& out) const;
  /// All slots in the history, oldest first.
  [[nodiscard]] std::vector<ArcSlot> in_time_order() const;

  [[nodiscard]] std::size_t memory_bytes() const {
    return entries_.capacity() * (sizeof(Entry) + sizeof(Box)) + hash_.memory_bytes();
  }

 private:
  struct Entry {
    Arc arc;
    ArcSource source;
    std::uint64_t sequence = 0;
    bool live = false;
  };

  [[nodiscard]] SensorId ring_of(SensorId sensor) const { return scope_ == HistoryScope::per_sensor ? sensor : 0; }
  void start_hashing();

  HistoryScope scope_;
  std::size_t capacity_;
  std::size_t size_ = 0;
  std::uint64_t next_sequence_ = 0;
  std::vector<Entry> entries_;  // by slot
  std::vector<Box> boxes_;      // by slot; an empty slot's box holds nothing
  std::vector<ArcSlot> free_slots_;
  std::map<SensorId, std::deque<ArcSlot>> rings_;  // oldest first; unused when every arc is kept
  ArcHash hash_;
  bool hashed_ = false;
};

}  // namespace echoarc
