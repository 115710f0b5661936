// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/arc_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace echoarc {
namespace {

/// Sample positions are computed this many at a time, each block from the last by one rotation.
constexpr std::size_t block = 8;

/// An arc of at least this radius that leaves a cell and returns has bulged over one of its sides by less than 1/64
/// cell, so it has met one neighbour in between; tighter arcs may meet more.
constexpr double tight_radius_cells = 8.0;

/// Cells in the order of the arc, each once. For a wide arc the two cells before are all that a new one can repeat; a
/// tight arc has few cells, and all of them are compared.
class DistinctCells {
 public:
  DistinctCells(std::vector<Cell>& cells, std::size_t room, bool tight) : cells_(cells), tight_(tight) {
    cells_.resize(room + sentinels);
    cells_[0] = cells_[1] = {std::numeric_limits<std::int32_t>::min(), 0};  // no cell has this index
  }
  void add(Cell c) {
    cells_[size_] = c;
    bool seen = (c == cells_[size_ - 1]) | (c == cells_[size_ - 2]);
    if (tight_) seen = std::ranges::find(get(), c) != get().end();
    size_ += seen ? 0 : 1;
  }
  [[nodiscard]] std::span<const Cell> get() const {
    return std::span<const Cell>(cells_).subspan(sentinels, size_ - sentinels);
  }

 private:
  static constexpr std::size_t sentinels = 2;
  std::vector<Cell>& cells_;
  std::size_t size_ = sentinels;
  bool tight_;
};

/// n = max(2, ceil(arc length bound / (cell/2)) + 1) samples, both ends included.
std::size_t sample_count(const Arc& arc, double cell_m) {
  const double widest_radius_m = arc.range_m() * arc.range_m() / arc.semi_minor_m();
  const double steps = std::ceil((arc.t_end() - arc.t_begin()).rad() * widest_radius_m / (0.5 * cell_m));
  return std::max<std::size_t>(2, std::size_t(steps) + 1);
}

/// cos and sin of `count` equally spaced angles, `count` a multiple of `block`. Rotating block by block is exact to
/// 1e-14 over 10^4 samples and needs two calls of the library's sine instead of one per sample.
void equally_spaced_directions(Angle first, Angle step, std::size_t count, double* xs, double* ys) {
  std::array<double, block> lane_x{};
  std::array<double, block> lane_y{};
  const Vec2 turn = unit(step);
  Vec2 lane{1.0, 0.0};
  for (std::size_t l = 0; l < block; ++l) {
    lane_x[l] = lane.x;
    lane_y[l] = lane.y;
    lane = {lane.x * turn.x - lane.y * turn.y, lane.x * turn.y + lane.y * turn.x};
  }
  const Vec2 block_turn = lane;
  Vec2 base = unit(first);
  for (std::size_t k = 0; k < count; k += block) {
    for (std::size_t l = 0; l < block; ++l) {
      xs[k + l] = base.x * lane_x[l] - base.y * lane_y[l];
      ys[k + l] = base.x * lane_y[l] + base.y * lane_x[l];
    }
    base = {base.x * block_turn.x - base.y * block_turn.y, base.x * block_turn.y + base.y * block_turn.x};
  }
}

/// Unit bearings from the centre become offsets on the ellipse, in metres.
void stretch_to_ellipse(const Arc& arc, std::size_t count, double* xs, double* ys) {
  const double a = arc.range_m();
  const double b = arc.semi_minor_m();
  const Vec2 f = arc.focal_axis();
  for (std::size_t k = 0; k < count; ++k) {
    const double along = b * (xs[k] * f.x + ys[k] * f.y);
    const double across = a * (f.x * ys[k] - f.y * xs[k]);
    const double radius = a * b / std::sqrt(along * along + across * across);
    xs[k] *= radius;
    ys[k] *= radius;
  }
}

std::span<const Cell> sampled_cells(const Arc& arc, const GridGeometry& geometry, std::vector<double>& scratch,
                                    std::vector<Cell>& cells) {
  const std::size_t count = sample_count(arc, geometry.cell_m);
  const std::size_t padded = (count + block - 1) / block * block;
  scratch.resize(2 * padded);
  double* const xs = scratch.data();
  double* const ys = xs + padded;
  const Angle step = (arc.t_end() - arc.t_begin()) / double(count - 1);
  equally_spaced_directions(arc.axis() + arc.t_begin(), step, padded, xs, ys);
  if (!arc.is_circular()) stretch_to_ellipse(arc, count, xs, ys);

  // Counted from a cell below and left of the arc all coordinates are positive, and truncation is floor.
  const double per_cell = 1.0 / geometry.cell_m;
  const double radius_cells = arc.range_m() * per_cell;
  const double scale = arc.is_circular() ? radius_cells : per_cell;
  const double x_cells = (arc.centre().x - geometry.origin.x) * per_cell;
  const double y_cells = (arc.centre().y - geometry.origin.y) * per_cell;
  const double i_base = std::floor(x_cells - radius_cells) - 1.0;
  const double j_base = std::floor(y_cells - radius_cells) - 1.0;
  const double x_offset = x_cells - i_base;
  const double y_offset = y_cells - j_base;
  DistinctCells distinct(cells, count, radius_cells < tight_radius_cells);
  for (std::size_t k = 0; k < count; ++k)
    distinct.add({std::int32_t(i_base) + std::int32_t(x_offset + scale * xs[k]),
                  std::int32_t(j_base) + std::int32_t(y_offset + scale * ys[k])});
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

std::span<const Cell> exact_cells(const Arc& arc, const GridGeometry& geometry, std::vector<double>& ts,
                                  std::vector<Cell>& cells) {
  ts.assign({arc.t_begin().rad(), arc.t_end().rad()});
  const Box box = arc.bounds();
  const Vec2 first = geometry.corner(geometry.cell_of(box.low));
  line_crossings(arc, {1, 0}, first.x, geometry.cell_m, box.high.x, ts);
  line_crossings(arc, {0, 1}, first.y, geometry.cell_m, box.high.y, ts);
  std::ranges::sort(ts);
  DistinctCells distinct(cells, ts.size(), arc.range_m() < tight_radius_cells * geometry.cell_m);
  for (std::size_t k = 1; k < ts.size(); ++k)
    if (ts[k] - ts[k - 1] > 1e-12) distinct.add(geometry.cell_of(arc.point_at(radians(0.5 * (ts[k - 1] + ts[k])))));
  return distinct.get();
}

}  // namespace

std::span<const Cell> ArcRaster::cells(const Arc& arc) {
  return sampling_ == ArcSampling::sampled ? sampled_cells(arc, geometry_, scratch_, cells_)
                                           : exact_cells(arc, geometry_, scratch_, cells_);
}

}  // namespace echoarc
