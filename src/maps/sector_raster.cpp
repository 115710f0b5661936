// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/sector_raster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "maps/raster_kernels.hpp"

namespace echoarc {
namespace {

/// The ellipse of constant half path about the centre: a x^2 + 2 b x y + c y^2 = 1, lengths in cells.
struct Rim {
  double a;
  double b;
  double c;

  Rim(const Arc& arc, double per_cell) {
    const Vec2 f = arc.focal_axis();
    const double longer = arc.range_m() * per_cell;
    const double shorter = arc.semi_minor_m() * per_cell;
    const double along = 1.0 / (longer * longer);
    const double across = 1.0 / (shorter * shorter);
    a = f.x * f.x * along + f.y * f.y * across;
    b = f.x * f.y * (along - across);
    c = f.y * f.y * along + f.x * f.x * across;
  }
  [[nodiscard]] Vec2 point_along(Vec2 u) const {
    return u / std::sqrt(a * u.x * u.x + 2.0 * b * u.x * u.y + c * u.y * u.y);
  }
  [[nodiscard]] Vec2 top() const {
    const double y = std::sqrt(a / (a * c - b * b));
    return {-b / a * y, y};
  }
};

/// dy of the lowest and highest row a sector may meet.
struct RowRange {
  double low = 0.0;
  double high = 0.0;

  void add(double dy) {
    low = std::min(low, dy);
    high = std::max(high, dy);
  }
};

/// One edge of the wedge as a bound on dx: side cross(u, d) = side (u.x dy - u.y dx) >= 0 bounds it by dy u.x / u.y,
/// from above where side u.y > 0 and from below where it is < 0; a level edge admits or refuses whole rows.
void add_edge(kernels::SectorShape& shape, RowRange& rows, int k, Vec2 u, double side) {
  shape.low_slope[k] = shape.high_slope[k] = 0.0;
  shape.low_offset[k] = -shape.outside;
  shape.high_offset[k] = shape.outside;
  if (u.y == 0.0) {
    (side * u.x > 0.0 ? rows.low : rows.high) = 0.0;
  } else if (side * u.y > 0.0) {
    shape.high_slope[k] = u.x / u.y;
    shape.high_offset[k] = 0.0;
  } else {
    shape.low_slope[k] = u.x / u.y;
    shape.low_offset[k] = 0.0;
  }
}

/// A sector as the kernels take it, and the rows it may meet.
struct Sector {
  kernels::SectorShape shape{};
  double apex_i;
  std::int32_t j_first;
  std::int32_t j_end;

  Sector(const GridGeometry& grid, const Arc& rim);
};

Sector::Sector(const GridGeometry& grid, const Arc& rim) {
  const double per_cell = 1.0 / grid.cell_m;
  const double reach = std::ceil(rim.range_m() * per_cell);
  apex_i = (rim.centre().x - grid.origin.x) * per_cell - 0.5;
  shape.apex_j = (rim.centre().y - grid.origin.y) * per_cell - 0.5;
  shape.outside = reach + 1.0;
  shape.i_below = std::int32_t(std::floor(apex_i) - reach) - 3;
  shape.i_above = std::int32_t(std::ceil(apex_i) + reach) + 3;
  shape.apex_from_below = apex_i - shape.i_below;
  shape.apex_from_above = shape.i_above - apex_i;

  const Rim ellipse(rim, per_cell);
  shape.half_squared = 1.0 / ellipse.a;
  shape.narrowing = (ellipse.a * ellipse.c - ellipse.b * ellipse.b) / (ellipse.a * ellipse.a);
  shape.shear = -ellipse.b / ellipse.a;

  // The sector is highest and lowest in its apex, in an end of its rim, or in the rim's own extreme points.
  const Vec2 lower = unit(rim.axis() - rim.half_width());
  const Vec2 upper = unit(rim.axis() + rim.half_width());
  RowRange rows;
  rows.add(ellipse.point_along(lower).y);
  rows.add(ellipse.point_along(upper).y);
  const Vec2 top = ellipse.top();
  for (const Vec2 extreme : {top, -top})
    if (cross(lower, extreme) >= 0.0 && cross(upper, extreme) <= 0.0) rows.add(extreme.y);
  add_edge(shape, rows, 0, lower, 1.0);
  add_edge(shape, rows, 1, upper, -1.0);
  j_first = std::int32_t(std::ceil(shape.apex_j + rows.low));
  j_end = std::max(j_first, std::int32_t(std::floor(shape.apex_j + rows.high)) + 1);
}

}  // namespace

SectorColumns SectorRaster::columns(const Arc& rim) {
  assert(rim.half_width() < degrees(90.0));
  const Sector sector(geometry_, rim);
  const auto rows = std::size_t(sector.j_end - sector.j_first);
  if (begin_.size() < rows) {
    begin_.resize(rows);
    end_.resize(rows);
  }
  kernels::raster_kernels().sector_rows(sector.shape, sector.j_first, rows, begin_.data(), end_.data());

  // The closed wedge begins in the apex; a cell centred there has no bearing and is no cell of the sector.
  const double apex_row = sector.shape.apex_j - sector.j_first;
  if (apex_row >= 0.0 && apex_row < double(rows) && apex_row == std::floor(apex_row)) {
    const auto k = std::size_t(apex_row);
    if (begin_[k] == sector.apex_i) ++begin_[k];
    if (end_[k] - 1 == sector.apex_i) --end_[k];
  }
  return {sector.j_first, std::span(begin_).first(rows), std::span(end_).first(rows)};
}

std::span<const RowSpan> SectorRaster::spans(const Arc& rim) {
  const SectorColumns columns = this->columns(rim);
  const std::size_t rows = columns.begin.size();
  if (spans_.size() < rows) spans_.resize(rows);
  std::size_t count = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    spans_[count] = {columns.j_first + std::int32_t(k), columns.begin[k], columns.end[k]};
    count += columns.begin[k] < columns.end[k] ? 1 : 0;
  }
  return std::span<const RowSpan>(spans_).first(count);
}

}  // namespace echoarc
