// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/arc_hash.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace echoarc {
namespace {

constexpr double cells_across = 3.0;  // a box of this many cells meets at most one more
constexpr int index_bits = 29;
constexpr std::int32_t max_index = (1 << (index_bits - 1)) - 1;

std::int32_t index(double cells) {
  return static_cast<std::int32_t>(std::clamp(std::floor(cells), -double(max_index), double(max_index)));
}

}  // namespace

int ArcHash::level_of(const Box& box) const {
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y) / (cells_across * cell_m_);
  if (!(extent > 1.0)) return 0;
  return std::min(max_level, std::ilogb(extent) + 1);
}

CellBox ArcHash::cells_of(const Box& box, int level) const {
  const double scale = std::ldexp(1.0, -level) / cell_m_;
  return {index(box.low.x * scale), index(box.low.y * scale), index(box.high.x * scale) + 1,
          index(box.high.y * scale) + 1};
}

std::uint64_t ArcHash::key_of(int level, Cell cell) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << index_bits) - 1;
  return (std::uint64_t(level) << (2 * index_bits)) | ((std::uint64_t(std::uint32_t(cell.i)) & mask) << index_bits) |
         (std::uint64_t(std::uint32_t(cell.j)) & mask);
}

std::size_t ArcHash::home_of(std::uint64_t key) const {
  std::uint64_t h = key * 0x9E3779B97F4A7C15U;
  h ^= h >> 32U;
  return std::size_t(h) & (cells_.size() - 1);
}

/// Where the key is, or where it would go. Requires a table that is not full.
std::size_t ArcHash::place_of(std::uint64_t key) const {
  std::size_t place = home_of(key);
  while (cells_[place].key != key && cells_[place].key != no_key) place = (place + 1) & (cells_.size() - 1);
  return place;
}

void ArcHash::grow() {
  const std::vector<HashCell> old = std::move(cells_);
  cells_.assign(std::max<std::size_t>(64, 2 * old.size()), HashCell{});
  for (const HashCell& cell : old)
    if (cell.key != no_key) cells_[place_of(cell.key)] = cell;
}

void ArcHash::add(std::uint64_t key, ArcSlot slot) {
  if (2 * (cell_count_ + 1) > cells_.size()) grow();
  HashCell& cell = cells_[place_of(key)];
  if (cell.key == no_key) {
    cell = {key, no_chunk};
    ++cell_count_;
  }
  if (cell.head == no_chunk || chunks_[cell.head].count == chunks_[cell.head].slots.size()) {
    std::uint32_t fresh = free_chunk_;
    if (fresh == no_chunk) {
      fresh = static_cast<std::uint32_t>(chunks_.size());
      chunks_.emplace_back();
    } else {
      free_chunk_ = chunks_[fresh].next;
    }
    chunks_[fresh].next = cell.head;
    chunks_[fresh].count = 0;
    cell.head = fresh;
  }
  Chunk& chunk = chunks_[cell.head];
  chunk.slots[chunk.count++] = slot;
}

void ArcHash::remove(std::uint64_t key, ArcSlot slot) {
  const std::size_t place = place_of(key);
  HashCell& cell = cells_[place];
  assert(cell.key == key);
  Chunk& head = chunks_[cell.head];
  for (std::uint32_t c = cell.head; c != no_chunk; c = chunks_[c].next) {
    const auto end = chunks_[c].slots.begin() + chunks_[c].count;
    const auto found = std::find(chunks_[c].slots.begin(), end, slot);
    if (found == end) continue;
    *found = head.slots[--head.count];
    break;
  }
  if (head.count > 0) return;
  const std::uint32_t empty = cell.head;
  cell.head = head.next;
  chunks_[empty].next = free_chunk_;
  free_chunk_ = empty;
  if (cell.head == no_chunk) drop_cell(place);
}

/// Closes the gap in the probe sequence (Knuth 6.4, algorithm R), so that no marks of the deleted pile up.
void ArcHash::drop_cell(std::size_t place) {
  const std::size_t mask = cells_.size() - 1;
  for (std::size_t next = (place + 1) & mask; cells_[next].key != no_key; next = (next + 1) & mask) {
    const std::size_t home = home_of(cells_[next].key);
    if (((next - home) & mask) < ((next - place) & mask)) continue;  // its probe starts behind the gap
    cells_[place] = cells_[next];
    place = next;
  }
  cells_[place] = HashCell{};
  --cell_count_;
}

void ArcHash::insert(ArcSlot slot, const Box& box) {
  const int level = level_of(box);
  const CellBox cells = cells_of(box, level);
  for (std::int32_t j = cells.j_begin; j < cells.j_end; ++j)
    for (std::int32_t i = cells.i_begin; i < cells.i_end; ++i) add(key_of(level, {i, j}), slot);
  ++boxes_at_[std::size_t(level)];
}

void ArcHash::erase(ArcSlot slot, const Box& box) {
  const int level = level_of(box);
  const CellBox cells = cells_of(box, level);
  for (std::int32_t j = cells.j_begin; j < cells.j_end; ++j)
    for (std::int32_t i = cells.i_begin; i < cells.i_end; ++i) remove(key_of(level, {i, j}), slot);
  --boxes_at_[std::size_t(level)];
}

double ArcHash::cells_met(const Box& box) const {
  double count = 0.0;
  for (int level = 0; level <= max_level; ++level) {
    if (boxes_at_[std::size_t(level)] == 0) continue;
    const CellBox cells = cells_of(box, level);
    count += double(cells.width()) * double(cells.height());
  }
  return count;
}

void ArcHash::find(const Box& box, const std::vector<Box>& boxes, std::vector<ArcSlot>& out) const {
  for (int level = 0; level <= max_level; ++level) {
    if (boxes_at_[std::size_t(level)] == 0) continue;
    const CellBox cells = cells_of(box, level);
    const double scale = std::ldexp(1.0, -level) / cell_m_;
    // Two boxes share a rectangle of cells; a slot is reported from its lowest cell alone, so none comes twice.
    const auto reported_here = [&](const Box& other, std::int32_t i, std::int32_t j) {
      return std::max(cells.i_begin, index(other.low.x * scale)) == i &&
             std::max(cells.j_begin, index(other.low.y * scale)) == j;
    };
    for (std::int32_t j = cells.j_begin; j < cells.j_end; ++j)
      for (std::int32_t i = cells.i_begin; i < cells.i_end; ++i) {
        const HashCell& cell = cells_[place_of(key_of(level, {i, j}))];
        for (std::uint32_t c = cell.head; c != no_chunk; c = chunks_[c].next)
          for (std::uint32_t k = 0; k < chunks_[c].count; ++k) {
            const ArcSlot slot = chunks_[c].slots[k];
            if (overlap(box, boxes[slot]) && reported_here(boxes[slot], i, j)) out.push_back(slot);
          }
      }
  }
}

}  // namespace echoarc
