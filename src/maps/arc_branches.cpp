// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "maps/arc_branches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/raster_kernels.hpp"

namespace echoarc {
namespace {

/// The whole ellipse of an arc about its centre, lengths in cells: all u with u' M^-1 u = 1, M = A^2 f f' + B^2 g g'.
struct Rim {
  double xx;
  double xy;
  double yy;
  Vec2 top;        ///< highest point; the lowest is its opposite
  Vec2 rightmost;  ///< the leftmost is its opposite

  Rim(const Arc& arc, double per_cell) {
    const double a = arc.range_m() * per_cell;
    xx = yy = a * a;
    xy = 0.0;
    top = {0.0, a};
    rightmost = {a, 0.0};
    if (arc.is_circular()) return;
    const double b = arc.semi_minor_m() * per_cell;
    const Vec2 f = arc.focal_axis();
    xx = a * a * f.x * f.x + b * b * f.y * f.y;
    yy = a * a * f.y * f.y + b * b * f.x * f.x;
    xy = (a - b) * (a + b) * f.x * f.y;
    top = {xy / std::sqrt(yy), std::sqrt(yy)};
    rightmost = {std::sqrt(xx), xy / std::sqrt(xx)};
  }
};

/// Whether a counter-clockwise turn of less than 180 degrees passes a direction.
bool passes(Vec2 from, Vec2 direction, Vec2 to) {
  return cross(from, direction) > 0.0 && cross(direction, to) > 0.0;
}

/// A branch between two points of the rim, and its rows.
struct Piece {
  Vec2 from;
  Vec2 to;
  std::int32_t j_first = 0;
  std::size_t rows = 0;

  Piece() = default;
  Piece(Vec2 from_rim, Vec2 to_rim, double centre_y) : from(from_rim), to(to_rim) {
    j_first = std::int32_t(std::floor(centre_y + low().y));
    // An end that only touches a row from below does not enter it.
    const auto j_last = std::int32_t(std::ceil(centre_y + high().y)) - 1;
    rows = std::size_t(std::max(j_last - j_first, 0)) + 1;
  }
  [[nodiscard]] bool rising() const { return to.y >= from.y; }
  [[nodiscard]] Vec2 low() const { return rising() ? from : to; }
  [[nodiscard]] Vec2 high() const { return rising() ? to : from; }
  [[nodiscard]] std::size_t room() const {
    return (rows + kernels::arc_lanes) / kernels::arc_lanes * kernels::arc_lanes + kernels::arc_lanes;
  }
};

/// Columns of a branch while they are being found.
struct Columns {
  std::int32_t* crossing;
  std::int32_t* begin;
  std::int32_t* end;
  std::int32_t outermost = -1;

  Columns(std::int32_t* scratch, std::size_t room)
      : crossing(scratch), begin(scratch + room), end(scratch + 2 * room) {}
};

class BranchFinder {
 public:
  BranchFinder(const Arc& arc, const GridGeometry& geometry)
      : per_cell_(1.0 / geometry.cell_m),
        rim_(arc, per_cell_),
        centre_(per_cell_ * (arc.centre() - geometry.origin)),
        i_base_(std::floor(centre_.x - rim_.rightmost.x) - 1.0),
        i_last_(std::int32_t(std::ceil(centre_.x + rim_.rightmost.x)) - 1) {
    const Vec2 from = rim_point(arc, arc.t_begin());
    const Vec2 to = rim_point(arc, arc.t_end());
    const Vec2 turning = passes(from, rim_.top, to) ? rim_.top : -rim_.top;
    const bool turns = passes(from, turning, to);
    pieces_[0] = Piece(from, turns ? turning : to, centre_.y);
    if (turns) pieces_[1] = Piece(turning, to, centre_.y);
  }

  [[nodiscard]] std::span<const ArcBranch> find(std::vector<std::int32_t>& scratch,
                                                std::array<ArcBranch, 2>& branches) const {
    const std::size_t room = std::max(pieces_[0].room(), pieces_[1].room());
    if (scratch.size() < 6 * room) scratch.resize(6 * room);
    std::array<Columns, 2> columns{Columns(scratch.data(), room), Columns(scratch.data() + 3 * room, room)};
    const std::size_t count = pieces_[1].rows > 0 ? 2 : 1;
    for (std::size_t b = 0; b < count; ++b) run(pieces_[b], columns[b]);
    if (count == 2) separate(columns[0], columns[1]);
    for (std::size_t b = 0; b < count; ++b) {
      const Piece& piece = pieces_[b];
      branches[b] = {piece.j_first,
                     piece.rising(),
                     {columns[b].begin, piece.rows},
                     {columns[b].end, piece.rows},
                     {columns[b].crossing, piece.rows + 1},
                     columns[b].outermost};
    }
    return std::span<const ArcBranch>(branches).first(count);
  }

 private:
  [[nodiscard]] Vec2 rim_point(const Arc& arc, Angle t) const {
    return arc.radius_at(t) * per_cell_ * unit(arc.axis() + t);
  }
  [[nodiscard]] std::int32_t column(Vec2 rim_point) const {
    return std::min(std::int32_t(std::floor(centre_.x + rim_point.x)), i_last_);
  }

  void run(const Piece& piece, Columns& columns) const {
    kernels::ArcRowShape shape{};
    shape.centre_x = centre_.x - i_base_;
    shape.first_dy = piece.j_first + 1 - centre_.y;
    shape.shear = rim_.xy / rim_.yy;
    shape.half_squared = rim_.xx - rim_.xy * shape.shear;
    shape.narrowing = shape.half_squared / rim_.yy;
    const Vec2 middle = piece.from + piece.to;
    shape.side = middle.x >= shape.shear * middle.y ? 1.0 : -1.0;
    shape.i_base = std::int32_t(i_base_);
    shape.i_last = i_last_;
    shape.i_low = column(piece.low());
    shape.i_high = column(piece.high());
    kernels::raster_kernels().arc_rows(shape, piece.rows, columns.crossing, columns.begin, columns.end);
    add_bulge(piece, rim_.rightmost, columns);
    add_bulge(piece, -rim_.rightmost, columns);
  }

  /// Between two row edges the branch may reach further to the side than at either.
  void add_bulge(const Piece& piece, Vec2 outermost, Columns& columns) const {
    if (!passes(piece.from, outermost, piece.to)) return;
    const auto j = std::int32_t(std::floor(centre_.y + outermost.y));
    const auto k = std::size_t(std::clamp(j - piece.j_first, 0, std::int32_t(piece.rows) - 1));
    const std::int32_t i = column(outermost);
    columns.begin[k] = std::min(columns.begin[k], i);
    columns.end[k] = std::max(columns.end[k], i + 1);
    columns.outermost = std::int32_t(k);
  }

  /// Two branches meet at a top or a bottom, in one cell or in two on top of each other: the first keeps them. Further
  /// away an arc this wide has opened to more than a cell.
  void separate(const Columns& first, const Columns& second) const {
    const bool at_top = pieces_[0].rising();
    const std::int32_t j_turn = at_top ? pieces_[0].j_first + std::int32_t(pieces_[0].rows) - 1 : pieces_[0].j_first;
    for (const std::int32_t j : {j_turn, at_top ? j_turn - 1 : j_turn + 1}) {
      const std::int32_t a = j - pieces_[0].j_first;
      const std::int32_t b = j - pieces_[1].j_first;
      if (a < 0 || b < 0 || a >= std::int32_t(pieces_[0].rows) || b >= std::int32_t(pieces_[1].rows)) continue;
      if (at_top)  // counter-clockwise, the first branch comes from the right
        second.end[b] = std::min(second.end[b], first.begin[a]);
      else
        second.begin[b] = std::max(second.begin[b], first.end[a]);
    }
  }

  double per_cell_;
  Rim rim_;
  Vec2 centre_;
  double i_base_;
  std::int32_t i_last_;
  std::array<Piece, 2> pieces_;
};

}  // namespace

std::span<const ArcBranch> find_branches(const Arc& arc, const GridGeometry& geometry,
                                         std::vector<std::int32_t>& columns, std::array<ArcBranch, 2>& branches) {
  return BranchFinder(arc, geometry).find(columns, branches);
}

}  // namespace echoarc
