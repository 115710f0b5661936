// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/maps/point_map.hpp"
#include "echoarc/sim/world.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Colours of map points by what made them; those of Okabe and Ito.
[[nodiscard]] Rgb color_of(PointLabel label);

/// A map as the papers print it: the true surfaces in grey, the robot's path, the points of a method on top; or the
/// cells of a grid, free white, unknown light grey, occupied dark. Up is +y of the world. Later layers cover earlier
/// ones; what lies outside the region is cut off.
class MapPicture {
 public:
  static constexpr std::int32_t max_side_px = 4096;

  /// A white ground over `region` (metres, not empty), its longer side `long_side_px` pixels, at most `max_side_px`.
  explicit MapPicture(const Box& region, std::int32_t long_side_px = 640);

  void add_cells(const DenseGrid<CellState>& grid);
  /// Walls, discs and curves of a world; discs filled.
  void add_surfaces(const sim::WorldDescription& world, Rgb color = {150, 150, 150}, std::int32_t width_px = 3);
  void add_line(std::span<const Vec2> points, Rgb color, std::int32_t width_px = 1);
  /// Squares of `size_px` pixels.
  void add_points(std::span<const Vec2> points, Rgb color, std::int32_t size_px = 5);
  void add_points(std::span<const MapPoint> points, std::int32_t size_px = 5);

  [[nodiscard]] const Image& image() const { return image_; }

 private:
  void dot(Vec2 point, Rgb color, std::int32_t size_px);
  void set(std::int32_t column, std::int32_t row, Rgb color);

  Box region_;
  double pixels_per_m_ = 1.0;
  Image image_;
};

}  // namespace echoarc::studies
