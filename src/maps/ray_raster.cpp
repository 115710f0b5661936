// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/ray_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One coordinate of a ray in cell units: position p + t d.
struct Axis {
  double p = 0.0;
  double d = 0.0;
  std::int32_t begin = 0;  ///< cells begin <= index < end are of interest
  std::int32_t end = 0;

  /// Narrows [t_in, t_out] to where the ray lies inside [begin, end] (Liang, Barsky 1984).
  void clip(double& t_in, double& t_out) const {
    if (d == 0.0) {
      if (p < begin || p >= end) t_out = -infinity;
      return;
    }
    const double a = (begin - p) / d;
    const double b = (end - p) / d;
    t_in = std::max(t_in, std::min(a, b));
    t_out = std::min(t_out, std::max(a, b));
  }
  /// The cell at t; rounding may put the point of entry just outside.
  [[nodiscard]] std::int32_t index_at(double t) const {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(p + t * d), static_cast<double>(begin), static_cast<double>(end - 1)));
  }
};

/// The walk along one coordinate. The next grid line is computed anew each time: no error gathers along long rays.
class Walk {
 public:
  Walk(const Axis& axis, double t_in)
      : axis_(axis),
        step_(axis.d < 0.0 ? -1 : 1),
        per_d_(axis.d != 0.0 ? 1.0 / axis.d : 0.0),
        index_(axis.index_at(t_in)) {
    find_next();
  }
  [[nodiscard]] std::int32_t index() const { return index_; }
  [[nodiscard]] double t_next() const { return t_next_; }
  [[nodiscard]] std::int32_t index_after() const { return index_ + step_; }
  [[nodiscard]] bool inside() const { return index_ >= axis_.begin && index_ < axis_.end; }
  void advance() {
    index_ += step_;
    find_next();
  }
  /// Where the ray leaves the block of the cell.
  [[nodiscard]] double t_out_of_block() const {
    constexpr std::int32_t in_block = BlockMask::block_size - 1;
    return t_leaving(step_ > 0 ? index_ | in_block : index_ & ~in_block);
  }
  /// To where the steps before t lead; they must not leave the block of the cell.
  void advance_before(double t) {
    if (axis_.d == 0.0) return;
    constexpr std::int32_t in_block = BlockMask::block_size - 1;
    const std::int32_t begin = step_ > 0 ? index_ : index_ & ~in_block;
    const std::int32_t last = step_ > 0 ? index_ | in_block : index_;
    auto index = static_cast<std::int32_t>(std::clamp(axis_.p + t * axis_.d, double(begin), double(last)));
    while (index != index_ && t_leaving(index - step_) >= t) index -= step_;
    while (t_leaving(index) < t) index += step_;
    index_ = index;
    find_next();
  }

 private:
  [[nodiscard]] double t_leaving(std::int32_t index) const {
    return axis_.d != 0.0 ? (index + (step_ > 0 ? 1 : 0) - axis_.p) * per_d_ : infinity;
  }
  void find_next() { t_next_ = t_leaving(index_); }

  Axis axis_;
  std::int32_t step_;
  double per_d_;
  std::int32_t index_;
  double t_next_ = 0.0;
};

}  // namespace

BlockMask::BlockMask(const CellBox& box) {
  if (box.empty()) return;
  tiles_ = {box.i_begin >> tile_shift, box.j_begin >> tile_shift, ((box.i_end - 1) >> tile_shift) + 1,
            ((box.j_end - 1) >> tile_shift) + 1};
  words_.resize(std::size_t(tiles_.width()) * std::size_t(tiles_.height()));
}

std::span<const Cell> RayRaster::cells(Vec2 origin, Vec2 direction, double length_m, const CellBox& within,
                                       const BlockMask* blocks) {
  cells_.clear();
  const double per_cell = 1.0 / geometry_.cell_m;
  const Vec2 p = per_cell * (origin - geometry_.origin);
  const Axis x{p.x, direction.x, within.i_begin, within.i_end};
  const Axis y{p.y, direction.y, within.j_begin, within.j_end};
  double t_in = 0.0;
  double t_out = length_m * per_cell;
  if (within.empty()) return cells_;
  x.clip(t_in, t_out);
  y.clip(t_in, t_out);
  if (!(t_in <= t_out)) return cells_;

  Walk i(x, t_in);
  Walk j(y, t_in);
  const auto visit = [&](Cell c) {
    if (within.contains(c)) cells_.push_back(c);
  };
  while (i.inside() && j.inside()) {
    if (blocks == nullptr || blocks->holds({i.index(), j.index()})) {
      cells_.push_back({i.index(), j.index()});
    } else {  // straight to the step out of the block
      const double t = std::min(i.t_out_of_block(), j.t_out_of_block());
      if (t > t_out) break;
      i.advance_before(t);
      j.advance_before(t);
    }
    const double t = std::min(i.t_next(), j.t_next());
    if (t > t_out) break;
    const bool step_i = i.t_next() == t;
    const bool step_j = j.t_next() == t;
    if (step_i && step_j) {  // through a corner
      visit({i.index_after(), j.index()});
      visit({i.index(), j.index_after()});
    }
    if (step_i) i.advance();
    if (step_j) j.advance();
  }
  return cells_;
}

}  // namespace echoarc
