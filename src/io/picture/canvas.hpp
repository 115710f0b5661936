// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/vec2.hpp"

namespace echoarc::io {

struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend constexpr bool operator==(Color, Color) = default;
};

/// 0xRRGGBB
[[nodiscard]] constexpr Color rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex)};
}
/// `from` at 0, `to` at 1.
[[nodiscard]] Color mix(Color from, Color to, double fraction);

/// An RGB picture one can draw on with anti-aliased edges. Coordinates are pixels, x right, y down; pixel (i, j) covers
/// [i, i+1) x [j, j+1). Whatever lies outside is clipped.
class Canvas {
 public:
  Canvas(int width, int height, Color background);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::span<const std::uint8_t> rgb_bytes() const { return rgb_; }
  [[nodiscard]] Color at(int x, int y) const;
  void set(int x, int y, Color color);
  /// Pixels x0 <= x < x1, y0 <= y < y1.
  void fill_rect(int x0, int y0, int x1, int y1, Color color);
  /// Copies `other` so that its upper left pixel comes to (x, y).
  void paste(const Canvas& other, int x, int y);
  void fill_disc(Vec2 centre, double radius, Color color);
  /// A line with round ends and joints; where it crosses itself it does not get darker. A single point is a dot.
  void stroke(std::span<const Vec2> line, double width, Color color, double opacity = 1.0);

 private:
  struct PixelBox {
    int x0, y0, x1, y1;
  };
  /// The pixels within `reach` of the points, clipped to the canvas.
  [[nodiscard]] PixelBox pixels_around(std::span<const Vec2> points, double reach) const;
  void blend(int x, int y, Color color, double opacity);

  int width_;
  int height_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace echoarc::io
