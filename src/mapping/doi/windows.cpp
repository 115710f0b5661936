// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <map>
#include <set>

#include "mapping/doi/providers.hpp"

namespace echoarc::doi {
namespace {

std::int32_t floor_div(std::int32_t a, std::int32_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

/// The square of the window lattice that a cell lies in; windows begin at its corners.
Cell lattice_cell(Cell c, std::int32_t stride) {
  return {floor_div(c.i, stride), floor_div(c.j, stride)};
}

/// Where sensors looked when their echoes came out of a square of the window lattice.
class OutwardDirections {
 public:
  OutwardDirections(std::span<const DoiHistory::Sight> sights, const GridGeometry& geometry, std::int32_t stride) {
    for (const DoiHistory::Sight& sight : sights) {
      const Cell middle = geometry.cell_of(sight.origin + sight.range_m * sight.direction);
      Vec2& sum = sums_[lattice_cell(middle, stride)];
      sum = sum + sight.direction;
      origins_ = origins_ + (sight.origin - geometry.origin) / geometry.cell_m;
    }
    if (!sights.empty()) origins_ = origins_ / double(sights.size());
  }
  /// The mean line of sight into `squares` x `squares` lattice squares from `first` on; where no echo has its middle
  /// there, the direction from the sensors' mean position to `mean_cells`.
  [[nodiscard]] Vec2 into(Cell first, std::int32_t squares, Vec2 mean_cells) const {
    Vec2 sum;
    for (std::int32_t b = 0; b < squares; ++b)
      for (std::int32_t a = 0; a < squares; ++a)
        if (const auto found = sums_.find({first.i + a, first.j + b}); found != sums_.end()) sum = sum + found->second;
    return sum == Vec2{} ? mean_cells - origins_ : sum;
  }

 private:
  std::map<Cell, Vec2> sums_;
  Vec2 origins_;  // in cells
};

class Windows {
 public:
  Windows(std::span<const LineCell> cells, const WindowRule& rule)
      : rule_(rule), squares_((rule.size_cells + rule.stride_cells - 1) / rule.stride_cells) {
    std::vector<LineCell>* last = nullptr;  // neighbours mostly share their square
    CellBox box;
    for (const LineCell& c : cells) {
      if (last == nullptr || !box.contains(c.cell)) {
        const Cell square = lattice_cell(c.cell, rule.stride_cells);
        const Cell low{square.i * rule.stride_cells, square.j * rule.stride_cells};
        box = {low.i, low.j, low.i + rule.stride_cells, low.j + rule.stride_cells};
        last = &by_square_[square];
      }
      last->push_back(c);
    }
  }
  [[nodiscard]] std::int32_t squares() const { return squares_; }
  /// First lattice squares of all windows that hold a cell.
  [[nodiscard]] std::set<Cell> all() const {
    std::set<Cell> windows;
    for (const auto& [square, cells] : by_square_)
      for (std::int32_t b = 0; b < squares_; ++b)
        for (std::int32_t a = 0; a < squares_; ++a) windows.insert({square.i - a, square.j - b});
    return windows;
  }
  void cells_of(Cell window, std::vector<LineCell>& out) const {
    out.clear();
    const Cell low{window.i * rule_.stride_cells, window.j * rule_.stride_cells};
    const CellBox box{low.i, low.j, low.i + rule_.size_cells, low.j + rule_.size_cells};
    for (std::int32_t b = 0; b < squares_; ++b)
      for (std::int32_t a = 0; a < squares_; ++a)
        if (const auto found = by_square_.find({window.i + a, window.j + b}); found != by_square_.end())
          for (const LineCell& c : found->second)
            if (box.contains(c.cell)) out.push_back(c);
  }
  [[nodiscard]] Vec2 centre_cells(Cell window) const {
    const double half = 0.5 * rule_.size_cells;
    return {window.i * rule_.stride_cells + half, window.j * rule_.stride_cells + half};
  }

 private:
  WindowRule rule_;
  std::int32_t squares_;
  std::map<Cell, std::vector<LineCell>> by_square_;
};

Spread spread_of_cells(std::span<const LineCell> cells) {
  std::vector<WeightedPoint> points;
  points.reserve(cells.size());
  for (const LineCell& c : cells) points.push_back({{c.cell.i + 0.5, c.cell.j + 0.5}, double(c.count)});
  return spread_of(points);
}

}  // namespace

Spread spread_of(std::span<const WeightedPoint> points) {
  Spread spread;
  Vec2 sum;
  for (const auto& [position, weight] : points) {
    spread.weight += weight;
    sum = sum + weight * position;
  }
  if (spread.weight <= 0.0) return spread;
  spread.mean = sum / spread.weight;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const auto& [position, weight] : points) {
    const Vec2 d = position - spread.mean;
    xx += weight * d.x * d.x;
    xy += weight * d.x * d.y;
    yy += weight * d.y * d.y;
  }
  const double mean = 0.5 * (xx + yy) / spread.weight;
  const double radius = std::hypot(0.5 * (xx - yy), xy) / spread.weight;
  spread.smaller = mean - radius;
  spread.larger = mean + radius;
  spread.across = 0.5 * radians(std::atan2(2.0 * xy, xx - yy)) + degrees(90.0);
  return spread;
}

CellSet window_lines(std::span<const LineCell> cells, const GridGeometry& geometry,
                     std::span<const DoiHistory::Sight> sights, const WindowRule& rule, const LineVisitor& visit) {
  const Windows windows(cells, rule);
  const OutwardDirections outward(sights, geometry, rule.stride_cells);
  CellSet covered;
  covered.reserve(cells.size());
  std::vector<LineCell> inside;
  std::uint64_t first_line = 0;
  for (const Cell window : windows.all()) {
    windows.cells_of(window, inside);
    const Spread spread = spread_of_cells(inside);
    if (spread.weight < rule.min_weight || spread.smaller > rule.max_ratio * spread.larger || inside.size() < 2)
      continue;
    Vec2 direction = unit(spread.across);
    if (dot(direction, outward.into(window, windows.squares(), spread.mean)) < 0.0) direction = -direction;
    // The middle of a window of even size is a cell corner; half a cell aside, lines along an axis hold whole columns.
    const double aside = rule.size_cells % 2 == 0 ? 0.5 : 0.0;
    const Vec2 origin = windows.centre_cells(window) - aside * perpendicular(direction);
    axis_lines(inside, origin, direction,
               [&](std::uint64_t line, std::span<const LineCell> on_line) { visit(first_line + line, on_line); });
    first_line += std::uint64_t{1} << 32;
    for (const LineCell& c : inside) covered.insert(c.cell);
  }
  return covered;
}

}  // namespace echoarc::doi
