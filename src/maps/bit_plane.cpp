// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/bit_plane.hpp"

#include <bit>

#include "maps/bit_kernels.hpp"

namespace echoarc {
namespace {

/// The rows of a plane as one run of words: what lies between them has nothing set, and is never asked to be right.
kernels::BitRows rows_of(const std::uint64_t* words, std::size_t stride) {
  const std::uint64_t* const first = words + stride + 1;
  return {first - 1, first, first + 1, std::ptrdiff_t(stride)};
}

}  // namespace

BitPlane::BitPlane(std::int32_t width, std::int32_t height)
    : width_(width),
      height_(height),
      stride_((std::size_t(width) + 63) / 64 + 1),
      words_((std::size_t(height) + 2) * stride_ + 2) {
  assert(width >= 0 && height >= 0);
}

std::int64_t BitPlane::count() const {
  std::int64_t set = 0;
  for (const std::uint64_t word : words_) set += std::popcount(word);
  return set;
}

void BitPlane::thin_into(int m, BitPlane& out) const {
  assert(m >= 0 && m <= 8 && out.width_ == width_ && out.height_ == height_);
  const std::size_t count = std::size_t(height_) * stride_;
  kernels::bit_kernels().thin(rows_of(words_.data(), stride_), count, m, out.words_.data() + stride_ + 1);
}

BitPlane BitPlane::thinned(int m) const {
  BitPlane out(width_, height_);
  thin_into(m, out);
  return out;
}

BitPlane BitPlane::dilated() const {
  BitPlane out(width_, height_);
  const std::size_t count = std::size_t(height_) * stride_;
  kernels::bit_kernels().dilate(rows_of(words_.data(), stride_), count, out.words_.data() + stride_ + 1);
  out.clear_outside();
  return out;
}

BitPlane BitPlane::closed() const {
  BitPlane wider(width_ + 2, height_ + 2);
  for (std::int32_t j = 0; j < height_; ++j)
    for (std::int32_t i = 0; i < width_; ++i)
      if (at({i, j})) wider.set({i + 1, j + 1});
  const BitPlane filled = wider.dilated().eroded();
  BitPlane out(width_, height_);
  for (std::int32_t j = 0; j < height_; ++j)
    for (std::int32_t i = 0; i < width_; ++i)
      if (filled.at({i + 1, j + 1})) out.set({i, j});
  return out;
}

void BitPlane::clear_outside() {
  const std::size_t words = stride_ - 1;
  const int beyond = int(words * 64 - std::size_t(width_));
  for (std::int32_t j = 0; j < height_; ++j) {
    std::uint64_t* const row = words_.data() + (std::size_t(j) + 1) * stride_ + 1;
    if (words > 0) row[words - 1] &= ~std::uint64_t{0} >> beyond;
    row[words] = 0;
  }
}

}  // namespace echoarc
