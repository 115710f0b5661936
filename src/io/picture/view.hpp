// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

#include "echoarc/core/result.hpp"
#include "echoarc/io/picture.hpp"

namespace echoarc::io {

/// Which part of the world a picture shows, and how large.
struct View {
  Vec2 low;  ///< lower left corner, world, metres
  double pixels_per_m = 1;
  int width = 0;  ///< of the map, pixels
  int height = 0;
  CellBox cells;            ///< cells shown; empty without a grid
  int pixels_per_cell = 0;  ///< >= 1 when cells are enlarged; 0 when they are reduced
  int cells_per_pixel = 1;

  /// From the world to pixels of the map, y down.
  [[nodiscard]] Vec2 pixel(Vec2 world) const {
    return {(world.x - low.x) * pixels_per_m, height - (world.y - low.y) * pixels_per_m};
  }
};

/// Fits a view around the known cells, the path, what stands and moves there, echoes not far off, and (without a grid)
/// the points.
[[nodiscard]] Result<View> fit_view(const PictureContent& content);

/// Most of the map's width that the scale bar takes.
inline constexpr double scale_bar_share = 0.2;

/// The longest of 1, 2, 5 x 10^k metres that takes at most `share` of the map's width, but at least 40 pixels.
[[nodiscard]] double scale_bar_m(const View& view, double share);

}  // namespace echoarc::io
