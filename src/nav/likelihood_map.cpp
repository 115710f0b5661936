// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/likelihood_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc::nav {
namespace {

// Squared distances in cells; far is beyond every cap.
using Squared = std::uint32_t;
constexpr Squared far = std::numeric_limits<Squared>::max() / 2;

// The field of a fine grid is capped earlier rather than built more slowly: 50 cells of 5 mm are three sigma.
constexpr std::int32_t max_cap_cells = 50;

/// Squared distance to the nearest occupied cell of the same row, for every cell of a field that surrounds the map by
/// `margin` cells.
std::vector<Squared> distances_in_rows(const DenseGrid<CellState>& map, std::int32_t margin) {
  const std::int32_t width = map.width() + 2 * margin;
  std::vector<Squared> field(static_cast<std::size_t>(width) * static_cast<std::size_t>(map.height()), far);
  for (std::int32_t j = 0; j < map.height(); ++j) {
    Squared* const row = field.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width);
    const auto states = map.row(j);
    for (std::int32_t i = 0; i < map.width(); ++i) {
      if (states[static_cast<std::size_t>(i)] != CellState::occupied) continue;
      for (std::int32_t d = -margin; d <= margin; ++d)
        row[i + margin + d] = std::min(row[i + margin + d], static_cast<Squared>(d * d));
    }
  }
  return field;
}

/// The least of the rows within `margin` of one row, with the squared distance of the rows added.
void lower_to_rows(const std::vector<Squared>& rows, std::int32_t row_count, std::int32_t width, std::int32_t margin,
                   std::int32_t j, std::vector<Squared>& least) {
  std::fill(least.begin(), least.end(), far);
  for (std::int32_t k = std::max(0, j - margin); k <= std::min(row_count - 1, j + margin); ++k) {
    const Squared* const row = rows.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(width);
    const auto rows_apart = static_cast<Squared>((k - j) * (k - j));
    for (std::int32_t i = 0; i < width; ++i) {
      const auto n = static_cast<std::size_t>(i);
      least[n] = std::min(least[n], row[i] + rows_apart);
    }
  }
}

int level_of(Squared squared_cells, double cell_m) {
  if (squared_cells >= far) return LikelihoodMap::cap_level;
  const double levels = std::sqrt(static_cast<double>(squared_cells)) * cell_m / LikelihoodMap::step_m;
  return static_cast<int>(std::min<double>(LikelihoodMap::cap_level, std::round(levels)));
}

}  // namespace

LikelihoodMap::LikelihoodMap(const DenseGrid<CellState>& map)
    : cell_m_(map.geometry().cell_m), geometry_(map.geometry()), box_(map.box()) {
  if (map.empty()) return;
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i) {
      if (map.at({i, j}) == CellState::free) free_cells_.push_back({i, j});
      has_walls_ = has_walls_ || map.at({i, j}) == CellState::occupied;
    }
  const auto margin = std::min(max_cap_cells, static_cast<std::int32_t>(std::min(std::ceil(cap_m / cell_m_), 1e6)));
  const std::int32_t width = map.width() + 2 * margin;
  const std::int32_t height = map.height() + 2 * margin;
  low_ = geometry_.corner({-margin, -margin});
  width_ = static_cast<float>(width);
  height_ = static_cast<float>(height);
  row_ = static_cast<std::size_t>(width);
  far_level_ = level_of(static_cast<Squared>(margin * margin), cell_m_);
  const std::vector<Squared> rows = distances_in_rows(map, margin);
  std::vector<Squared> least(row_);
  levels_.reserve(row_ * static_cast<std::size_t>(height));
  for (std::int32_t j = 0; j < height; ++j) {
    lower_to_rows(rows, map.height(), width, margin, j - margin, least);
    for (const Squared squared : least)
      levels_.push_back(static_cast<std::uint8_t>(std::min(far_level_, level_of(squared, cell_m_))));
  }
}

double LikelihoodMap::floor_m2() const {
  return static_cast<double>(free_cells_.size()) * cell_m_ * cell_m_;
}

bool LikelihoodMap::may_stand(Vec2 p) const {
  return is_finite(p) && box_.contains(geometry_.cell_of(p)) && level(to_cells(p)) > 0;
}

bool LikelihoodMap::blocked(Vec2 from, Vec2 to) const {
  const double length_m = norm(to - from);
  if (!(length_m > 0.0)) return false;
  const Vec2 axis = (to - from) / length_m;
  return blocked(to_cells(from), static_cast<float>(axis.x), static_cast<float>(axis.y),
                 static_cast<float>(length_m / cell_m_));
}

bool LikelihoodMap::blocked(Place from, float di, float dj, float reach) const {
  // No occupied cell is nearer than the field says, less a cell's diagonal: so far the ray may leap.
  const float cells_per_level = static_cast<float>(step_m / cell_m_);
  constexpr float diagonal = 1.4143F;
  for (float t = 0.0F; t < reach;) {
    const int here = level({from.i + t * di, from.j + t * dj});
    if (here == 0) return true;
    t += std::max(0.5F, static_cast<float>(here - 1) * cells_per_level - diagonal);
  }
  return false;
}

Vec2 LikelihoodMap::place_at(double share, Rng& rng) const {
  const auto count = static_cast<double>(free_cells_.size());
  const auto n = static_cast<std::size_t>(std::clamp(share * count, 0.0, count - 1.0));
  const double x = rng.uniform(0.0, cell_m_);
  return geometry_.corner(free_cells_[n]) + Vec2{x, rng.uniform(0.0, cell_m_)};
}

}  // namespace echoarc::nav
