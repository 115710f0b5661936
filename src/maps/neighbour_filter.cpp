// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/neighbour_filter.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {
namespace {

/// Cells so small that points of one cell are neighbours, whatever their place in it. A crowded cell then settles its
/// own points at once, and only the few points of sparse cells look around: two cells to all sides hold the radius.
constexpr double cells_per_radius = 1.5;
constexpr std::int32_t cells_around = 2;

class PointCells {
 public:
  PointCells(std::span<const MapPoint> points, double radius_m)
      : points_(points), radius_m_(radius_m), geometry_{.cell_m = radius_m / cells_per_radius, .origin = {}} {
    entries_.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) entries_.emplace_back(geometry_.cell_of(points[k].position), k);
    std::sort(entries_.begin(), entries_.end());
  }

  /// Stops counting at `enough`.
  [[nodiscard]] bool has_neighbours(std::size_t point, int enough) const {
    return has_neighbours(points_[point].position, point, enough);
  }
  /// The same of any place, but for the point `self`, if it is one.
  [[nodiscard]] bool has_neighbours(Vec2 p, std::size_t self, int enough) const {
    const Cell own = geometry_.cell_of(p);
    if (points_of(own, own.i).size() > std::size_t(enough)) return true;
    int found = 0;
    for (std::int32_t j = own.j - cells_around; j <= own.j + cells_around; ++j)
      for (const Entry& entry : points_of({own.i - cells_around, j}, own.i + cells_around)) {
        if (entry.second == self || norm(points_[entry.second].position - p) > radius_m_) continue;
        if (++found >= enough) return true;
      }
    return false;
  }

 private:
  using Entry = std::pair<Cell, std::size_t>;

  /// Of the cells from `first` to column `last_i` of its row.
  [[nodiscard]] std::span<const Entry> points_of(Cell first, std::int32_t last_i) const {
    const auto begin = std::lower_bound(entries_.begin(), entries_.end(), Entry{first, 0});
    const auto end = std::lower_bound(begin, entries_.end(), Entry{{last_i + 1, first.j}, 0});
    return {begin, end};
  }

  std::span<const MapPoint> points_;
  double radius_m_;
  GridGeometry geometry_;
  std::vector<Entry> entries_;
};

}  // namespace

PointMap with_neighbours(const PointMap& points, const NeighbourRule& rule) {
  if (rule.min_neighbours <= 0) return points;
  const PointCells cells(points.points(), rule.radius_m);
  PointMap kept;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!cells.has_neighbours(k, rule.min_neighbours)) continue;
    const MapPoint& point = points.points()[k];
    if (points.beliefs().empty())
      kept.add(point, points.support(point));
    else
      kept.add(point, points.support(point), points.beliefs()[k]);
  }
  for (const MapSegment& segment : points.segments())
    if (cells.has_neighbours(0.5 * (segment.begin + segment.end), points.size(), rule.min_neighbours))
      kept.add(segment);
  return kept;
}

}  // namespace echoarc
