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

kernels::BeamFrame frame_of(const Arc& rim, const GridGeometry& geometry) {
  const Cell apex = geometry.cell_of(rim.centre());
  const Vec2 offset = geometry.centre(apex) - rim.centre();
  const Vec2 axis = unit(rim.axis());
  return {apex.i, apex.j, float(offset.x), float(offset.y), float(geometry.cell_m), float(axis.x), float(axis.y)};
}

/// The first rows that share a row of tiles.
std::span<const RowSpan> rows_of_one_tile(std::span<const RowSpan> rows) {
  std::size_t count = 1;
  while (count < rows.size() && rows[count].j >> tile_shift == rows[0].j >> tile_shift) ++count;
  return rows.first(count);
}

/// The tile columns that the rows meet.
Columns tile_columns(std::span<const RowSpan> rows) {
  Columns cells{rows[0].i_begin, rows[0].i_end};
  for (const RowSpan& row : rows) {
    cells.begin = std::min(cells.begin, row.i_begin);
    cells.end = std::max(cells.end, row.i_end);
  }
  return {cells.begin >> tile_shift, ((cells.end - 1) >> tile_shift) + 1};
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

kernels::Runs runs_of(const PlannedRows& rows, UpdateGroup::Range range, const std::vector<std::int32_t>& begin,
                      const std::vector<std::int32_t>& end) {
  return {rows.j.data() + range.begin, begin.data() + range.begin, end.data() + range.begin, range.size()};
}

}  // namespace

void UpdatePlan::clear() {
  beams.clear();
  groups.clear();
  rows.count = 0;
  spots.clear();
}

int exact_increment(const FittedBeam& beam, const BeamReach& reach, Vec2 cell_centre) {
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

const FittedBeam& EvidenceGrid::Planner::beam_of(const Reading& reading) {
  const auto echo_m = echo_range_m(reading.outcome);
  const double range_m = echo_m.value_or(std::min(reading.trusted_range_m, reading.range_max_m));
  const double amplitude = options_.range_confidence ? std::max(0.0, 1.0 - range_m / reading.range_max_m) : 1.0;
  const double free_weight = echo_m ? 1.0 : options_.no_echo_weight;
  const Angle half_width = 0.5 * reading.beam_width;
  for (const CachedBeam& cached : beams_)
    if (cached.half_width == half_width && cached.amplitude == amplitude && cached.free_weight == free_weight)
      return cached.fitted;
  const InverseSonarModel model{.profile = options_.profile,
                                .half_width = half_width,
                                .angular_sigma = options_.angular_sigma,
                                .range_sigma_m = options_.range_sigma_m,
                                .occupied_peak = 0.5 + amplitude * (options_.occupied_peak - 0.5),
                                .free_floor = 0.5 - amplitude * (0.5 - options_.free_floor)};
  if (beams_.size() >= max_cached_beams && plan_.beams.empty()) beams_.clear();
  beams_.push_back({half_width, amplitude, free_weight, fit_beam(model, free_weight)});
  return beams_.back().fitted;
}

bool EvidenceGrid::Planner::add_groups(std::span<const RowSpan> spans, Map& grid) {
  const std::size_t groups_before = plan_.groups.size();
  std::size_t row = plan_.rows.count;
  while (!spans.empty()) {
    const auto rows = rows_of_one_tile(spans);
    spans = spans.subspan(rows.size());
    const UpdateGroup group{.beam = plan_.beams.size(),
                            .tile_j = rows.front().j >> tile_shift,
                            .tiles = tile_columns(rows),
                            .rows = {row, row + rows.size()},
                            .spots = {}};
    row += rows.size();
    for (std::int32_t ti = group.tiles.begin; ti < group.tiles.end; ++ti)
      if (!grid.ensure({ti, group.tile_j})) {
        plan_.groups.resize(groups_before);
        return false;
      }
    plan_.groups.push_back(group);
  }
  return true;
}

void EvidenceGrid::Planner::add_rows(std::span<const RowSpan> spans, const BeamReach& reach) {
  PlannedRows& rows = plan_.rows;
  const std::size_t first = rows.count;
  rows.make_room(spans.size());
  rows.count += spans.size();
  for (std::size_t k = 0; k < spans.size(); ++k) {
    rows.j[first + k] = spans[k].j;
    rows.begin[first + k] = spans[k].i_begin;
    rows.end[first + k] = spans[k].i_end;
  }
  kernels::evidence_kernels().split_rows(split_shape(reach, raster_.geometry()),
                                         runs_of(rows, {first, rows.count}, rows.begin, rows.end),
                                         {rows.free_begin.data() + first, rows.near_begin.data() + first,
                                          rows.near_end.data() + first, rows.free_end.data() + first});
}

void EvidenceGrid::Planner::add_spots(std::size_t first_group, std::span<const RowSpan> spans, const BeamReach& reach,
                                      const FittedBeam& beam) {
  for (std::size_t g = first_group; g < plan_.groups.size(); ++g) {
    UpdateGroup& group = plan_.groups[g];
    group.spots.begin = plan_.spots.size();
    for (const RowSpan& span : spans.first(group.rows.size()))
      for (std::int32_t i = span.i_begin; i < span.i_end; ++i)
        if (const int increment = exact_increment(beam, reach, raster_.geometry().centre({i, span.j})); increment != 0)
          plan_.spots.push_back({{i, span.j}, static_cast<std::int16_t>(increment)});
    group.spots.end = plan_.spots.size();
    spans = spans.subspan(group.rows.size());
    group.rows = {};
  }
}

bool EvidenceGrid::Planner::add(const Reading& reading, const BeamReach& reach, Map& grid) {
  const GridGeometry& geometry = grid.geometry();
  const Vec2 from_origin = reach.rim.centre() - geometry.origin;
  const double farthest_m = std::max(std::abs(from_origin.x), std::abs(from_origin.y)) + reach.outer_m;
  if (!(farthest_m / geometry.cell_m < GridGeometry::max_index)) return false;

  const auto spans = raster_.spans(reach.rim);
  const std::size_t first_group = plan_.groups.size();
  if (!add_groups(spans, grid)) return false;
  const FittedBeam& fitted = beam_of(reading);
  plan_.beams.push_back({frame_of(reach.rim, geometry), &fitted, float(reach.echo_m.value_or(0.0))});
  if (reach.rim.is_circular() && fitted.free && fitted.band)
    add_rows(spans, reach);
  else
    add_spots(first_group, spans, reach, fitted);
  return true;
}

namespace {

void apply_rows(const UpdatePlan& plan, const UpdateGroup& group, const kernels::TileRow& tiles) {
  const kernels::EvidenceKernels& kernels = kernels::evidence_kernels();
  const PlannedRows& rows = plan.rows;
  const PlannedBeam& beam = plan.beams[group.beam];
  const auto left_band = runs_of(rows, group.rows, rows.begin, rows.free_begin);
  const auto left_free = runs_of(rows, group.rows, rows.free_begin, rows.near_begin);
  const auto right_free = runs_of(rows, group.rows, rows.near_end, rows.free_end);
  const auto right_band = runs_of(rows, group.rows, rows.free_end, rows.end);

  const kernels::Polynomial& free = *beam.fitted->free;
  for (const kernels::Runs& runs : {left_free, right_free}) {
    if (free.terms == 1)
      kernels.add_constant(tiles, runs, static_cast<std::int16_t>(std::lrint(free.c[0])));
    else
      kernels.add_angular(tiles, runs, beam.frame, free);
  }
  kernels::BandModel band = *beam.fitted->band;
  band.range_m = beam.range_m;
  for (const kernels::Runs& runs : {left_band, right_band}) kernels.add_band(tiles, runs, beam.frame, band);
}

}  // namespace

void apply_stripe(const UpdatePlan& plan, EvidenceGrid::Map& grid, std::size_t stripe, std::size_t stripes) {
  constexpr int highest = std::numeric_limits<std::int16_t>::max();
  constexpr int lowest = std::numeric_limits<std::int16_t>::min();
  std::vector<std::int16_t*> tiles;
  for (const UpdateGroup& group : plan.groups) {
    if (static_cast<std::uint32_t>(group.tile_j) % stripes != stripe) continue;
    tiles.clear();
    for (std::int32_t ti = group.tiles.begin; ti < group.tiles.end; ++ti)
      tiles.push_back(grid.find({ti, group.tile_j})->data());
    if (group.rows.size() > 0) apply_rows(plan, group, {tiles.data(), group.tiles.begin});
    for (std::size_t k = group.spots.begin; k < group.spots.end; ++k) {
      std::int16_t& cell = grid.at(plan.spots[k].cell);
      cell = static_cast<std::int16_t>(std::clamp(cell + plan.spots[k].increment, lowest, highest));
    }
  }
}

}  // namespace echoarc
