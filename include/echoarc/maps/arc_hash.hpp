// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// Place of an arc in a history; reused after the arc has left.
using ArcSlot = std::uint32_t;

/// Whether two closed boxes have a point in common; never with a box that holds nothing (low > high, or NaN).
[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Finds the boxes that overlap a box among many: a hash of square cells, each with the slots whose box meets it.
///
/// A box is kept at the level, of cells twice as large as those of the level below, at which it spans at most four
/// cells each way: the cost of an arc does not depend on its size. Memory grows with the boxes now held, not with the
/// area that was ever visited. Cells beyond the reach of their indices share the outermost cell; answers stay right.
class ArcHash {
 public:
  static constexpr double reach_m = 1e15;  ///< a light month; larger boxes would meet more cells than they should

  explicit ArcHash(double cell_m = 1.0) : cell_m_(cell_m) {}

  /// Requires low <= high and no coordinate beyond `reach_m`.
  void insert(ArcSlot slot, const Box& box);
  /// Requires that the slot was inserted with this box.
  void erase(ArcSlot slot, const Box& box);

  /// Appends the slots whose box overlaps `box`, each once, in no particular order. `boxes[slot]` is the slot's box.
  void find(const Box& box, const std::vector<Box>& boxes, std::vector<ArcSlot>& out) const;
  /// Cells that `find` would look at; more than there are boxes, and looking at each box is quicker.
  [[nodiscard]] double cells_met(const Box& box) const;

  [[nodiscard]] std::size_t memory_bytes() const {
    return cells_.capacity() * sizeof(HashCell) + chunks_.capacity() * sizeof(Chunk);
  }

 private:
  static constexpr std::uint64_t no_key = ~std::uint64_t{0};
  static constexpr std::uint32_t no_chunk = ~std::uint32_t{0};
  static constexpr int max_level = 62;  // level 63 with both indices -1 would be `no_key`
  struct HashCell {
    std::uint64_t key = no_key;
    std::uint32_t head = no_chunk;
  };
  /// A cache line of slots; only the first chunk of a cell is not full.
  struct Chunk {
    std::uint32_t next = no_chunk;
    std::uint32_t count = 0;
    std::array<ArcSlot, 14> slots{};
  };

  [[nodiscard]] int level_of(const Box& box) const;
  [[nodiscard]] CellBox cells_of(const Box& box, int level) const;
  [[nodiscard]] static std::uint64_t key_of(int level, Cell cell);
  [[nodiscard]] std::size_t home_of(std::uint64_t key) const;
  [[nodiscard]] std::size_t place_of(std::uint64_t key) const;
  void add(std::uint64_t key, ArcSlot slot);
  void remove(std::uint64_t key, ArcSlot slot);
  void drop_cell(std::size_t place);
  void grow();

  double cell_m_;
  std::vector<HashCell> cells_;  // open addressing, linear probing; size is a power of two
  std::size_t cell_count_ = 0;
  std::vector<Chunk> chunks_;
  std::uint32_t free_chunk_ = no_chunk;
  std::array<std::uint32_t, max_level + 1> boxes_at_{};
};

}  // namespace echoarc
