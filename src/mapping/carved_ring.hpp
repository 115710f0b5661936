// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "mapping/carver.hpp"

namespace echoarc {

/// The ring of recent arcs that arc carving works on: as measured, as carved, and the readings they came from.
class CarvedRing {
 public:
  /// What one arc takes, with its share of the tables that find it.
  static constexpr std::size_t arc_bytes = 2 * sizeof(Remains) + sizeof(Reading) + 256;

  /// `capacity` arcs; 0 is a ring that every arc leaves at once, which is up to its user.
  CarvedRing(std::size_t capacity, double guard_m)
      : capacity_(capacity), history_(HistoryScope::total, capacity), carver_(guard_m) {}

  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] const ArcHistory& history() const { return history_; }
  [[nodiscard]] const Carver& carver() const { return carver_; }
  [[nodiscard]] const Remains& remains(ArcSlot slot) const { return carver_.remains(slot); }
  [[nodiscard]] const Reading& reading(ArcSlot slot) const { return readings_[slot]; }
  [[nodiscard]] std::size_t memory_bytes() const { return history_.size() * arc_bytes; }

  /// What newer readings can do to the arcs of the ring.
  void carve(const Arc& newer, const Reading& by) { carver_.carve(history_, newer, source_of(by)); }
  /// What silence can do to them: it is free space to the sensor's trusted range, at most `max_range_m`. False when it
  /// says nothing.
  bool carve_silence(const Reading& silent, BeamPolicy policy, double max_range_m);
  /// The arc enters the ring; the oldest must have left before (`history().leaving`).
  ArcSlot enter(const Arc& arc, const Reading& reading);
  void leave(ArcSlot slot);

  void save(ByteWriter& out) const;
  /// For an empty ring: false when the bytes hold none that these options could have made. Slots are then in the order
  /// of time.
  [[nodiscard]] bool restore(ByteReader& in, BeamPolicy policy, double max_range_m);

 private:
  std::size_t capacity_;
  ArcHistory history_;
  Carver carver_;
  std::vector<Reading> readings_;  // by slot
};

}  // namespace echoarc
