// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/picture/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace echoarc::io {
namespace {

constexpr int comfortable_pixels = 1400;  // of the long side of an enlarged map
constexpr int most_pixels = 1600;
constexpr double margin_share = 0.03;  // of the long side, on every side
constexpr double farthest_m = 1e5;
constexpr double smallest_m = 0.5;  // a single point still gets surroundings

/// The smallest box around what it was given.
class Bounds {
 public:
  void add(Vec2 p) {
    if (!is_finite(p)) return;
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  [[nodiscard]] bool empty() const { return low_.x > high_.x; }
  [[nodiscard]] double longer_m() const { return std::max({high_.x - low_.x, high_.y - low_.y, smallest_m}); }
  [[nodiscard]] bool holds(Vec2 p, double beyond_m) const {
    return p.x > low_.x - beyond_m && p.y > low_.y - beyond_m && p.x < high_.x + beyond_m && p.y < high_.y + beyond_m;
  }
  [[nodiscard]] Box with_margin() const {
    const double margin_m = longer_m() * margin_share;
    const Vec2 margin = {margin_m, margin_m};
    return {low_ - margin, high_ + margin};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low_{infinity, infinity};
  Vec2 high_{-infinity, -infinity};
};

/// Echoes that seem to come from a little outside of the world are of interest; the odd one from far away is not worth
/// showing everything else small.
void add_near_echoes(Bounds& bounds, std::span<const EchoMark> echoes) {
  constexpr double near_share = 0.35;
  const Bounds world = bounds;
  const double near_m = near_share * world.longer_m();
  for (const EchoMark& echo : echoes)
    if (world.empty() || world.holds(echo.position, near_m)) bounds.add(echo.position);
}

CellBox known_cells(const DenseGrid<CellState>& grid) {
  CellBox box;
  for (std::int32_t j = 0; j < grid.height(); ++j) {
    const auto row = grid.row(j);
    const auto known = [](CellState state) { return state != CellState::unknown; };
    const auto first = std::ranges::find_if(row, known);
    if (first == row.end()) continue;
    const auto last = std::ranges::find_if(row.rbegin(), row.rend(), known).base();
    box = unite(box, {std::int32_t(first - row.begin()), j, std::int32_t(last - row.begin()), j + 1});
  }
  return box;
}

/// Whole pixels a cell, or whole cells a pixel, so that every cell of a picture is as large as the next.
View view_of_cells(const GridGeometry& geometry, const CellBox& cells) {
  const std::int64_t longer = std::max(cells.width(), cells.height());
  View view;
  view.cells = cells;
  view.low = geometry.corner({cells.i_begin, cells.j_begin});
  if (longer <= most_pixels) {
    view.pixels_per_cell = static_cast<int>(std::max<std::int64_t>(comfortable_pixels / longer, 1));
    view.pixels_per_m = view.pixels_per_cell / geometry.cell_m;
    view.width = static_cast<int>(cells.width()) * view.pixels_per_cell;
    view.height = static_cast<int>(cells.height()) * view.pixels_per_cell;
    return view;
  }
  const std::int64_t step = (longer + most_pixels - 1) / most_pixels;
  view.cells_per_pixel = static_cast<int>(step);
  view.pixels_per_m = 1.0 / (geometry.cell_m * static_cast<double>(step));
  view.width = static_cast<int>((cells.width() + step - 1) / step);
  view.height = static_cast<int>((cells.height() + step - 1) / step);
  return view;
}

View view_of_box(const Box& box) {
  const Vec2 size = box.high - box.low;
  View view;
  view.low = box.low;
  view.pixels_per_m = comfortable_pixels / std::max(size.x, size.y);
  view.width = std::max(1, static_cast<int>(std::ceil(size.x * view.pixels_per_m)));
  view.height = std::max(1, static_cast<int>(std::ceil(size.y * view.pixels_per_m)));
  return view;
}

}  // namespace

Result<View> fit_view(const PictureContent& content) {
  Bounds bounds;
  const CellBox known = content.states != nullptr ? known_cells(*content.states) : CellBox{};
  if (!known.empty()) {
    bounds.add(content.states->geometry().corner({known.i_begin, known.j_begin}));
    bounds.add(content.states->geometry().corner({known.i_end, known.j_end}));
  } else {
    for (const MapPoint& point : content.points) bounds.add(point.position);
  }
  for (const Vec2 position : content.path) bounds.add(position);
  for (const auto& lines : {content.surfaces, content.movers})
    for (const std::vector<Vec2>& line : lines)
      for (const Vec2 point : line) bounds.add(point);
  add_near_echoes(bounds, content.echoes);
  if (bounds.empty())
    return Error{ErrorCode::bad_value, "there is nothing to draw", "", "the map holds no cell, point or path"};
  const Box box = bounds.with_margin();
  if (std::max(box.high.x - box.low.x, box.high.y - box.low.y) > farthest_m)
    return Error{ErrorCode::too_large, "the map is spread over more than 100 km", "",
                 "check the units of the log: metres are expected"};
  if (known.empty()) return view_of_box(box);
  return view_of_cells(content.states->geometry(), content.states->geometry().cells_of(box));
}

double scale_bar_m(const View& view, double share) {
  const double longest_m = std::max(share * view.width, 40.0) / view.pixels_per_m;
  const double decade = std::pow(10.0, std::floor(std::log10(longest_m)));
  for (const double factor : {5.0, 2.0})
    if (factor * decade <= longest_m) return factor * decade;
  return decade;
}

}  // namespace echoarc::io
