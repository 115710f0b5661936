// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/picture/page.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "io/picture/legend.hpp"
#include "io/picture/map_layer.hpp"
#include "io/picture/palette.hpp"
#include "io/picture/stroke_font.hpp"

namespace echoarc::io {
namespace {

constexpr int margin = 28;
constexpr int narrowest = 420;  // room for the legend beside a tall, thin map
constexpr int title_height = 34;
constexpr int footer_gap = 20;
constexpr TextStyle title_style = {.cap_height = 15.0, .color = palette::ink, .bold = true};

std::string length_text(double metres) {
  return metres >= 1000.0 ? fmt::format("{} km", metres / 1000.0) : fmt::format("{} m", metres);
}

/// The title, shortened so that it fits.
std::string fitting(std::string title, double width) {
  if (text_width(title, title_style) <= width) return title;
  while (!title.empty() && text_width(title + "...", title_style) > width) title.pop_back();
  return title + "...";
}

/// A bar with upright ends and its length beside it; returns its width in pixels, text included.
double draw_scale_bar(Canvas& canvas, Vec2 baseline_start, const View& view) {
  const double metres = scale_bar_m(view, scale_bar_share);
  const double length = metres * view.pixels_per_m;
  const Vec2 left = baseline_start;
  const Vec2 right = left + Vec2{length, 0.0};
  const Vec2 up = {0.0, -8.0};
  const Vec2 bar[] = {left + up, left, right, right + up};
  canvas.stroke(bar, 2.0, palette::ink);
  return draw_text(canvas, length_text(metres), right + Vec2{10.0, 0.0}, legend_style) - left.x;
}

void draw_frame(Canvas& canvas, int x, int y, const Canvas& map) {
  canvas.fill_rect(x - 1, y - 1, x + map.width() + 1, y + map.height() + 1, palette::frame);
  canvas.paste(map, x, y);
}

double scale_bar_width(const View& view) {
  const double metres = scale_bar_m(view, scale_bar_share);
  return metres * view.pixels_per_m + 10.0 + text_width(length_text(metres), legend_style);
}

}  // namespace

Canvas draw_page(const PictureContent& content, const View& view) {
  const Canvas map = draw_map(content, view);
  const int inner_width = std::max(view.width, narrowest);
  const std::vector<LegendItem> items = legend_of(content);
  const double legend_start = scale_bar_width(view) + 36.0;
  const std::vector<Vec2> places = place_legend(items, legend_start, inner_width);
  const double legend_height = places.empty() ? 0.0 : places.back().y;

  const int top = margin + (content.title.empty() ? 0 : title_height);
  const int footer = top + view.height + footer_gap;
  const int height = footer + 12 + static_cast<int>(std::ceil(legend_height)) + margin;
  Canvas page(inner_width + 2 * margin, height, palette::paper);

  draw_text(page, fitting(content.title, inner_width), {margin, margin + 15.0}, title_style);
  draw_frame(page, margin + (inner_width - view.width) / 2, top, map);
  const Vec2 baseline = {margin, footer + 12.0};
  draw_scale_bar(page, baseline, view);
  for (std::size_t k = 0; k < items.size(); ++k) draw_legend_item(page, items[k], baseline + places[k]);
  return page;
}

}  // namespace echoarc::io
