// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "echoarc/core/options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::live {

/// What the number in a cell of a method says.
enum class CellMeaning : std::uint8_t {
  state,         ///< counts: only whether the cell is free or occupied
  probability,   ///< p(occupied)
  log_odds,      ///< ln(p / (1 - p)); 0: nothing known
  accumulation,  ///< free evidence less obstacle evidence ([Numakura] 4): drawn as log-odds of being free
};

/// How the cells of a method are to be read.
struct CellLayer {
  CellMeaning meaning = CellMeaning::state;
  std::string_view unit = "";
  /// The method's grid, of which an export is a part; none: that of the first export.
  std::optional<GridGeometry> geometry;
};

/// Requires a method of the catalogue. `options`: what differs from its defaults.
[[nodiscard]] CellLayer cell_layer_of(std::string_view method, const OptionMap& options = {});
/// Whether the map has cells of its own; otherwise its states are drawn from its points alone.
[[nodiscard]] bool has_cells(const MapExport& map);
/// The same of a method by name.
[[nodiscard]] bool is_point_method(std::string_view method);
/// The ping on whose arc a point of the map lies; `MapPoint::ping` is the newest that speaks for it.
[[nodiscard]] PingId own_ping(const PointMap& map, const MapPoint& point);
/// p(occupied) of a value; none where nothing is known.
[[nodiscard]] std::optional<double> probability_of(CellMeaning meaning, double value, CellState state);

}  // namespace echoarc::live
