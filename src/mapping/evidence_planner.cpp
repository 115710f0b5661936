// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/evidence_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc {
namespace {

/// Beams are cached by width and certainty; a log whose every reading differs does not fill the memory with them.
constexpr std::size_t max_cached_beams = 256;

kernels::BeamFrame frame_of(const BeamReach& reach, const GridGeometry& geometry) {
  const Arc& rim = reach.rim;
  const Cell apex = geometry.cell_of(rim.centre());
  const Vec2 offset = geometry.centre(apex) - rim.centre();
  const Vec2 axis = unit(rim.axis());
  return {apex.i,
          apex.j,
          float(offset.x),
          float(offset.y),
          float(geometry.cell_m),
          float(axis.x),
          float(axis.y),
          float(reach.echo_m.value_or(0.0))};
}

kernels::SplitShape split_shape(const BeamReach& reach, const GridGeometry& geometry) {
  const double per_cell = 1.0 / geometry.cell_m;
  const double apex_i = (reach.rim.centre().x - geometry.origin.x) * per_cell - 0.5;
  kernels::SplitShape shape{};
  shape.apex_j = (reach.rim.centre().y - geometry.origin.y) * per_cell - 0.5;
  shape.outside = std::ceil(reach.outer_m * per_cell) + 1.0;
  const auto squared_cells = [&](double radius_m) {
    return radius_m > 0.0 ? radius_m * radius_m * per_cell * per_cell : -1.0;
  };
  // Without an echo there is no band: all of the sector is free.
  shape.free_squared = reach.echo_m ? squared_cells(reach.free_to_m) : 4.0 * shape.outside * shape.outside;
  shape.near_squared = squared_cells(reach.near_m);
  shape.i_below = std::int32_t(std::floor(apex_i) - shape.outside) - 2;
  shape.i_above = std::int32_t(std::ceil(apex_i) + shape.outside) + 2;
  shape.apex_from_below = apex_i - shape.i_below;
  shape.apex_from_above = shape.i_above - apex_i;
  return shape;
}

using Column = std::vector<std::int32_t>;

kernels::Runs runs_of(const UpdateGroup& group, const Column& begin, const Column& end) {
  return {group.j_first, begin.data() + group.rows.begin, end.data() + group.rows.begin,
          std::int32_t(group.rows.size())};
}

/// Those of the runs that lie in rows from `first` to `last`.
kernels::Runs within_rows(kernels::Runs runs, std::int32_t first, std::int32_t last) {
  const std::int32_t skipped = std::clamp(first - runs.j_first, 0, runs.count);
  const std::int32_t count = std::clamp(last + 1 - runs.j_first, skipped, runs.count) - skipped;
  return {runs.j_first + skipped, runs.begin + skipped, runs.end + skipped, count};
}

}  // namespace

void UpdatePlan::clear() {
  beams.clear();
  groups.clear();
  rows.count = 0;
  spots.clear();
}

int exact_increment(const WeightedModel& beam, const BeamReach& reach, Vec2 cell_centre) {
  const double distance_m = reach.rim.half_path_m(cell_centre);
  const Angle theta = wrap(bearing(cell_centre - reach.rim.centre()) - reach.rim.axis());
  if (reach.echo_m && distance_m >= reach.free_to_m)
    return to_units(log_odds(beam.model.band_probability(distance_m - *reach.echo_m, theta)));
  if (distance_m < reach.near_m || distance_m >= reach.free_to_m) return 0;
  return to_units(beam.free_weight * log_odds(beam.model.free_probability(theta)));
}

EvidenceGrid::Planner::Planner(const EvidenceGridOptions& options) : options_(options), raster_(geometry_of(options)) {}

std::optional<BeamReach> EvidenceGrid::Planner::reach_of(const Reading& reading) const {
  const auto echo_m = echo_range_m(reading.outcome);
  const double band_m = band_sigmas * options_.range_sigma_m;
  BeamReach reach;
  reach.near_m = reading.range_min_m;
  if (echo_m) {
    reach.echo_m = echo_m;
    reach.free_to_m = *echo_m - band_m;
    reach.outer_m = *echo_m + band_m;
  } else if (is_no_echo(reading.outcome) && options_.no_echo_weight > 0.0) {
    reach.free_to_m = reach.outer_m = std::min(reading.trusted_range_m, reading.range_max_m);
    if (reach.outer_m <= reach.near_m) return std::nullopt;  // trusted nowhere: clears nothing
  } else {
    return std::nullopt;
  }
  Reading at_rim = reading;
  at_rim.outcome = Echo{reach.outer_m};
  const auto rim = arc_of(at_rim);
  // A path that is long enough at the rim may be too short at the echo; a monostatic one cannot.
  if (!rim || (echo_m && !reading.monostatic() && !arc_of(reading))) return std::nullopt;
  reach.rim = *rim;
  return reach;
}

WeightedModel EvidenceGrid::Planner::model_of(const Reading& reading) const {
  const auto echo_m = echo_range_m(reading.outcome);
  const double range_m = echo_m.value_or(std::min(reading.trusted_range_m, reading.range_max_m));
  const double amplitude = options_.range_confidence ? std::max(0.0, 1.0 - range_m / reading.range_max_m) : 1.0;
  return {.model = {.profile = options_.profile,
                    .half_width = 0.5 * reading.beam_width,
                    .angular_sigma = options_.angular_sigma,
                    .range_sigma_m = options_.range_sigma_m,
                    .occupied_peak = 0.5 + amplitude * (options_.occupied_peak - 0.5),
                    .free_floor = 0.5 - amplitude * (0.5 - options_.free_floor)},
          .free_weight = echo_m ? 1.0 : options_.no_echo_weight};
}

const FittedBeam& EvidenceGrid::Planner::beam_of(const Reading& reading) {
  const WeightedModel wanted = model_of(reading);
  for (const FittedBeam& fitted : beams_)
    if (fitted == wanted) return fitted;
  if (beams_.size() >= max_cached_beams && plan_.beams.empty()) beams_.clear();
  beams_.push_back(fit_beam(wanted.model, wanted.free_weight));
  return beams_.back();
}

kernels::Runs EvidenceGrid::Planner::add_rows(const BeamReach& reach) {
  const SectorColumns columns = raster_.columns(reach.rim);
  const kernels::Runs sector{columns.j_first, columns.begin.data(), columns.end.data(),
                             std::int32_t(columns.begin.size())};
  PlannedRows& rows = plan_.rows;
  const std::size_t first = rows.count;
  rows.make_room(columns.begin.size());
  rows.count += columns.begin.size();
  kernels::evidence_kernels().split_rows(
      split_shape(reach, raster_.geometry()), sector,
      {rows.begin.data() + first, rows.free_begin.data() + first, rows.near_begin.data() + first,
       rows.near_end.data() + first, rows.free_end.data() + first, rows.end.data() + first});
  return sector;
}

bool EvidenceGrid::Planner::add_groups(std::int32_t j_first, UpdateGroup::Range rows, Map& grid) {
  for (std::int32_t j = j_first; rows.begin < rows.end;) {
    const auto in_tile = std::min(rows.size(), std::size_t(tile_size - (j & (tile_size - 1))));
    UpdateGroup group{.beam = plan_.beams.size(), .j_first = j, .rows = {rows.begin, rows.begin + in_tile}};
    rows.begin += in_tile;
    j += std::int32_t(in_tile);
    Columns cells;
    kernels::evidence_kernels().bounds(runs_of(group, plan_.rows.begin, plan_.rows.end), &cells.begin, &cells.end);
    if (cells.begin >= cells.end) continue;
    group.tiles = {cells.begin >> tile_shift, ((cells.end - 1) >> tile_shift) + 1};
    for (std::int32_t ti = group.tiles.begin; ti < group.tiles.end; ++ti)
      if (!grid.ensure({ti, group.tile_j()})) return false;
    plan_.groups.push_back(group);
  }
  return true;
}

void EvidenceGrid::Planner::rows_to_spots(std::size_t first_group, const BeamReach& reach, const WeightedModel& beam) {
  const PlannedRows& rows = plan_.rows;
  for (std::size_t g = first_group; g < plan_.groups.size(); ++g) {
    UpdateGroup& group = plan_.groups[g];
    group.spots.begin = plan_.spots.size();
    for (std::size_t k = group.rows.begin; k < group.rows.end; ++k)
      for (Cell cell{rows.begin[k], group.row(k)}; cell.i < rows.end[k]; ++cell.i)
        if (const int increment = exact_increment(beam, reach, raster_.geometry().centre(cell)); increment != 0)
          plan_.spots.push_back({cell, static_cast<std::int16_t>(increment)});
    group.spots.end = plan_.spots.size();
    group.rows = {};
  }
}

bool EvidenceGrid::Planner::add(const Reading& reading, const BeamReach& reach, Map& grid) {
  const GridGeometry& geometry = grid.geometry();
  const Vec2 from_origin = reach.rim.centre() - geometry.origin;
  const double farthest_m = std::max(std::abs(from_origin.x), std::abs(from_origin.y)) + reach.outer_m;
  if (!(farthest_m / geometry.cell_m < GridGeometry::max_index)) return false;

  const std::size_t first_group = plan_.groups.size();
  const std::size_t first_row = plan_.rows.count;
  const kernels::Runs sector = add_rows(reach);
  if (!add_groups(sector.j_first, {first_row, plan_.rows.count}, grid)) {
    plan_.groups.resize(first_group);
    plan_.rows.count = first_row;
    return false;
  }
  const FittedBeam& fitted = beam_of(reading);
  const double near_m = reach.near_m > 0.0 ? std::min(reach.near_m, reach.outer_m) : 0.0;
  const auto near_rows = std::int32_t(std::ceil(near_m / geometry.cell_m));
  plan_.beams.push_back({frame_of(reach, geometry), &fitted, near_rows});
  if (!reach.rim.is_circular() || !fitted.complete()) {
    rows_to_spots(first_group, reach, fitted);
    plan_.rows.count = first_row;
  }
  return true;
}

namespace {

/// Adds the log-odds of free cells in the form they were fitted in.
struct FreeAdder {
  const kernels::TileRow& tiles;
  const kernels::Runs& runs;
  const kernels::BeamFrame& frame;
  kernels::ColumnScratch scratch;
  const kernels::EvidenceKernels& kernels = kernels::evidence_kernels();

  void operator()(std::monostate) const {}
  void operator()(std::int16_t increment) const { kernels.add_constant(tiles, runs, increment); }
  void operator()(const kernels::FixedPolynomial& p) const { kernels.add_fixed(tiles, runs, frame, p, scratch); }
  void operator()(const kernels::Polynomial& p) const { kernels.add_angular(tiles, runs, frame, p); }
};

void apply_rows(const UpdatePlan& plan, const UpdateGroup& group, const kernels::TileRow& tiles,
                kernels::ColumnScratch scratch) {
  const PlannedRows& rows = plan.rows;
  const PlannedBeam& beam = plan.beams[group.beam];
  const auto left_band = runs_of(group, rows.begin, rows.free_begin);
  const auto left_free = runs_of(group, rows.free_begin, rows.near_begin);
  const auto right_free = runs_of(group, rows.near_end, rows.free_end);
  const auto right_band = runs_of(group, rows.free_end, rows.end);

  // Rows without cells that are too near have all of their free cells on the left.
  const std::int32_t apex_j = beam.frame.apex_j;
  const auto beside_near = within_rows(right_free, apex_j - beam.near_rows, apex_j + beam.near_rows);
  for (const kernels::Runs& runs : {left_free, beside_near})
    std::visit(FreeAdder{tiles, runs, beam.frame, scratch}, beam.fitted->free);
  if (beam.frame.range_m > 0.0F)
    kernels::evidence_kernels().add_band(tiles, left_band, right_band, beam.frame, *beam.fitted->band);
}

}  // namespace

void apply_stripe(const UpdatePlan& plan, EvidenceGrid::Map& grid, std::size_t stripe, std::size_t stripes) {
  constexpr int highest = std::numeric_limits<std::int16_t>::max();
  constexpr int lowest = std::numeric_limits<std::int16_t>::min();
  std::vector<std::int16_t*> tiles;
  std::vector<float> scratch;
  for (const UpdateGroup& group : plan.groups) {
    if (static_cast<std::uint32_t>(group.tile_j()) % stripes != stripe) continue;
    tiles.clear();
    for (std::int32_t ti = group.tiles.begin; ti < group.tiles.end; ++ti)
      tiles.push_back(grid.find({ti, group.tile_j()})->data());
    scratch.resize(
        std::max(scratch.size(), std::size_t{2} * tile_size * tiles.size() + kernels::ColumnScratch::margin));
    if (group.rows.size() > 0)
      apply_rows(plan, group, {tiles.data(), group.tiles.begin, std::int32_t(tiles.size())}, {scratch.data()});
    for (std::size_t k = group.spots.begin; k < group.spots.end; ++k) {
      std::int16_t& cell = grid.at(plan.spots[k].cell);
      cell = static_cast<std::int16_t>(std::clamp(cell + plan.spots[k].increment, lowest, highest));
    }
  }
}

}  // namespace echoarc
