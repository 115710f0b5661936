// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/arc_history.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace echoarc {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Box nothing{{infinite, infinite}, {-infinite, -infinite}};

Box widened(const Box& box) {
  const Vec2 margin{eps_length_m, eps_length_m};
  return {box.low - margin, box.high + margin};
}

}  // namespace

ArcHistory::ArcHistory(HistoryScope scope, std::size_t capacity)
    : scope_(scope), capacity_(std::max<std::size_t>(1, capacity)) {}

std::optional<ArcSlot> ArcHistory::leaving(SensorId sensor) const {
  if (scope_ == HistoryScope::all) return std::nullopt;
  const auto ring = rings_.find(ring_of(sensor));
  if (ring == rings_.end() || ring->second.size() < capacity_) return std::nullopt;
  return ring->second.front();
}

bool ArcHistory::full() const {
  return !rings_.empty() &&
         std::ranges::all_of(rings_, [&](const auto& ring) { return ring.second.size() >= capacity_; });
}

void ArcHistory::evict(ArcSlot slot) {
  assert(is_live(slot));
  const auto ring = rings_.find(ring_of(entries_[slot].source.sensor));
  assert(ring != rings_.end() && ring->second.front() == slot);
  ring->second.pop_front();
  if (hashed_) hash_.erase(slot, boxes_[slot]);
  boxes_[slot] = nothing;
  entries_[slot].live = false;
  free_slots_.push_back(slot);
  --size_;
}

ArcSlot ArcHistory::insert(const Arc& arc, const ArcSource& source) {
  assert(!leaving(source.sensor) && is_storable(arc));
  ArcSlot slot = static_cast<ArcSlot>(entries_.size());
  if (free_slots_.empty()) {
    entries_.emplace_back();
    boxes_.emplace_back();
  } else {
    slot = free_slots_.back();
    free_slots_.pop_back();
  }
  entries_[slot] = {arc, source, next_sequence_++, true};
  boxes_[slot] = widened(arc.bounds());
  ++size_;
  if (scope_ != HistoryScope::all) rings_[ring_of(source.sensor)].push_back(slot);
  if (hashed_)
    hash_.insert(slot, boxes_[slot]);
  else if (size_ > plain_limit)
    start_hashing();
  return slot;
}

void ArcHistory::start_hashing() {
  hashed_ = true;
  for (ArcSlot slot = 0; slot < entries_.size(); ++slot)
    if (is_live(slot)) hash_.insert(slot, boxes_[slot]);
}

bool ArcHistory::is_storable(const Arc& arc) {
  const Box box = arc.bounds();
  const double farthest =
      std::max({-box.low.x, -box.low.y, box.high.x, box.high.y, std::abs(arc.centre().x), std::abs(arc.centre().y)});
  return farthest < ArcHash::reach_m && is_finite(box.low) && is_finite(box.high);
}

void ArcHistory::candidates(const Box& box, std::vector<ArcSlot>& out) const {
  unordered_candidates(box, out);
  std::ranges::sort(out, {}, [&](ArcSlot slot) { return entries_[slot].sequence; });
}

void ArcHistory::unordered_candidates(const Box& box, std::vector<ArcSlot>& out) const {
  out.clear();
  if (hashed_ && hash_.cells_met(box) < double(size_)) {
    hash_.find(box, boxes_, out);
  } else {
    for (ArcSlot slot = 0; slot < boxes_.size(); ++slot)
      if (overlap(box, boxes_[slot])) out.push_back(slot);
  }
}

std::vector<ArcSlot> ArcHistory::in_time_order() const {
  std::vector<ArcSlot> slots;
  slots.reserve(size_);
  for (ArcSlot slot = 0; slot < entries_.size(); ++slot)
    if (is_live(slot)) slots.push_back(slot);
  std::ranges::sort(slots, {}, [&](ArcSlot slot) { return entries_[slot].sequence; });
  return slots;
}

}  // namespace echoarc
