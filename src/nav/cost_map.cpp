// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/cost_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "nav/cells_on_way.hpp"

namespace echoarc::nav {
namespace {

// A map that has outgrown its place will do so again: room for that on every side, so that all is rarely made anew.
constexpr std::int32_t spare_cells = 64;
// Corners of two grids this near to a whole number of cells apart lie on one lattice.
constexpr double lattice_tolerance_cells = 1e-3;

void include(CellBox& box, Cell c) {
  box = unite(box, {c.i, c.j, c.i + 1, c.j + 1});
}

/// The columns in which two rows of states differ, [first, last + 1); empty where they do not.
std::pair<std::int32_t, std::int32_t> difference(std::span<const CellState> a, std::span<const CellState> b) {
  if (std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) return {0, 0};
  const auto first = std::ranges::mismatch(a, b).in1 - a.begin();
  auto last = std::ptrdiff_t(a.size());
  while (a[std::size_t(last - 1)] == b[std::size_t(last - 1)]) --last;
  return {std::int32_t(first), std::int32_t(last)};
}

}  // namespace

CostMap::CostMap(const CostMapOptions& options, double robot_radius_m)
    : options_(options),
      body_m_(robot_radius_m),
      inflation_m_(robot_radius_m + options.margin_m),
      clearance_(std::max(options.clearance_m, inflation_m_)) {}

CellBox CostMap::update(const DenseGrid<CellState>& map) {
  if (map.empty()) return {};
  if (!fits(map)) {
    rebuild(map);
    return cells_.box();
  }
  const bool same_place = map.geometry() == source_.geometry() && map.box() == source_.box();
  CellBox own = cells_.box();
  if (same_place) {
    const CellBox changed = changed_cells(map);
    if (changed.empty()) return {};
    const auto k = lattice_.factor;
    own = {(changed.i_begin + lattice_.offset.i) / k, (changed.j_begin + lattice_.offset.j) / k,
           (changed.i_end - 1 + lattice_.offset.i) / k + 1, (changed.j_end - 1 + lattice_.offset.j) / k + 1};
    for (std::int32_t j = changed.j_begin; j < changed.j_end; ++j)
      std::ranges::copy(map.row(j), source_.values().begin() + std::ptrdiff_t(j) * map.width());
  } else {
    source_ = map;
    lattice_.offset = {
        std::int32_t(std::lround((map.geometry().origin.x - geometry().origin.x) / map.geometry().cell_m)),
        std::int32_t(std::lround((map.geometry().origin.y - geometry().origin.y) / map.geometry().cell_m))};
  }
  const CellBox differing = take_over(map, own);
  price(clearance_.update(cells_, differing));
  if (!differing.empty()) ++version_;
  return differing;
}

CellBox CostMap::drive_through(Vec2 a, Vec2 b) {
  if (cells_.empty() || !is_finite(a) || !is_finite(b)) return {};
  CellBox marked;
  for_cells_on_way(geometry(), a, b, [&](Cell c, double) {
    if (!traces_.box().contains(c)) return false;
    if (traces_.at(c) == centre) return true;
    traces_.at(c) = centre;
    marked = unite(marked, mark_body(geometry().centre(c)));
    return true;
  });
  if (marked.empty()) return {};
  const CellBox differing = take_over(source_, marked);
  price(unite(clearance_.update(cells_, differing), marked));
  ++version_;
  return differing;
}

/// Cells that a robot whose centre is in a cell covers wherever it is in that cell.
CellBox CostMap::mark_body(Vec2 place) {
  const double sure_m = body_m_ - geometry().cell_m;
  const CellBox box = geometry().cells_of({place - Vec2{body_m_, body_m_}, place + Vec2{body_m_, body_m_}});
  const CellBox within{std::max(box.i_begin, 0), std::max(box.j_begin, 0), std::min(box.i_end, cells_.width()),
                       std::min(box.j_end, cells_.height())};
  for (std::int32_t j = within.j_begin; j < within.j_end; ++j)
    for (std::int32_t i = within.i_begin; i < within.i_end; ++i)
      if (auto& trace = traces_.at({i, j}); trace == none && norm(geometry().centre({i, j}) - place) <= sure_m)
        trace = body;
  return within;
}

/// Whether the cells of `map` fall on own cells.
bool CostMap::fits(const DenseGrid<CellState>& map) const {
  if (cells_.empty() || map.geometry().cell_m != source_.geometry().cell_m) return false;
  const Vec2 offset = (map.geometry().origin - geometry().origin) / map.geometry().cell_m;
  const auto on_lattice = [](double cells) { return std::abs(cells - std::round(cells)) < lattice_tolerance_cells; };
  if (!on_lattice(offset.x) || !on_lattice(offset.y)) return false;
  return std::round(offset.x) >= 0.0 && std::round(offset.y) >= 0.0 &&
         std::round(offset.x) + map.width() <= double(cells_.width()) * lattice_.factor &&
         std::round(offset.y) + map.height() <= double(cells_.height()) * lattice_.factor;
}

void CostMap::rebuild(const DenseGrid<CellState>& map) {
  const double source_cell_m = map.geometry().cell_m;
  const auto k = std::max(1, std::int32_t(std::floor(options_.cell_m / source_cell_m + lattice_tolerance_cells)));
  const std::int32_t spare = rebuilds_++ == 0 ? 0 : spare_cells;
  lattice_ = {k, {spare * k, spare * k}};
  const double cell_m = source_cell_m * k;
  const GridGeometry own{cell_m, map.geometry().origin - spare * cell_m * Vec2{1.0, 1.0}};
  cells_ = DenseGrid<CellState>(own, (map.width() + k - 1) / k + 2 * spare, (map.height() + k - 1) / k + 2 * spare);
  cost_per_m_ = DenseGrid<float>(own, cells_.width(), cells_.height());
  source_ = map;
  keep_traces(own);
  take_over(map, cells_.box());
  clearance_.reset(cells_);
  price(cells_.box());
  ++version_;
}

/// On cells of another size they would claim more, or less, than what was driven.
void CostMap::keep_traces(const GridGeometry& own) {
  const DenseGrid<std::uint8_t> before = std::move(traces_);
  traces_ = DenseGrid<std::uint8_t>(own, cells_.width(), cells_.height(), none);
  if (before.empty() || before.geometry().cell_m != own.cell_m) return;
  for (std::int32_t j = 0; j < before.height(); ++j)
    for (std::int32_t i = 0; i < before.width(); ++i)
      if (const Cell c = own.cell_of(before.geometry().centre({i, j}));
          before.at({i, j}) != none && traces_.box().contains(c))
        traces_.at(c) = before.at({i, j});
}

CellBox CostMap::changed_cells(const DenseGrid<CellState>& map) const {
  CellBox changed;
  for (std::int32_t j = 0; j < map.height(); ++j)
    if (const auto [begin, end] = difference(map.row(j), source_.row(j)); begin < end)
      changed = unite(changed, {begin, j, end, j + 1});
  return changed;
}

CellBox CostMap::take_over(const DenseGrid<CellState>& map, const CellBox& own) {
  CellBox differing;
  for (std::int32_t j = own.j_begin; j < own.j_end; ++j)
    for (std::int32_t i = own.i_begin; i < own.i_end; ++i)
      if (const CellState state = merged(map, {i, j}); state != cells_.at({i, j})) {
        cells_.at({i, j}) = state;
        include(differing, {i, j});
      }
  return differing;
}

CellState CostMap::merged(const DenseGrid<CellState>& map, Cell own) const {
  const auto k = lattice_.factor;
  const Cell low{own.i * k - lattice_.offset.i, own.j * k - lattice_.offset.j};
  CellState state = traces_.at(own) == none ? CellState::unknown : CellState::free;
  for (std::int32_t j = std::max(low.j, 0); j < std::min(low.j + k, map.height()); ++j)
    for (std::int32_t i = std::max(low.i, 0); i < std::min(low.i + k, map.width()); ++i) {
      const CellState part = map.at({i, j});
      if (part == CellState::occupied) return traces_.at(own) == none ? part : CellState::free;
      if (part == CellState::free) state = part;
    }
  return state;
}

void CostMap::price(const CellBox& box) {
  const auto& clearance_m = clearance_.distances_m();
  const auto inflation_m = float(inflation_m_);
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j)
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const Cell c{i, j};
      const CellState state = cells_.at(c);
      const float clear_m = clearance_m.at(c);
      const bool blocked = traces_.at(c) != centre && (state == CellState::occupied || clear_m < inflation_m ||
                                                       (state == CellState::unknown && !options_.unknown_passable));
      const double missing = std::max(0.0, 1.0 - double(clear_m) / options_.clearance_m);
      cost_per_m_.at(c) = blocked ? 0.0F : float(1.0 + options_.clearance_weight * missing);
    }
}

}  // namespace echoarc::nav
