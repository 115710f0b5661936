// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/picture/stroke_font.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

#include "io/picture/glyphs.hpp"

namespace echoarc::io {
namespace {

constexpr double letter_space = 2.3;  // between letters, in units of the glyph grid
constexpr double cap_units = 10.0;
constexpr int curve_steps = 6;

const Glyph& glyph_of(char letter) {
  const auto found = std::ranges::find(glyphs, letter, &Glyph::letter);
  return found != glyphs.end() ? *found : unknown_glyph;
}

std::string_view next_word(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

double number_of(std::string_view text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::vector<Vec2> points_of(std::string_view stroke) {
  std::vector<Vec2> points;
  while (!stroke.empty()) {
    std::string_view y = next_word(stroke, ' ');
    const double x = number_of(next_word(y, ','));
    points.push_back({x, number_of(y)});
  }
  return points;
}

void append_arc(std::vector<Vec2>& curve, Vec2 from, Vec2 control, Vec2 to) {
  for (int k = 1; k <= curve_steps; ++k) {
    const double t = static_cast<double>(k) / curve_steps;
    curve.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to);
  }
}

/// The quadratic B-spline over the controls: parabolas between the middles of neighbouring controls.
std::vector<Vec2> smooth(const std::vector<Vec2>& controls, bool closed) {
  const std::size_t n = controls.size();
  if (n < 3) return controls;
  const auto control = [&](std::size_t k) { return controls[k % n]; };
  const auto middle = [&](std::size_t k) { return 0.5 * (control(k) + control(k + 1)); };
  std::vector<Vec2> curve;
  if (closed) {
    curve.push_back(middle(0));
    for (std::size_t k = 1; k <= n; ++k) append_arc(curve, curve.back(), control(k), middle(k));
    return curve;
  }
  curve.push_back(controls.front());
  for (std::size_t k = 1; k + 1 < n; ++k)
    append_arc(curve, curve.back(), control(k), k + 2 < n ? middle(k) : controls.back());
  return curve;
}

std::vector<Vec2> stroke_points(std::string_view stroke) {
  const bool open_curve = stroke.starts_with('~');
  const bool closed_curve = stroke.starts_with('o');
  if (!open_curve && !closed_curve) return points_of(stroke);
  return smooth(points_of(stroke.substr(1)), closed_curve);
}

double line_width(const TextStyle& style) {
  return style.cap_height * (style.bold ? 0.155 : 0.12);
}

}  // namespace

double text_width(std::string_view text, const TextStyle& style) {
  double units = text.empty() ? 0.0 : -letter_space;
  for (const char letter : text) units += glyph_of(letter).width + letter_space;
  return units * style.cap_height / cap_units;
}

double draw_text(Canvas& canvas, std::string_view text, Vec2 baseline_start, const TextStyle& style) {
  const double unit = style.cap_height / cap_units;
  double x = baseline_start.x;
  for (const char letter : text) {
    const Glyph& glyph = glyph_of(letter);
    for (std::string_view strokes = glyph.strokes; !strokes.empty();) {
      std::vector<Vec2> points = stroke_points(next_word(strokes, '|'));
      for (Vec2& p : points) p = {x + p.x * unit, baseline_start.y - p.y * unit};
      canvas.stroke(points, line_width(style), style.color);
    }
    x += (glyph.width + letter_space) * unit;
  }
  return text.empty() ? x : x - letter_space * unit;
}

}  // namespace echoarc::io
