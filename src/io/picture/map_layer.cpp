// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/picture/map_layer.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/picture/palette.hpp"

namespace echoarc::io {
namespace {

/// What a block of cells looks like as one pixel: an occupied cell shows, however small; then a free one.
Color color_of(const PictureContent& content, const CellBox& block) {
  CellState shown = CellState::unknown;
  float probability = 0.0F;
  for (std::int32_t j = block.j_begin; j < block.j_end; ++j)
    for (std::int32_t i = block.i_begin; i < block.i_end; ++i) {
      const CellState state = content.states->at({i, j});
      if (state == CellState::unknown) continue;
      shown = shown == CellState::occupied ? shown : state;
      if (content.probability != nullptr) probability = std::max(probability, content.probability->at({i, j}));
    }
  if (shown == CellState::unknown) return palette::unknown;
  if (content.probability != nullptr)
    return mix(palette::free, palette::occupied, std::clamp(static_cast<double>(probability), 0.0, 1.0));
  return shown == CellState::occupied ? palette::occupied : palette::free;
}

CellBox intersect(const CellBox& a, const CellBox& b) {
  return {std::max(a.i_begin, b.i_begin), std::max(a.j_begin, b.j_begin), std::min(a.i_end, b.i_end),
          std::min(a.j_end, b.j_end)};
}

void draw_cells(Canvas& canvas, const PictureContent& content, const View& view) {
  const int enlarge = std::max(view.pixels_per_cell, 1);
  const int step = view.cells_per_pixel;
  for (int y = 0; y < view.height; y += enlarge)
    for (int x = 0; x < view.width; x += enlarge) {
      const std::int32_t i = view.cells.i_begin + x / enlarge * step;
      const std::int32_t j = view.cells.j_begin + (view.height - enlarge - y) / enlarge * step;
      const CellBox block = intersect({i, j, i + step, j + step}, content.states->box());
      if (!block.empty()) canvas.fill_rect(x, y, x + enlarge, y + enlarge, color_of(content, block));
    }
}

/// Small crosses at whole multiples of the scale bar's length: distances can be read anywhere on the map.
void draw_grid_marks(Canvas& canvas, const View& view) {
  constexpr int arm = 4;
  const double spacing_m = scale_bar_m(view, scale_bar_share);
  const Vec2 high = view.low + Vec2{view.width / view.pixels_per_m, view.height / view.pixels_per_m};
  const double first_x = std::ceil(view.low.x / spacing_m);
  const double first_y = std::ceil(view.low.y / spacing_m);
  for (double n = first_y; n * spacing_m < high.y; ++n)
    for (double m = first_x; m * spacing_m < high.x; ++m) {
      const Vec2 pixel = view.pixel({m * spacing_m, n * spacing_m});
      const int x = static_cast<int>(pixel.x);
      const int y = static_cast<int>(pixel.y);
      canvas.fill_rect(x - arm, y, x + arm + 1, y + 1, palette::grid_mark);
      canvas.fill_rect(x, y - arm, x + 1, y + arm + 1, palette::grid_mark);
    }
}

void draw_path(Canvas& canvas, std::span<const Vec2> path, const View& view) {
  std::vector<Vec2> line;
  for (const Vec2 position : path)
    if (is_finite(position)) line.push_back(view.pixel(position));
  if (line.empty()) return;
  canvas.stroke(line, path_width, palette::path, path_opacity);
  draw_start_mark(canvas, line.front());
  draw_end_mark(canvas, line.back());
}

/// Whether points of this label stand for more than the place of an echo.
bool is_concluded(PointLabel label) {
  return label == PointLabel::link || label == PointLabel::zone || label == PointLabel::weak;
}

void draw_points(Canvas& canvas, std::span<const MapPoint> points, const View& view) {
  constexpr double radius_m = 0.03;
  const double radius = std::clamp(radius_m * view.pixels_per_m, 2.4, 4.0);
  // What was heard lies on top of what was concluded from it.
  for (const bool concluded : {true, false})
    for (const MapPoint& point : points)
      if (is_finite(point.position) && is_concluded(point.label) == concluded)
        draw_point_mark(canvas, view.pixel(point.position), point.label, radius);
}

void draw_lines(Canvas& canvas, std::span<const std::vector<Vec2>> lines, const View& view, double width, Color color) {
  for (const std::vector<Vec2>& line : lines) {
    std::vector<Vec2> pixels;
    for (const Vec2 point : line)
      if (is_finite(point)) pixels.push_back(view.pixel(point));
    canvas.stroke(pixels, width, color);
  }
}

/// Cause by cause in the order of the enumerators, so that what is rare and misleading lies on top.
void draw_echoes(Canvas& canvas, std::span<const EchoMark> echoes, const View& view) {
  constexpr double radius_m = 0.02;
  const double radius = std::clamp(radius_m * view.pixels_per_m, 1.8, 3.6);
  for (std::size_t cause = 0; cause < echo_cause_names.size(); ++cause)
    for (const EchoMark& echo : echoes)
      if (echo.cause == static_cast<EchoCause>(cause) && is_finite(echo.position))
        draw_echo_mark(canvas, view.pixel(echo.position), echo.cause, radius);
}

void draw_nodes(Canvas& canvas, std::span<const Vec2> nodes, const View& view) {
  constexpr double radius = 4.5;
  for (const Vec2 node : nodes)
    if (is_finite(node)) canvas.fill_disc(view.pixel(node), radius, palette::graph);
}

void draw_features(Canvas& canvas, std::span<const Feature> features, const View& view) {
  for (const Feature& feature : features)
    if (is_finite(feature.begin) && is_finite(feature.end))
      draw_feature_mark(canvas, view.pixel(feature.begin), view.pixel(feature.end), feature.kind);
}

}  // namespace

Canvas draw_map(const PictureContent& content, const View& view) {
  Canvas canvas(view.width, view.height, content.states != nullptr ? palette::unknown : palette::free);
  if (!view.cells.empty()) draw_cells(canvas, content, view);
  draw_grid_marks(canvas, view);
  draw_lines(canvas, content.movers, view, mover_width, palette::mover);
  draw_echoes(canvas, content.echoes, view);
  draw_lines(canvas, content.surfaces, view, surface_width, palette::surface);
  draw_path(canvas, content.path, view);
  draw_lines(canvas, content.graph, view, graph_width, palette::graph);
  draw_nodes(canvas, content.nodes, view);
  draw_points(canvas, content.points, view);
  draw_features(canvas, content.features, view);
  return canvas;
}

void draw_point_mark(Canvas& canvas, Vec2 pixel, PointLabel label, double radius) {
  const Color color = palette::of(label);
  if (label != PointLabel::centerline) return canvas.fill_disc(pixel, radius, color);
  const Vec2 down[] = {pixel + Vec2{-radius, -radius}, pixel + Vec2{radius, radius}};
  const Vec2 up[] = {pixel + Vec2{-radius, radius}, pixel + Vec2{radius, -radius}};
  canvas.stroke(down, 1.6, color);
  canvas.stroke(up, 1.6, color);
}

void draw_feature_mark(Canvas& canvas, Vec2 begin, Vec2 end, FeatureKind kind) {
  const Color color = palette::of(kind);
  if (begin != end) {
    const Vec2 line[] = {begin, end};
    canvas.stroke(line, 3.4, color, 0.85);
    return;
  }
  canvas.fill_disc(begin, 6.5, color);
  canvas.fill_disc(begin, kind == FeatureKind::edge ? 0.0 : 3.5, palette::free);
}

void draw_echo_mark(Canvas& canvas, Vec2 pixel, EchoCause cause, double radius) {
  canvas.fill_disc(pixel, radius, palette::of(cause));
}

void draw_start_mark(Canvas& canvas, Vec2 pixel) {
  canvas.fill_disc(pixel, 7.0, palette::path);
  canvas.fill_disc(pixel, 4.6, palette::free);
}

void draw_end_mark(Canvas& canvas, Vec2 pixel) {
  canvas.fill_disc(pixel, 8.0, palette::free);
  canvas.fill_disc(pixel, 6.2, palette::path);
}

}  // namespace echoarc::io
