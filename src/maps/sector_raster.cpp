// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/sector_raster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace echoarc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// dx of a row between two numbers; empty when low > high.
struct RowInterval {
  double low = -infinity;
  double high = infinity;
};

/// One edge of the wedge as a bound on dx in the row at height dy above the apex.
///
/// Inside the edge means side * cross(u, d) = side * (u.x dy - u.y dx) >= 0, so dx is bounded by dy u.x / u.y, from
/// above where side * u.y > 0 and from below where it is < 0; a level edge admits or refuses whole rows.
class WedgeEdge {
 public:
  WedgeEdge(Vec2 u, double side) : slope_(u.y != 0.0 ? u.x / u.y : 0.0), above_(side * u.y), level_(side * u.x) {}

  void clip(double dy, RowInterval& row) const {
    if (above_ > 0.0)
      row.high = std::min(row.high, dy * slope_);
    else if (above_ < 0.0)
      row.low = std::max(row.low, dy * slope_);
    else if (level_ * dy < 0.0)
      row.high = -infinity;
  }

 private:
  double slope_;
  double above_;
  double level_;
};

/// The ellipse of constant half path as a bound on dx: a dx^2 + 2 b dx dy + c dy^2 <= 1.
class Rim {
 public:
  explicit Rim(const Arc& arc) {
    const Vec2 f = arc.focal_axis();
    const double long_axis = 1.0 / (arc.range_m() * arc.range_m());
    const double short_axis = 1.0 / (arc.semi_minor_m() * arc.semi_minor_m());
    const double a = f.x * f.x * long_axis + f.y * f.y * short_axis;
    const double b = f.x * f.y * (long_axis - short_axis);
    width_squared_ = 1.0 / a;
    narrowing_ = long_axis * short_axis / (a * a);  // (a c - b^2) / a^2; the determinant is that of the axes
    shear_ = -b / a;
  }
  void clip(double dy, RowInterval& row) const {
    const double half_squared = width_squared_ - dy * dy * narrowing_;
    if (half_squared < 0.0) {
      row.high = -infinity;
      return;
    }
    const double half = std::sqrt(half_squared);
    row.low = std::max(row.low, shear_ * dy - half);
    row.high = std::min(row.high, shear_ * dy + half);
  }

 private:
  double width_squared_;
  double narrowing_;
  double shear_;
};

}  // namespace

std::span<const RowSpan> SectorRaster::spans(const Arc& rim) {
  assert(rim.half_width() < degrees(90.0));
  spans_.clear();
  const WedgeEdge lower(unit(rim.axis() - rim.half_width()), 1.0);
  const WedgeEdge upper(unit(rim.axis() + rim.half_width()), -1.0);
  const Rim ellipse(rim);
  // In cell units with cell centres at whole numbers.
  const double per_cell = 1.0 / geometry_.cell_m;
  const double apex_i = (rim.centre().x - geometry_.origin.x) * per_cell - 0.5;
  const double apex_j = (rim.centre().y - geometry_.origin.y) * per_cell - 0.5;
  const Box box = rim.bounds();
  const auto row_of = [&](double y) { return (y - geometry_.origin.y) * per_cell - 0.5; };
  const auto j_first = std::int32_t(std::ceil(std::min(row_of(box.low.y), apex_j)));
  const auto j_last = std::int32_t(std::floor(std::max(row_of(box.high.y), apex_j)));
  for (std::int32_t j = j_first; j <= j_last; ++j) {
    const double dy = (j - apex_j) * geometry_.cell_m;
    RowInterval row;
    ellipse.clip(dy, row);
    lower.clip(dy, row);
    upper.clip(dy, row);
    if (!(row.low <= row.high)) continue;
    auto i_begin = std::int32_t(std::ceil(apex_i + row.low * per_cell));
    auto i_end = std::int32_t(std::floor(apex_i + row.high * per_cell)) + 1;
    // The closed wedge begins in the apex; a cell centred there has no bearing and is no cell of the sector.
    if (dy == 0.0 && i_begin < i_end && double(i_begin) == apex_i) ++i_begin;
    if (dy == 0.0 && i_begin < i_end && double(i_end - 1) == apex_i) --i_end;
    if (i_begin < i_end) spans_.push_back({j, i_begin, i_end});
  }
  return spans_;
}

}  // namespace echoarc
