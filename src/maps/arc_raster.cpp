// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/arc_raster.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "maps/arc_branches.hpp"
#include "maps/raster_kernels.hpp"

namespace echoarc {
namespace {

/// An arc of at least this radius that leaves a cell and returns has bulged over one of its sides by less than 1/64
/// cell, so it has met one neighbour in between; tighter arcs may meet more.
constexpr double tight_radius_cells = 8.0;

/// The cells of a tight arc in its order, each once: there are few, and all of them are compared.
class DistinctCells {
 public:
  DistinctCells(std::vector<Cell>& cells, std::size_t room) : cells_(cells) {
    cells_.clear();
    cells_.reserve(room);
  }
  void add(Cell c) {
    if (std::ranges::find(cells_, c) == cells_.end()) cells_.push_back(c);
  }
  [[nodiscard]] std::span<const Cell> get() const { return cells_; }

 private:
  std::vector<Cell>& cells_;
};

/// n = max(2, ceil(arc length bound / (cell/2)) + 1) samples, both ends included.
std::size_t sample_count(const Arc& arc, double cell_m) {
  const double widest_radius_m = arc.range_m() * arc.range_m() / arc.semi_minor_m();
  const double steps = std::ceil((arc.t_end() - arc.t_begin()).rad() * widest_radius_m / (0.5 * cell_m));
  return std::max<std::size_t>(2, std::size_t(steps) + 1);
}

kernels::ArcShape shape_of(const Arc& arc, const GridGeometry& geometry, Angle step) {
  const double per_cell = 1.0 / geometry.cell_m;
  kernels::ArcShape shape{};
  shape.circular = arc.is_circular();
  shape.semi_major = arc.range_m() * per_cell;
  shape.semi_minor = arc.semi_minor_m() * per_cell;
  shape.focal_x = arc.focal_axis().x;
  shape.focal_y = arc.focal_axis().y;

  // Turning block by block is exact to 1e-14 over 10^4 samples and needs two sines instead of one per sample.
  const Vec2 first = unit(arc.axis() + arc.t_begin());
  const Vec2 turn = unit(step);
  Vec2 lane{1.0, 0.0};
  for (std::size_t l = 0; l < kernels::arc_lanes; ++l) {
    shape.lane_x[l] = lane.x;
    shape.lane_y[l] = lane.y;
    lane = {lane.x * turn.x - lane.y * turn.y, lane.x * turn.y + lane.y * turn.x};
  }
  shape.first_x = first.x;
  shape.first_y = first.y;
  shape.turn_x = lane.x;
  shape.turn_y = lane.y;

  const Vec2 centre = (arc.centre() - geometry.origin) * per_cell;
  const double i_base = std::floor(centre.x - shape.semi_major) - 1.0;
  const double j_base = std::floor(centre.y - shape.semi_major) - 1.0;
  shape.centre_x = centre.x - i_base;
  shape.centre_y = centre.y - j_base;
  shape.i_base = std::int32_t(i_base);
  shape.j_base = std::int32_t(j_base);
  return shape;
}

/// Packed indices that no cell has: both are beyond `GridGeometry::max_index`.
constexpr std::uint64_t no_cell = 0x8000000080000000U;

Cell unpacked(std::uint64_t cell) {
  return {static_cast<std::int32_t>(cell & 0xffffffffU), static_cast<std::int32_t>(cell >> 32)};
}

/// The distinct cells of the samples of a wide arc: `samples` and `changes` as the kernel leaves them. Only samples
/// that enter another cell are visited, and returns to the cell before the last are dropped without a branch.
std::span<const Cell> distinct_cells(std::span<const std::uint64_t> samples, const std::uint64_t* changes,
                                     std::vector<Cell>& cells) {
  if (cells.size() < samples.size()) cells.resize(samples.size());
  std::size_t size = 0;
  std::uint64_t last = no_cell;
  std::uint64_t before_last = no_cell;
  for (std::size_t k = 0; k < samples.size(); k += 64) {
    const std::size_t left = samples.size() - k;
    std::uint64_t entered = changes[k / 64] & (left < 64 ? (std::uint64_t{1} << left) - 1 : ~std::uint64_t{0});
    for (; entered != 0; entered &= entered - 1) {
      const std::uint64_t cell = samples[k + std::size_t(std::countr_zero(entered))];
      cells[size] = unpacked(cell);
      size += cell != before_last ? 1 : 0;
      before_last = last;
      last = cell;
    }
  }
  return std::span<const Cell>(cells).first(size);
}

std::span<const Cell> sampled_cells(const Arc& arc, const GridGeometry& geometry, std::vector<std::uint64_t>& scratch,
                                    std::vector<Cell>& cells) {
  const std::size_t count = sample_count(arc, geometry.cell_m);
  const std::size_t padded = (count + kernels::arc_lanes - 1) / kernels::arc_lanes * kernels::arc_lanes;
  const std::size_t words = padded / 64 + 1;
  if (scratch.size() < padded + 1 + words) scratch.resize(padded + 1 + words);
  std::uint64_t* const changes = scratch.data() + padded + 1;
  const kernels::ArcShape shape = shape_of(arc, geometry, (arc.t_end() - arc.t_begin()) / double(count - 1));
  kernels::raster_kernels().arc_samples(shape, padded, scratch.data(), changes);
  const auto samples = std::span<const std::uint64_t>(scratch).subspan(1, count);
  if (shape.semi_major >= tight_radius_cells) return distinct_cells(samples, changes, cells);
  DistinctCells distinct(cells, count);
  for (const std::uint64_t cell : samples) distinct.add(unpacked(cell));
  return distinct.get();
}

/// Collects the parameters at which the arc meets the lines {P : P.n = first, first + spacing, ... <= last}.
///
/// With P(e) = M + A cos e f + B sin e g the condition reads p cos e + s sin e = line - M.n, p = A f.n, s = B g.n,
/// hence e = atan2(s, p) +- acos((line - M.n) / hypot(p, s)).
void line_crossings(const Arc& arc, Vec2 n, double first, double spacing, double last, std::vector<double>& ts) {
  const Vec2 f = arc.focal_axis();
  const Vec2 g = perpendicular(f);
  const double p = arc.range_m() * dot(f, n);
  const double s = arc.semi_minor_m() * dot(g, n);
  for (int k = 0; first + k * spacing <= last; ++k) {
    const double ratio = (first + k * spacing - dot(arc.centre(), n)) / std::hypot(p, s);
    if (std::abs(ratio) > 1.0) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double e = std::atan2(s, p) + sign * std::acos(ratio);
      const Vec2 offset = arc.range_m() * std::cos(e) * f + arc.semi_minor_m() * std::sin(e) * g;
      const Angle t = wrap(bearing(offset) - arc.axis());
      if (t > arc.t_begin() && t < arc.t_end()) ts.push_back(t.rad());
    }
  }
}

/// All crossings with grid lines, sorted; the middle between two lies in the cell between them.
std::span<const Cell> exact_cells(const Arc& arc, const GridGeometry& geometry, std::vector<double>& ts,
                                  std::vector<Cell>& cells) {
  ts.assign({arc.t_begin().rad(), arc.t_end().rad()});
  const Box box = arc.bounds();
  const Vec2 first = geometry.corner(geometry.cell_of(box.low));
  line_crossings(arc, {1, 0}, first.x, geometry.cell_m, box.high.x, ts);
  line_crossings(arc, {0, 1}, first.y, geometry.cell_m, box.high.y, ts);
  std::ranges::sort(ts);
  DistinctCells distinct(cells, ts.size());
  for (std::size_t k = 1; k < ts.size(); ++k)
    if (ts[k] - ts[k - 1] > 1e-12) distinct.add(geometry.cell_of(arc.point_at(radians(0.5 * (ts[k - 1] + ts[k])))));
  return distinct.get();
}

/// The cells of one row of a branch, in the order in which the arc first enters them: from column `from` on, and where
/// the row holds the branch's bulge to one side, first there and then back.
void append_row(std::int32_t j, std::int32_t begin, std::int32_t end, std::int32_t from, std::int32_t to,
                std::vector<Cell>& cells) {
  const auto ascend = [&](std::int32_t i, std::int32_t stop) {
    for (; i < stop; ++i) cells.push_back({i, j});
  };
  const auto descend = [&](std::int32_t i, std::int32_t stop) {
    for (; i >= stop; --i) cells.push_back({i, j});
  };
  const std::int32_t entry = std::clamp(from, begin, std::max(begin, end - 1));
  if (end - 1 > std::max(from, to) || to > from) {
    ascend(entry, end);
    descend(entry - 1, begin);
  } else {
    descend(std::min(entry, end - 1), begin);
    ascend(entry + 1, end);
  }
}

}  // namespace

std::span<const ArcBranch> ArcRaster::branches(const Arc& arc) {
  const double tightest_radius_m = arc.semi_minor_m() * arc.semi_minor_m() / arc.range_m();
  if (sampling_ == ArcSampling::sampled || tightest_radius_m < tight_radius_cells * geometry_.cell_m) return {};
  return find_branches(arc, geometry_, columns_, branches_);
}

std::span<const Cell> ArcRaster::cells_of_branches(std::span<const ArcBranch> branches) {
  cells_.clear();
  for (const ArcBranch& branch : branches) {
    const std::size_t rows = branch.i_begin.size();
    for (std::size_t n = 0; n < rows; ++n) {
      const std::size_t k = branch.rising ? n : rows - 1 - n;
      const std::int32_t from = branch.crossing[branch.rising ? k : k + 1];
      const std::int32_t to = branch.crossing[branch.rising ? k + 1 : k];
      append_row(branch.j_first + std::int32_t(k), branch.i_begin[k], branch.i_end[k], from, to, cells_);
    }
  }
  return cells_;
}

std::span<const Cell> ArcRaster::cells(const Arc& arc) {
  if (sampling_ == ArcSampling::sampled) return sampled_cells(arc, geometry_, samples_, cells_);
  const std::span<const ArcBranch> wide = branches(arc);
  return wide.empty() ? exact_cells(arc, geometry_, crossings_, cells_) : cells_of_branches(wide);
}

}  // namespace echoarc
