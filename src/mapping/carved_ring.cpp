// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/carved_ring.hpp"

#include "mapping/saved_reading.hpp"

namespace echoarc {

bool CarvedRing::carve_silence(const Reading& silent, BeamPolicy policy, double max_range_m) {
  const auto rim = silent_arc(silent, policy, max_range_m);
  if (!rim || !ArcHistory::is_storable(*rim)) return false;
  carve(*rim, silent);
  return true;
}

ArcSlot CarvedRing::enter(const Arc& arc, const Reading& reading) {
  const ArcSlot slot = history_.insert(arc, source_of(reading));
  carver_.admit(history_, slot);
  if (slot >= readings_.size()) readings_.resize(slot + 1);
  readings_[slot] = reading;
  return slot;
}

void CarvedRing::leave(ArcSlot slot) {
  carver_.see_off(slot);
  history_.evict(slot);
}

void CarvedRing::save(ByteWriter& out) const {
  carver_.save_counts(out);
  const std::vector<ArcSlot> slots = history_.in_time_order();
  out.put<std::uint64_t>(slots.size());
  for (const ArcSlot slot : slots) {
    save_reading(out, readings_[slot]);
    carver_.save(out, slot);
  }
}

bool CarvedRing::restore(ByteReader& in, BeamPolicy policy, double max_range_m) {
  carver_.restore_counts(in);
  const auto count = in.get<std::uint64_t>();
  if (!in.ok() || count > capacity_) return false;
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto reading = restore_reading(in);
    if (!reading) return false;
    InsertCounters ignored;
    const auto arc = carvable_arc(*reading, policy, max_range_m, ignored);
    if (!arc || !ArcHistory::is_storable(*arc)) return false;
    if (!carver_.restore(in, enter(*arc, *reading))) return false;
  }
  return true;
}

}  // namespace echoarc
