// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/evidence_planner.hpp"

#include <algorithm>
#include <cmath>

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

std::uint32_t count_of(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

/// Columns of a row whose centres lie inside a circle about the apex, `half_squared_m2` the squared half chord.
Columns chord(double apex_i, double half_squared_m2, double cell_m) {
  if (half_squared_m2 <= 0.0) return {};
  const double half = std::sqrt(half_squared_m2) / cell_m;
  return {std::int32_t(std::ceil(apex_i - half)), std::int32_t(std::floor(apex_i + half)) + 1};
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

bool make_room(std::span<const RowSpan> spans, EvidenceGrid::Map& grid) {
  while (!spans.empty()) {
    const auto rows = rows_of_one_tile(spans);
    const Columns columns = tile_columns(rows);
    for (std::int32_t ti = columns.begin; ti < columns.end; ++ti)
      if (!grid.ensure({ti, rows[0].j >> tile_shift})) return false;
    spans = spans.subspan(rows.size());
  }
  return true;
}

}  // namespace

void UpdatePlan::clear() {
  beams.clear();
  groups.clear();
  free.clear();
  band.clear();
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
  BeamReach reach{.near_m = reading.range_min_m};
  if (echo_m) {
    reach.echo_m = echo_m;
    reach.free_to_m = *echo_m - band_m;
    reach.outer_m = *echo_m + band_m;
  } else if (is_no_echo(reading.outcome) && options_.no_echo_weight > 0.0) {
    reach.free_to_m = reach.outer_m = std::min(reading.trusted_range_m, reading.range_max_m);
  } else {
    return std::nullopt;
  }
  Reading at_rim = reading;
  at_rim.outcome = Echo{reach.outer_m};
  const auto rim = arc_of(at_rim);
  if (!rim || (echo_m && !arc_of(reading))) return std::nullopt;
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

void EvidenceGrid::Planner::add_runs(std::int32_t j, std::int32_t begin, std::int32_t end, bool band,
                                     const BeamReach& reach, const FittedBeam& fitted) {
  if (begin >= end) return;
  const bool fits = reach.rim.is_circular() && (band ? fitted.band.has_value() : fitted.free.has_value());
  if (fits) {
    (band ? plan_.band : plan_.free).push_back({j, begin, end});
    return;
  }
  for (std::int32_t i = begin; i < end; ++i)
    if (const int increment = exact_increment(fitted, reach, raster_.geometry().centre({i, j})); increment != 0)
      plan_.spots.push_back({{i, j}, static_cast<std::int16_t>(increment)});
}

/// A row of the sector from left to right: band, free, too near, free, band; each part may be empty.
void EvidenceGrid::Planner::split_row(const RowSpan& span, const BeamReach& reach, const FittedBeam& fitted) {
  const double cell_m = raster_.geometry().cell_m;
  const double apex_i = (reach.rim.centre().x - raster_.geometry().origin.x) / cell_m - 0.5;
  const double dy = raster_.geometry().centre({0, span.j}).y - reach.rim.centre().y;
  if (!reach.rim.is_circular()) return add_runs(span.j, span.i_begin, span.i_end, false, reach, fitted);

  const auto clip = [&](std::int32_t i) { return std::clamp(i, span.i_begin, span.i_end); };
  Columns free{span.i_end, span.i_end};
  if (!reach.echo_m)
    free = {span.i_begin, span.i_end};
  else if (reach.free_to_m > 0.0) {
    const Columns inside = chord(apex_i, reach.free_to_m * reach.free_to_m - dy * dy, cell_m);
    if (inside.begin < inside.end) free = {clip(inside.begin), clip(inside.end)};
  }
  const Columns close = chord(apex_i, reach.near_m * reach.near_m - dy * dy, cell_m);
  const std::int32_t near_begin = close.begin < close.end ? std::clamp(close.begin, free.begin, free.end) : free.end;
  const std::int32_t near_end = close.begin < close.end ? std::clamp(close.end, free.begin, free.end) : free.end;
  add_runs(span.j, span.i_begin, free.begin, true, reach, fitted);
  add_runs(span.j, free.begin, near_begin, false, reach, fitted);
  add_runs(span.j, near_end, free.end, false, reach, fitted);
  add_runs(span.j, free.end, span.i_end, true, reach, fitted);
}

bool EvidenceGrid::Planner::add(const Reading& reading, const BeamReach& reach, Map& grid) {
  const GridGeometry& geometry = grid.geometry();
  const Vec2 from_origin = reach.rim.centre() - geometry.origin;
  const double farthest_m = std::max(std::abs(from_origin.x), std::abs(from_origin.y)) + reach.outer_m;
  if (!(farthest_m / geometry.cell_m < GridGeometry::max_index)) return false;

  const auto spans = raster_.spans(reach.rim);
  if (!make_room(spans, grid)) return false;

  const FittedBeam& fitted = beam_of(reading);
  const auto beam = count_of(plan_.beams);
  plan_.beams.push_back({frame_of(reach.rim, geometry), &fitted, float(reach.echo_m.value_or(0.0))});
  for (auto rest = spans; !rest.empty();) {
    const auto rows = rows_of_one_tile(rest);
    rest = rest.subspan(rows.size());
    UpdateGroup group{.beam = beam, .tile_j = rows.front().j >> tile_shift, .tiles = tile_columns(rows)};
    group.free.begin = count_of(plan_.free);
    group.band.begin = count_of(plan_.band);
    group.spots.begin = count_of(plan_.spots);
    for (const RowSpan& row : rows) split_row(row, reach, fitted);
    group.free.end = count_of(plan_.free);
    group.band.end = count_of(plan_.band);
    group.spots.end = count_of(plan_.spots);
    plan_.groups.push_back(group);
  }
  return true;
}

void apply_stripe(const UpdatePlan& plan, EvidenceGrid::Map& grid, std::size_t stripe, std::size_t stripes) {
  const kernels::EvidenceKernels& kernels = kernels::evidence_kernels();
  std::vector<std::int16_t*> tiles;
  for (const UpdateGroup& group : plan.groups) {
    if (static_cast<std::uint32_t>(group.tile_j) % stripes != stripe) continue;
    tiles.clear();
    for (std::int32_t ti = group.tiles.begin; ti < group.tiles.end; ++ti) {
      auto* tile = grid.find({ti, group.tile_j});
      tiles.push_back(tile != nullptr ? tile->data() : nullptr);
    }
    const kernels::TileRow row{tiles.data(), group.tiles.begin};
    const PlannedBeam& beam = plan.beams[group.beam];
    if (const std::size_t count = group.free.end - group.free.begin; count > 0) {
      const kernels::Polynomial& free = *beam.fitted->free;
      const kernels::Run* runs = plan.free.data() + group.free.begin;
      if (free.terms == 1)
        kernels.add_constant(row, runs, count, static_cast<std::int16_t>(std::lrint(free.c[0])));
      else
        kernels.add_angular(row, runs, count, beam.frame, free);
    }
    if (const std::size_t count = group.band.end - group.band.begin; count > 0) {
      kernels::BandModel band = *beam.fitted->band;
      band.range_m = beam.range_m;
      kernels.add_band(row, plan.band.data() + group.band.begin, count, beam.frame, band);
    }
    for (std::uint32_t k = group.spots.begin; k < group.spots.end; ++k) {
      std::int16_t& cell = grid.at(plan.spots[k].cell);
      cell = static_cast<std::int16_t>(std::clamp(cell + plan.spots[k].increment, -32767, 32767));
    }
  }
}

}  // namespace echoarc
