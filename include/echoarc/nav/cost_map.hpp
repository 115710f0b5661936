// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/nav/distance_field.hpp"

namespace echoarc::nav {

struct CostMapOptions {
  double cell_m = 0.10;
  double margin_m = 0.05;
  double clearance_m = 0.5;
  double clearance_weight = 3.0;
  bool unknown_passable = false;

  static constexpr auto fields() {
    using O = CostMapOptions;
    return std::tuple{
        field("cell_m", &O::cell_m,
              {.unit = "m", .min = 0.01, .max = 1.0, .doc = "cells of the map that are finer are taken together"}),
        field("margin_m", &O::margin_m,
              {.unit = "m", .min = 0.0, .max = 1.0, .doc = "kept from obstacles beyond the robot's radius"}),
        field("clearance_m", &O::clearance_m,
              {.unit = "m", .min = 0.01, .max = 5.0, .doc = "nearer to an obstacle than this a way costs more"}),
        field("clearance_weight", &O::clearance_weight,
              {.min = 0.0, .max = 100.0, .doc = "how much more at no clearance, in parts of the length"}),
        field("unknown_passable", &O::unknown_passable, {.doc = "whether a way may lead through unknown cells"})};
  }
};

/// A map as a planner needs it: at the planner's cell size, with the clearance of each cell and what a metre of way
/// costs there. Follows a map that changes and grows; what did not change is not computed again.
class CostMap {
 public:
  CostMap(const CostMapOptions& options, double robot_radius_m);

  /// Takes over what changed in `map`. Gives the box of own cells that are new or differ, empty if none.
  CellBox update(const DenseGrid<CellState>& map);
  /// The robot has driven straight from `a` to `b`: whatever the map says, nothing stands under its body there, and its
  /// centre can be there again. Holds until the map is made of cells of another size. Gives what `update` gives.
  CellBox drive_through(Vec2 a, Vec2 b);
  /// Changes whenever a cell or a cost does.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] bool empty() const { return cells_.empty(); }

  /// Occupied if a cell of the map in it is, else free if one is, else unknown; free where the robot's body was.
  [[nodiscard]] const DenseGrid<CellState>& cells() const { return cells_; }
  /// From the centre of each cell to the nearest occupied one's, m, at the most what matters.
  [[nodiscard]] const DenseGrid<float>& clearance_m() const { return clearance_.distances_m(); }
  /// Cost of a metre: 1 + w max(0, 1 - clearance / clearance_m); 0 where the robot cannot be.
  [[nodiscard]] const DenseGrid<float>& cost_per_m() const { return cost_per_m_; }
  [[nodiscard]] const GridGeometry& geometry() const { return cells_.geometry(); }
  [[nodiscard]] double inflation_m() const { return inflation_m_; }
  /// How often all of it was made anew, because the map lies elsewhere.
  [[nodiscard]] std::uint64_t rebuilds() const { return rebuilds_; }

 private:
  struct Lattice {  // where the cells of the source lie among the own ones
    std::int32_t factor = 1;
    Cell offset;  // of the source's cell (0, 0), in source cells from the own grid's corner
  };

  [[nodiscard]] bool fits(const DenseGrid<CellState>& map) const;
  void rebuild(const DenseGrid<CellState>& map);
  [[nodiscard]] CellBox changed_cells(const DenseGrid<CellState>& map) const;
  CellBox take_over(const DenseGrid<CellState>& map, const CellBox& own);
  [[nodiscard]] CellState merged(const DenseGrid<CellState>& map, Cell own) const;
  void price(const CellBox& box);
  CellBox mark_body(Vec2 place);
  void keep_traces(const GridGeometry& own);

  enum Trace : std::uint8_t { none, body, centre };  // what of the robot was in a cell

  CostMapOptions options_;
  double body_m_;
  double inflation_m_;
  Lattice lattice_;
  DenseGrid<CellState> source_;  // as it was taken over last
  DenseGrid<CellState> cells_;
  CappedDistanceField clearance_;
  DenseGrid<float> cost_per_m_;
  DenseGrid<std::uint8_t> traces_;
  std::uint64_t rebuilds_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace echoarc::nav
