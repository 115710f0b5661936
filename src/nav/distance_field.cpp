// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace echoarc::nav {
namespace {

// Far beyond any grid, yet its square fits into 64 bits.
constexpr std::int32_t far_cells = 1 << 29;
constexpr std::int32_t furthest_reach_cells = far_cells / 2;
constexpr std::int64_t far_squared = std::numeric_limits<std::int64_t>::max();

CellBox grown(const CellBox& box, std::int32_t by, const CellBox& limits) {
  return {std::max(box.i_begin - by, limits.i_begin), std::max(box.j_begin - by, limits.j_begin),
          std::min(box.i_end + by, limits.i_end), std::min(box.j_end + by, limits.j_end)};
}

/// For every cell of the window, row by row: cells along its column to the nearest occupied cell of the window.
void distances_along_columns(const DenseGrid<CellState>& map, const CellBox& window, std::vector<std::int32_t>& out) {
  const auto width = std::size_t(window.width());
  const auto height = std::size_t(window.height());
  out.resize(width * height);
  for (std::size_t j = 0; j < height; ++j) {
    const auto states = map.row(window.j_begin + std::int32_t(j)).subspan(std::size_t(window.i_begin), width);
    std::int32_t* const row = out.data() + j * width;
    const std::int32_t* const below = j == 0 ? nullptr : row - width;
    for (std::size_t i = 0; i < width; ++i) {
      const std::int32_t up = below == nullptr ? far_cells : std::min(below[i] + 1, far_cells);
      row[i] = states[i] == CellState::occupied ? 0 : up;
    }
  }
  for (std::size_t j = height - 1; j-- > 0;) {
    std::int32_t* const row = out.data() + j * width;
    const std::int32_t* const above = row + width;
    for (std::size_t i = 0; i < width; ++i) row[i] = std::min(row[i], above[i] + 1);
  }
}

/// Lower envelope of the parabolas (x - i)^2 + columns[i]^2 at whole x; [Felzenszwalb12] section 2.1. All terms are
/// whole numbers, so that a rounded intersection can only err where both parabolas are equally low.
class Envelope {
 public:
  void squared_distances(std::span<const std::int32_t> columns, std::int32_t furthest, std::span<std::int64_t> out) {
    lowest_.clear();
    begins_.clear();
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i] <= furthest) add(std::int64_t(i), columns);
    if (lowest_.empty()) {
      std::ranges::fill(out, far_squared);
      return;
    }
    std::size_t k = 0;
    for (std::size_t x = 0; x < out.size(); ++x) {
      while (k + 1 < lowest_.size() && begins_[k + 1] <= double(x)) ++k;
      const std::int64_t across = std::int64_t(x) - lowest_[k];
      const std::int64_t along = columns[std::size_t(lowest_[k])];
      out[x] = across * across + along * along;
    }
  }

 private:
  void add(std::int64_t i, std::span<const std::int32_t> columns) {
    const auto height = [&](std::int64_t k) { return std::int64_t{columns[std::size_t(k)]} * columns[std::size_t(k)]; };
    double begin = -std::numeric_limits<double>::infinity();
    while (!lowest_.empty()) {
      const std::int64_t k = lowest_.back();
      begin = double(height(i) + i * i - height(k) - k * k) / double(2 * (i - k));
      if (begin > begins_.back()) break;
      lowest_.pop_back();
      begins_.pop_back();
      begin = -std::numeric_limits<double>::infinity();
    }
    lowest_.push_back(i);
    begins_.push_back(begin);
  }

  std::vector<std::int64_t> lowest_;  // the parabolas of the envelope, from the left
  std::vector<double> begins_;        // where each becomes the lowest
};

}  // namespace

DenseGrid<float> distance_field(const DenseGrid<CellState>& map) {
  DenseGrid<float> distances_m(map.geometry(), map.width(), map.height(), std::numeric_limits<float>::infinity());
  if (map.empty()) return distances_m;
  std::vector<std::int32_t> columns;
  distances_along_columns(map, map.box(), columns);
  Envelope envelope;
  const auto width = std::size_t(map.width());
  std::vector<std::int64_t> row(width);
  for (std::int32_t j = 0; j < map.height(); ++j) {
    envelope.squared_distances(std::span(columns).subspan(std::size_t(j) * width, width), far_cells - 1, row);
    for (std::int32_t i = 0; i < map.width(); ++i)
      if (row[std::size_t(i)] != far_squared)
        distances_m.at({i, j}) = float(map.geometry().cell_m * std::sqrt(double(row[std::size_t(i)])));
  }
  return distances_m;
}

void CappedDistanceField::reset(const DenseGrid<CellState>& map) {
  distances_m_ = DenseGrid<float>(map.geometry(), map.width(), map.height(), float(cap_m_));
  compute(map, map.box());
}

CellBox CappedDistanceField::update(const DenseGrid<CellState>& map, const CellBox& changed) {
  if (changed.empty()) return {};
  const CellBox box = grown(changed, reach_cells(), map.box());
  compute(map, box);
  return box;
}

std::int32_t CappedDistanceField::reach_cells() const {
  return std::int32_t(std::ceil(std::min(cap_m_ / distances_m_.geometry().cell_m, double(furthest_reach_cells))));
}

void CappedDistanceField::compute(const DenseGrid<CellState>& map, const CellBox& box) {
  if (box.empty()) return;
  const CellBox window = grown(box, reach_cells(), map.box());  // an obstacle further away cannot matter
  distances_along_columns(map, window, columns_);
  Envelope envelope;
  const auto width = std::size_t(window.width());
  row_.resize(width);
  const double cell_m = map.geometry().cell_m;
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j) {
    const auto columns = std::span(columns_).subspan(std::size_t(j - window.j_begin) * width, width);
    envelope.squared_distances(columns, reach_cells(), row_);
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const std::int64_t squared = row_[std::size_t(i - window.i_begin)];
      const double distance_m = squared == far_squared ? cap_m_ : cell_m * std::sqrt(double(squared));
      distances_m_.at({i, j}) = float(std::min(distance_m, cap_m_));
    }
  }
}

}  // namespace echoarc::nav
