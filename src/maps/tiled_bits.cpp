// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/tiled_bits.hpp"

#include <algorithm>
#include <bit>

#include "maps/bit_kernels.hpp"

namespace echoarc {
namespace {

/// A column of tiles around one of them: its rows, with the last row of the tile below and the first of the one above.
struct Column {
  std::array<std::uint64_t, tile_size + 2> words{};

  Column(const TiledBits::Words* below, const TiledBits::Words* here, const TiledBits::Words* above) {
    if (below != nullptr) words.front() = below->back();
    if (here != nullptr) std::ranges::copy(*here, words.begin() + 1);
    if (above != nullptr) words.back() = above->front();
  }
};

}  // namespace

const TiledBits::Words* TiledBits::find(Cell tile) const {
  const auto found = std::ranges::lower_bound(tiles_, tile, [](Cell a, Cell b) { return a < b; });
  return found != tiles_.end() && *found == tile ? &words_[std::size_t(found - tiles_.begin())] : nullptr;
}

std::int64_t TiledBits::count() const {
  std::int64_t set = 0;
  for (const Words& words : words_)
    for (const std::uint64_t word : words) set += std::popcount(word);
  return set;
}

TiledBits TiledBits::thinned(int m) const {
  TiledBits out;
  out.tiles_ = tiles_;
  out.words_.resize(words_.size());
  const auto column = [&](std::int32_t i, std::int32_t j) {
    return Column(find({i, j - 1}), find({i, j}), find({i, j + 1}));
  };
  for (std::size_t n = 0; n < tiles_.size(); ++n) {
    const auto [i, j] = tiles_[n];
    const Column west = column(i - 1, j);
    const Column here = column(i, j);
    const Column east = column(i + 1, j);
    const kernels::BitRows rows{west.words.data() + 1, here.words.data() + 1, east.words.data() + 1, 1};
    kernels::bit_kernels().thin(rows, tile_size, m, out.words_[n].data());
  }
  return out;
}

}  // namespace echoarc
