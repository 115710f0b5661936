// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/mapping/evidence_grid.hpp"
#include "echoarc/maps/sector_raster.hpp"
#include "mapping/evidence_kernels.hpp"
#include "mapping/fitted_beam.hpp"

namespace echoarc {

/// A single cell and its change, for cells that the kernels do not cover.
struct SpotUpdate {
  Cell cell;
  std::int16_t increment = 0;
};

/// Columns begin <= i < end, of cells or of tiles.
struct Columns {
  std::int32_t begin = 0;
  std::int32_t end = 0;
};

/// What one reading does to one row of tiles: ranges into the plan's lists.
struct UpdateGroup {
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
    [[nodiscard]] std::size_t size() const { return end - begin; }
  };
  std::size_t beam = 0;
  std::int32_t j_first = 0;
  Columns tiles;
  Range rows;
  Range spots;
  /// The row of cells that is planned row k.
  [[nodiscard]] std::int32_t row(std::size_t k) const { return j_first + std::int32_t(k - rows.begin); }
  [[nodiscard]] std::int32_t tile_j() const { return j_first >> tile_shift; }
};

/// Beam of a planned reading: where it stands and what it adds.
struct PlannedBeam {
  kernels::BeamFrame frame;
  const FittedBeam* fitted = nullptr;
  std::int32_t near_rows = 0;  ///< how many rows from the apex's a cell may be too near
};

/// Rows of planned sectors, as parallel arrays. From left to right a row is band, free, too near, free, band; each
/// part may be empty. The arrays only grow: what lies beyond `count` is left from before.
struct PlannedRows {
  std::vector<std::int32_t> begin, free_begin, near_begin, near_end, free_end, end;
  std::size_t count = 0;

  void make_room(std::size_t more) {
    if (count + more <= begin.size()) return;
    for (auto* column : {&begin, &free_begin, &near_begin, &near_end, &free_end, &end})
      column->resize(2 * (count + more));
  }
};

/// Changes of some readings, in order, worked out but not yet made. Rows of tiles are independent of each other, so
/// that threads can share a plan by rows and every cell still sees its changes in the order of the readings.
struct UpdatePlan {
  std::vector<PlannedBeam> beams;
  std::vector<UpdateGroup> groups;
  PlannedRows rows;
  std::vector<SpotUpdate> spots;

  void clear();
  [[nodiscard]] std::size_t size() const { return rows.count + spots.size(); }
};

/// Where a reading says something: out to `outer_m`, free to `free_to_m`, a band beyond it if there was an echo.
struct BeamReach {
  Arc rim;  ///< the reading's arc at `outer_m`
  double near_m = 0.0;
  double free_to_m = 0.0;
  std::optional<double> echo_m;
  double outer_m = 0.0;
};

/// Works out which runs of cells a reading changes and makes room for them in the grid.
class EvidenceGrid::Planner {
 public:
  explicit Planner(const EvidenceGridOptions& options);

  /// The reading's geometry; none when it says nothing to the grid (`no_information`) or has no arc.
  [[nodiscard]] std::optional<BeamReach> reach_of(const Reading& reading) const;
  /// Adds the reading to the plan. False when the grid cannot hold its cells; the plan is then unchanged.
  [[nodiscard]] bool add(const Reading& reading, const BeamReach& reach, Map& grid);
  [[nodiscard]] UpdatePlan& plan() { return plan_; }
  [[nodiscard]] WeightedModel model_of(const Reading& reading) const;

 private:
  /// The model of a reading, fitted.
  [[nodiscard]] const FittedBeam& beam_of(const Reading& reading);
  /// Plans the rows of the sector under the reading's rim; returns which they are.
  [[nodiscard]] kernels::Runs add_rows(const BeamReach& reach);
  /// Groups the latest rows by rows of tiles and makes those tiles exist; false when they cannot.
  [[nodiscard]] bool add_groups(std::int32_t j_first, UpdateGroup::Range rows, Map& grid);
  /// Makes single cells of the rows of the latest groups, which no kernel covers.
  void rows_to_spots(std::size_t first_group, const BeamReach& reach, const WeightedModel& beam);

  EvidenceGridOptions options_;
  SectorRaster raster_;
  std::deque<FittedBeam> beams_;  // references stay valid while it grows
  UpdatePlan plan_;
};

/// The change of one cell as the model has it, in units; 0 where the reading says nothing.
[[nodiscard]] int exact_increment(const WeightedModel& beam, const BeamReach& reach, Vec2 cell_centre);

/// Makes the changes of the plan in every row of tiles with `tile_j() mod stripes == stripe`.
void apply_stripe(const UpdatePlan& plan, EvidenceGrid::Map& grid, std::size_t stripe, std::size_t stripes);

}  // namespace echoarc
