// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/map_picture.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace echoarc::studies {
namespace {

constexpr Rgb white{255, 255, 255};
constexpr Rgb unknown_gray{222, 222, 222};
constexpr Rgb occupied_gray{30, 30, 30};

Rgb color_of(CellState state) {
  if (state == CellState::free) return white;
  return state == CellState::occupied ? occupied_gray : unknown_gray;
}

}  // namespace

Rgb color_of(PointLabel label) {
  constexpr std::array<Rgb, point_label_count> colors{{{230, 159, 0},
                                                       {30, 30, 30},
                                                       {0, 158, 115},
                                                       {0, 114, 178},
                                                       {213, 94, 0},
                                                       {204, 121, 167},
                                                       {30, 30, 30},
                                                       {213, 94, 0},
                                                       {150, 150, 150},
                                                       {0, 114, 178},
                                                       {230, 159, 0}}};
  return colors[static_cast<std::size_t>(label)];
}

MapPicture::MapPicture(const Box& region, std::int32_t long_side_px) : region_(region) {
  const Vec2 size = region.high - region.low;
  assert(size.x > 0.0 && size.y > 0.0 && long_side_px > 0 && long_side_px <= max_side_px);
  pixels_per_m_ = long_side_px / std::max(size.x, size.y);
  image_.width = std::max(1, std::int32_t(std::lround(size.x * pixels_per_m_)));
  image_.height = std::max(1, std::int32_t(std::lround(size.y * pixels_per_m_)));
  image_.rgb.assign(std::size_t(image_.width) * std::size_t(image_.height) * 3, 255);
}

void MapPicture::set(std::int32_t column, std::int32_t row, Rgb color) {
  if (column < 0 || row < 0 || column >= image_.width || row >= image_.height) return;
  std::uint8_t* pixel = &image_.rgb[3 * (std::size_t(row) * std::size_t(image_.width) + std::size_t(column))];
  pixel[0] = color.red;
  pixel[1] = color.green;
  pixel[2] = color.blue;
}

void MapPicture::dot(Vec2 point, Rgb color, std::int32_t size_px) {
  const Vec2 local = (point - region_.low) * pixels_per_m_;
  // Far points are cut off here: their pixels would not fit the numbers.
  if (!(local.x > -size_px && local.y > -size_px && local.x < image_.width + size_px &&
        local.y < image_.height + size_px))
    return;
  const auto column = std::int32_t(std::floor(local.x)) - size_px / 2;
  const auto row = image_.height - 1 - std::int32_t(std::floor(local.y)) - size_px / 2;
  for (std::int32_t dy = 0; dy < size_px; ++dy)
    for (std::int32_t dx = 0; dx < size_px; ++dx) set(column + dx, row + dy, color);
}

void MapPicture::add_cells(const DenseGrid<CellState>& grid) {
  for (std::int32_t row = 0; row < image_.height; ++row)
    for (std::int32_t column = 0; column < image_.width; ++column) {
      const Vec2 offset = Vec2{column + 0.5, image_.height - 0.5 - row} / pixels_per_m_;
      const Cell cell = grid.geometry().cell_of(region_.low + offset);
      set(column, row, color_of(grid.box().contains(cell) ? grid.at(cell) : CellState::unknown));
    }
}

void MapPicture::add_line(std::span<const Vec2> points, Rgb color, std::int32_t width_px) {
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2 step = points[k] - points[k - 1];
    const auto steps = std::int32_t(std::min(std::ceil(2.0 * norm(step) * pixels_per_m_), 1e6));
    for (std::int32_t n = 0; n <= steps; ++n)
      dot(points[k - 1] + step * (steps == 0 ? 0.0 : double(n) / steps), color, width_px);
  }
}

void MapPicture::add_surfaces(const sim::WorldDescription& world, Rgb color, std::int32_t width_px) {
  for (const sim::Wall& wall : world.walls) add_line(std::array{wall.a, wall.b}, color, width_px);
  for (const sim::SmoothCurve& curve : world.curves) add_line(curve.points, color, width_px);
  for (const sim::Disc& disc : world.discs) {
    const double step = 0.5 / pixels_per_m_;
    for (double y = -disc.radius_m; y <= disc.radius_m; y += step) {
      const double half = std::sqrt(std::max(0.0, disc.radius_m * disc.radius_m - y * y));
      add_line(std::array{disc.centre + Vec2{-half, y}, disc.centre + Vec2{half, y}}, color, 1);
    }
  }
}

void MapPicture::add_points(std::span<const Vec2> points, Rgb color, std::int32_t size_px) {
  for (const Vec2 point : points) dot(point, color, size_px);
}

void MapPicture::add_points(std::span<const MapPoint> points, std::int32_t size_px) {
  for (const MapPoint& point : points) dot(point.position, color_of(point.label), size_px);
}

}  // namespace echoarc::studies
