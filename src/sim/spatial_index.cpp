// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/spatial_index.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::sim {

namespace {

constexpr double largest_cell_m = 0.5;    // where few things stand
constexpr double smallest_cell_m = 0.02;  // where many do: about two per cell
constexpr double rim_m = 2e-6;  // cells list what comes this near: a ray along the border of two cells misses nothing
constexpr double slanted_m = 0.01;

std::vector<CurveChunk> chunks_of(std::span<const SmoothCurve> curves) {
  std::vector<CurveChunk> chunks;
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    const auto facets = static_cast<std::uint32_t>(points.size() - 1);
    for (std::uint32_t first = 0; first < facets; first += CurveChunk::facets) {
      const std::uint32_t last = std::min(facets, first + CurveChunk::facets);
      CurveChunk chunk{c, first, last, 0.5 * (points[first] + points[last]), 0.0};
      for (std::uint32_t i = first; i <= last; ++i)
        chunk.radius_m = std::max(chunk.radius_m, norm(points[i] - chunk.centre));
      chunks.push_back(chunk);
    }
  }
  return chunks;
}

}  // namespace

SpatialIndex::SpatialIndex(const WorldDescription& description)
    : chunks_(chunks_of(description.curves)), discs_(description.discs) {
  for (const Wall& wall : description.walls)
    segments_.push_back(
        {wall.a, wall.b - wall.a, wall.one_sided, description.materials[wall.material].rough_db.has_value()});
  for (const SmoothCurve& curve : description.curves) curves_.emplace_back(curve.points);
  choose_cells();
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  starts_.assign(cells + 1, 0);
  for (std::uint32_t i = 0; i < count(); ++i) cells_of(i, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t c = 0; c < cells; ++c) starts_[c + 1] += starts_[c];
  items_.resize(starts_.back());
  std::vector<std::uint64_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < count(); ++i) cells_of(i, [&](std::size_t cell) { items_[next[cell]++] = i; });
}

SpatialIndex::Box SpatialIndex::box_of(std::uint32_t item) const {
  if (item < first_chunk()) {
    const Segment& s = segments_[item];
    const Vec2 b = s.a + s.along;
    return {{std::min(s.a.x, b.x), std::min(s.a.y, b.y)}, {std::max(s.a.x, b.x), std::max(s.a.y, b.y)}};
  }
  const bool is_chunk = item < first_disc();
  const Vec2 centre = is_chunk ? chunks_[item - first_chunk()].centre : discs_[item - first_disc()].centre;
  const double r = is_chunk ? chunks_[item - first_chunk()].radius_m : discs_[item - first_disc()].radius_m;
  return {{centre.x - r, centre.y - r}, {centre.x + r, centre.y + r}};
}

void SpatialIndex::choose_cells() {
  if (count() == 0) return;
  Box all = box_of(0);
  double crossed_m = 0.0;   // about cell_m times the number of cells that lines cross
  double covered_m2 = 0.0;  // the same for discs, which are listed in all cells of their box
  for (std::uint32_t i = 0; i < count(); ++i) {
    const Box box = box_of(i);
    all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y)};
    all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y)};
    const Vec2 size = box.high - box.low;
    if (i < first_chunk())
      crossed_m += size.x + size.y;
    else
      covered_m2 += size.x * size.y;
  }
  const Vec2 size = all.high - all.low;
  const double most = std::max(65536.0, 4.0 * count());
  cell_m_ = std::clamp(std::sqrt(2.0 * std::max(1.0, size.x) * std::max(1.0, size.y) / count()), smallest_cell_m,
                       largest_cell_m);
  const auto too_many = [&] {
    const double cells = (size.x / cell_m_ + 1.0) * (size.y / cell_m_ + 1.0);
    return cells > most || crossed_m / cell_m_ + covered_m2 / (cell_m_ * cell_m_) > 2.0 * most;
  };
  while (too_many()) cell_m_ *= 1.25;
  origin_ = all.low - Vec2{rim_m, rim_m};
  columns_ = static_cast<int>((size.x + 2.0 * rim_m) / cell_m_) + 1;
  rows_ = static_cast<int>((size.y + 2.0 * rim_m) / cell_m_) + 1;
}

SpatialIndex::Cell SpatialIndex::cell_at(Vec2 point) const {
  const Vec2 p = (point - origin_) / cell_m_;
  const auto clamped = [](double v, int count) {
    return v > 0.0 ? static_cast<int>(std::min(v, count - 1.0)) : 0;
  };  // NaN: 0
  return {clamped(p.x, columns_), clamped(p.y, rows_)};
}

std::span<const std::uint32_t> SpatialIndex::items(Cell cell) const {
  if (starts_.empty()) return {};
  const std::size_t c =
      static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(cell.x);
  return std::span(items_).subspan(starts_[c], starts_[c + 1] - starts_[c]);
}

/// Column by column: a slanted wall is listed in the cells it crosses, not in its whole box.
template <class Visit>
void SpatialIndex::cells_of(std::uint32_t item, const Visit& visit) const {
  const Box box = box_of(item);
  const Vec2 rim{rim_m, rim_m};
  const Cell low = cell_at(box.low - rim);
  const Cell high = cell_at(box.high + rim);
  const bool slanted = item < first_chunk() && std::abs(segments_[item].along.x) > slanted_m;
  for (int x = low.x; x <= high.x; ++x) {
    Cell bottom = low;
    Cell top = high;
    if (slanted && low.x != high.x) {
      const Segment& s = segments_[item];
      const double left = std::max(origin_.x + x * cell_m_ - rim_m, box.low.x);
      const double right = std::min(origin_.x + (x + 1) * cell_m_ + rim_m, box.high.x);
      const double y1 = s.a.y + s.along.y * ((left - s.a.x) / s.along.x);
      const double y2 = s.a.y + s.along.y * ((right - s.a.x) / s.along.x);
      const double rim_y = rim_m * (1.0 + std::abs(s.along.y / s.along.x));
      bottom.y = std::max(low.y, cell_at({left, std::min(y1, y2) - rim_y}).y);
      top.y = std::min(high.y, cell_at({left, std::max(y1, y2) + rim_y}).y);
    }
    for (int y = bottom.y; y <= top.y; ++y)
      visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
  }
}

/// Calls `visit(items, t_leave)` for the cells along a ray in their order, until it returns false (Amanatides and Woo
/// 1987).
template <class Visit>
void SpatialIndex::walk(const Ray& ray, const Visit& visit) const {
  if (starts_.empty()) return;
  const Vec2 size{columns_ * cell_m_, rows_ * cell_m_};
  double enter = ray.from_m;
  double leave = ray.to_m;
  const auto clip = [&](double o, double d, double low, double high) {
    if (d == 0.0) return o >= low && o <= high;
    const double t1 = (low - o) / d;
    const double t2 = (high - o) / d;
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
    return enter <= leave;
  };
  if (!clip(ray.origin.x, ray.direction.x, origin_.x, origin_.x + size.x)) return;
  if (!clip(ray.origin.y, ray.direction.y, origin_.y, origin_.y + size.y)) return;
  Cell cell = cell_at(ray.origin + enter * ray.direction);
  const auto border = [&](double o, double d, double low, int index) {
    return d == 0.0 ? never : (low + (index + (d > 0.0 ? 1 : 0)) * cell_m_ - o) / d;
  };
  double next_x = border(ray.origin.x, ray.direction.x, origin_.x, cell.x);
  double next_y = border(ray.origin.y, ray.direction.y, origin_.y, cell.y);
  const double step_x = ray.direction.x == 0.0 ? never : cell_m_ / std::abs(ray.direction.x);
  const double step_y = ray.direction.y == 0.0 ? never : cell_m_ / std::abs(ray.direction.y);
  while (true) {
    const double t = std::min(next_x, next_y);
    if (!visit(items(cell), t) || t >= leave) return;
    if (next_x <= next_y) {
      cell.x += ray.direction.x > 0.0 ? 1 : -1;
      next_x += step_x;
    } else {
      cell.y += ray.direction.y > 0.0 ? 1 : -1;
      next_y += step_y;
    }
    if (cell.x < 0 || cell.x >= columns_ || cell.y < 0 || cell.y >= rows_) return;
  }
}

double SpatialIndex::crossing_of(const Ray& ray, std::uint32_t item) const {
  if (item < first_chunk()) return crossing(ray, segments_[item]);
  if (item >= first_disc()) return crossing(ray, discs_[item - first_disc()]);
  const CurveChunk& chunk = chunks_[item - first_chunk()];
  if (std::abs(cross(ray.direction, chunk.centre - ray.origin)) > chunk.radius_m + rim_m) return never;
  const std::span<const Vec2> points = curves_[chunk.curve];
  double first = never;
  for (std::uint32_t i = chunk.first; i < chunk.last; ++i)
    first = std::min(first, crossing(ray, Segment{points[i], points[i + 1] - points[i]}));
  return first;
}

SpatialIndex::Hit SpatialIndex::first_hit(Ray ray) const {
  Hit hit;
  walk(ray, [&](std::span<const std::uint32_t> cell, double leave) {
    for (const std::uint32_t item : cell) {
      const double t = crossing_of(ray, item);
      if (t < hit.t || (t == hit.t && t < never && item < hit.item)) hit = {t, item};
    }
    return hit.t > leave;
  });
  return hit;
}

bool SpatialIndex::blocked(const Ray& ray, std::uint64_t& work) const {
  bool found = false;
  walk(ray, [&](std::span<const std::uint32_t> cell, double /*leave*/) {
    work += cell.size();
    found = std::ranges::any_of(cell, [&](std::uint32_t item) { return crossing_of(ray, item) < never; });
    return !found;
  });
  return found;
}

double SpatialIndex::distance(Vec2 point, std::uint32_t item) const {
  if (item < first_chunk()) return distance_to_segment(point, segments_[item].a, segments_[item].along);
  if (item >= first_disc()) {
    const Disc& disc = discs_[item - first_disc()];
    return std::max(0.0, norm(point - disc.centre) - disc.radius_m);
  }
  const CurveChunk& chunk = chunks_[item - first_chunk()];
  const std::span<const Vec2> points = curves_[chunk.curve];
  double nearest_m = never;
  for (std::uint32_t i = chunk.first; i < chunk.last; ++i)
    nearest_m = std::min(nearest_m, distance_to_segment(point, points[i], points[i + 1] - points[i]));
  return nearest_m;
}

double SpatialIndex::nearest(Vec2 point, double max_m) const {
  double best = max_m;
  const Cell low = cell_at(point - Vec2{max_m, max_m});
  const Cell high = cell_at(point + Vec2{max_m, max_m});
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x)
      for (const std::uint32_t item : items({x, y})) best = std::min(best, distance(point, item));
  return best;
}

}  // namespace echoarc::sim
