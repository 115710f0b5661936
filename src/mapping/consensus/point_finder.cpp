// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/point_finder.hpp"

#include <numeric>

namespace echoarc::consensus {
namespace {

// Cells grow with the area until they are as few as this for each position: far-flung positions cost no more memory.
constexpr double cells_per_position = 16.0;

}  // namespace

PointFinder::PointFinder(std::span<const Vec2> positions, double cell_m) : cell_m_(cell_m) {
  if (positions.empty()) return;
  low_ = positions.front();
  Vec2 high = low_;
  for (const Vec2 p : positions) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Vec2 size = high - low_;
  const double most = cells_per_position * double(positions.size()) + 64.0;
  while ((size.x / cell_m_ + 1.0) * (size.y / cell_m_ + 1.0) > most) cell_m_ *= 2.0;
  columns_ = std::int64_t(size.x / cell_m_) + 1;
  rows_ = std::int64_t(size.y / cell_m_) + 1;
  const auto cell_of = [&](Vec2 p) { return std::size_t(row(p.y) * columns_ + column(p.x)); };
  begins_.assign(std::size_t(columns_ * rows_) + 1, 0);
  for (const Vec2 p : positions) ++begins_[cell_of(p) + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  order_.resize(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k) order_[next[cell_of(positions[k])]++] = std::uint32_t(k);
}

PointFinder::Span PointFinder::span_between(Vec2 a, Vec2 b, double low_m, double high_m) {
  if (a.y > b.y) std::swap(a, b);
  if (b.y < low_m || a.y > high_m) return {1.0, 0.0};
  const double rise = b.y - a.y;
  const auto x_at = [&](double y) { return rise > 0.0 ? a.x + (b.x - a.x) * ((y - a.y) / rise) : a.x; };
  const double x0 = a.y < low_m ? x_at(low_m) : a.x;
  const double x1 = b.y > high_m ? x_at(high_m) : b.x;
  return {std::min(x0, x1), std::max(x0, x1)};
}

}  // namespace echoarc::consensus
