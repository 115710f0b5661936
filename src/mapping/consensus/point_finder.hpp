// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/vec2.hpp"

namespace echoarc::consensus {

/// Edge of the cells, for positions on surfaces that are looked for within decimetres.
inline constexpr double finder_cell_m = 0.25;

/// Positions sorted into square cells, to find those near a place or along a way. Holds indices, not positions.
class PointFinder {
 public:
  explicit PointFinder(std::span<const Vec2> positions, double cell_m = finder_cell_m);

  /// Calls `visit(index)` for at least every position within `reach_m` of `p`.
  template <class Visit>
  void near(Vec2 p, double reach_m, Visit visit) const {
    along(p, p, reach_m, visit);
  }

  /// Calls `visit(index)` for at least every position within `reach_m` of the segment from `a` to `b`, each once.
  template <class Visit>
  void along(Vec2 a, Vec2 b, double reach_m, Visit visit) const {
    if (begins_.empty()) return;
    const std::int64_t row_begin = row(std::min(a.y, b.y) - reach_m);
    const std::int64_t row_end = row(std::max(a.y, b.y) + reach_m);
    for (std::int64_t j = row_begin; j <= row_end; ++j) {
      // The part of the segment within reach of this row of cells, and the cells within reach of that part.
      const double low_m = low_.y + double(j) * cell_m_ - reach_m;
      const double high_m = low_m + cell_m_ + 2.0 * reach_m;
      const auto [x_low, x_high] = span_between(a, b, low_m, high_m);
      if (x_low > x_high) continue;
      const std::int64_t begin = column(x_low - reach_m);
      const std::int64_t end = column(x_high + reach_m);
      const std::size_t first = std::size_t(j * columns_ + begin);
      const std::size_t last = std::size_t(j * columns_ + end);
      for (std::size_t k = begins_[first]; k < begins_[last + 1]; ++k) visit(std::size_t(order_[k]));
    }
  }

 private:
  struct Span {
    double low, high;
  };
  /// x of the part of a segment with low_m <= y <= high_m; empty (low > high) if there is none.
  static Span span_between(Vec2 a, Vec2 b, double low_m, double high_m);
  [[nodiscard]] std::int64_t clamped(double cells, std::int64_t count) const {
    return std::int64_t(std::clamp(std::floor(cells), 0.0, double(count - 1)));
  }
  [[nodiscard]] std::int64_t row(double y) const { return clamped((y - low_.y) / cell_m_, rows_); }
  [[nodiscard]] std::int64_t column(double x) const { return clamped((x - low_.x) / cell_m_, columns_); }

  double cell_m_;
  Vec2 low_;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
  std::vector<std::uint32_t> begins_;  // by cell, row after row, and the end
  std::vector<std::uint32_t> order_;   // indices, cell after cell
};

/// Calls `visit(index)` for the positions within `reach_m` of `p`, and for no others. `finder` is over `positions`.
template <class Visit>
void visit_within(std::span<const Vec2> positions, const PointFinder& finder, Vec2 p, double reach_m, Visit visit) {
  finder.near(p, reach_m, [&](std::size_t k) {
    if (squared_norm(positions[k] - p) <= reach_m * reach_m) visit(k);
  });
}

}  // namespace echoarc::consensus
