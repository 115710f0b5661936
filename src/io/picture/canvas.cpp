// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/picture/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::io {
namespace {

std::uint8_t mix_channel(std::uint8_t from, std::uint8_t to, double fraction) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * fraction));
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double length2 = squared_norm(ab);
  const double along = length2 > 0.0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + along * ab));
}

/// Share of a pixel inside an outline that passes at `inside` pixels from its centre, positive on the inner side.
double coverage(double inside) {
  return std::clamp(inside + 0.5, 0.0, 1.0);
}

Vec2 pixel_centre(int x, int y) {
  return {x + 0.5, y + 0.5};
}

}  // namespace

Color mix(Color from, Color to, double fraction) {
  return {mix_channel(from.r, to.r, fraction), mix_channel(from.g, to.g, fraction),
          mix_channel(from.b, to.b, fraction)};
}

Canvas::Canvas(int width, int height, Color background)
    : width_(width), height_(height), rgb_(std::size_t(width) * std::size_t(height) * 3) {
  fill_rect(0, 0, width, height, background);
}

Color Canvas::at(int x, int y) const {
  const std::size_t k = (std::size_t(y) * std::size_t(width_) + std::size_t(x)) * 3;
  return {rgb_[k], rgb_[k + 1], rgb_[k + 2]};
}

void Canvas::set(int x, int y, Color color) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  const std::size_t k = (std::size_t(y) * std::size_t(width_) + std::size_t(x)) * 3;
  rgb_[k] = color.r;
  rgb_[k + 1] = color.g;
  rgb_[k + 2] = color.b;
}

void Canvas::fill_rect(int x0, int y0, int x1, int y1, Color color) {
  for (int y = std::max(y0, 0); y < std::min(y1, height_); ++y)
    for (int x = std::max(x0, 0); x < std::min(x1, width_); ++x) set(x, y, color);
}

void Canvas::paste(const Canvas& other, int x, int y) {
  for (int v = 0; v < other.height(); ++v)
    for (int u = 0; u < other.width(); ++u) set(x + u, y + v, other.at(u, v));
}

void Canvas::fill_disc(Vec2 centre, double radius, Color color) {
  const PixelBox box = pixels_around(std::span(&centre, 1), radius + 1.0);
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) blend(x, y, color, coverage(radius - norm(pixel_centre(x, y) - centre)));
}

void Canvas::stroke(std::span<const Vec2> line, double width, Color color, double opacity) {
  if (line.empty()) return;
  const double reach = width / 2.0 + 1.0;
  const PixelBox whole = pixels_around(line, reach);
  if (whole.x1 <= whole.x0 || whole.y1 <= whole.y0) return;
  const std::size_t columns = std::size_t(whole.x1 - whole.x0);
  // The coverage of the whole line first, blended once: joints and crossings are not drawn twice.
  std::vector<std::uint8_t> mask(columns * std::size_t(whole.y1 - whole.y0));
  for (std::size_t k = 0; k < std::max<std::size_t>(line.size() - 1, 1); ++k) {
    const Vec2 a = line[k];
    const Vec2 b = line[std::min(k + 1, line.size() - 1)];
    const Vec2 ends[] = {a, b};
    const PixelBox box = pixels_around(ends, reach);
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        const double share = coverage(width / 2.0 - distance_to_segment(pixel_centre(x, y), a, b));
        std::uint8_t& kept = mask[std::size_t(y - whole.y0) * columns + std::size_t(x - whole.x0)];
        kept = std::max(kept, static_cast<std::uint8_t>(std::lround(255.0 * share)));
      }
  }
  for (int y = whole.y0; y < whole.y1; ++y)
    for (int x = whole.x0; x < whole.x1; ++x)
      blend(x, y, color, opacity * mask[std::size_t(y - whole.y0) * columns + std::size_t(x - whole.x0)] / 255.0);
}

Canvas::PixelBox Canvas::pixels_around(std::span<const Vec2> points, double reach) const {
  Vec2 low = points.front();
  Vec2 high = points.front();
  for (const Vec2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto pixel = [](double value, int limit) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(limit)));
  };
  return {pixel(low.x - reach, width_), pixel(low.y - reach, height_), pixel(high.x + reach + 1.0, width_),
          pixel(high.y + reach + 1.0, height_)};
}

void Canvas::blend(int x, int y, Color color, double opacity) {
  if (opacity > 0.0) set(x, y, mix(at(x, y), color, opacity));
}

}  // namespace echoarc::io
