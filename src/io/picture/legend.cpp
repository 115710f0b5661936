// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/picture/legend.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/picture/map_layer.hpp"

namespace echoarc::io {
namespace {

constexpr double sign_width = 16.0;
constexpr double path_sign_width = 26.0;
constexpr double text_gap = 9.0;
constexpr double item_gap = 26.0;
constexpr double line_height = 28.0;

double width_of_sign(LegendSign sign) {
  const bool line = sign == LegendSign::path || sign == LegendSign::feature || sign == LegendSign::surface ||
                    sign == LegendSign::mover || sign == LegendSign::graph;
  return line ? path_sign_width : sign_width;
}

double width_of(const LegendItem& item) {
  return width_of_sign(item.sign) + text_gap + text_width(item.text, legend_style);
}

bool shows_state(const PictureContent& content, CellState state) {
  return content.states != nullptr &&
         std::ranges::find(content.states->values(), state) != content.states->values().end();
}

void add_cells(std::vector<LegendItem>& items, const PictureContent& content) {
  if (content.states == nullptr) return;
  if (shows_state(content, CellState::free))
    items.push_back({.sign = LegendSign::cell, .color = palette::free, .text = "free"});
  if (shows_state(content, CellState::occupied))
    items.push_back({.sign = LegendSign::cell, .color = palette::occupied, .text = "occupied"});
  items.push_back({.sign = LegendSign::cell, .color = palette::unknown, .text = "unknown"});
}

void add_points(std::vector<LegendItem>& items, const PictureContent& content) {
  constexpr std::array<std::string_view, point_label_count> texts = {"centerline points",
                                                                     "map points",
                                                                     "carved points",
                                                                     "transversal medians",
                                                                     "edge points",
                                                                     "triangulated points",
                                                                     "walls",
                                                                     "corners, edges, poles",
                                                                     "links",
                                                                     "reflecting zones",
                                                                     "weak points"};
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const auto label = static_cast<PointLabel>(k);
    if (std::ranges::find(content.points, label, &MapPoint::label) != content.points.end())
      items.push_back({.sign = LegendSign::point, .label = label, .text = std::string(texts[k])});
  }
}

void add_features(std::vector<LegendItem>& items, const PictureContent& content) {
  constexpr std::array<std::string_view, feature_kind_count> texts = {"tangents", "cluster lines", "walls",
                                                                      "corners",  "edges",         "regions"};
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const auto kind = static_cast<FeatureKind>(k);
    if (std::ranges::find(content.features, kind, &Feature::kind) != content.features.end())
      items.push_back({.sign = LegendSign::feature, .kind = kind, .text = std::string(texts[k])});
  }
}

/// "echoes: wall", then the other causes.
void add_echoes(std::vector<LegendItem>& items, const PictureContent& content) {
  bool first = true;
  for (std::size_t k = 0; k < echo_cause_names.size(); ++k) {
    const auto cause = static_cast<EchoCause>(k);
    if (std::ranges::find(content.echoes, cause, &EchoMark::cause) == content.echoes.end()) continue;
    std::string text = (first ? "echoes: " : "") + std::string(name(cause));
    std::ranges::replace(text, '_', ' ');
    items.push_back({.sign = LegendSign::echo, .cause = cause, .text = std::move(text)});
    first = false;
  }
}

void draw_stroke_sign(Canvas& canvas, Vec2 middle, double width, Color color, double opacity = 1.0) {
  const Vec2 half = {path_sign_width / 2.0, 0.0};
  const Vec2 line[] = {middle - half, middle + half};
  canvas.stroke(line, width, color, opacity);
}

}  // namespace

std::vector<LegendItem> legend_of(const PictureContent& content) {
  std::vector<LegendItem> items;
  add_cells(items, content);
  add_points(items, content);
  add_features(items, content);
  if (!content.surfaces.empty()) items.push_back({.sign = LegendSign::surface, .text = "surfaces"});
  if (!content.movers.empty()) items.push_back({.sign = LegendSign::mover, .text = "moving"});
  if (!content.graph.empty()) items.push_back({.sign = LegendSign::graph, .text = "graph"});
  add_echoes(items, content);
  if (!content.path.empty()) {
    items.push_back({.sign = LegendSign::path, .text = "path"});
    items.push_back({.sign = LegendSign::start, .text = "start"});
    items.push_back({.sign = LegendSign::end, .text = "end"});
  }
  return items;
}

std::vector<Vec2> place_legend(const std::vector<LegendItem>& items, double first_line_start, double width) {
  std::vector<Vec2> places;
  Vec2 next = {first_line_start, 0.0};
  for (const LegendItem& item : items) {
    const bool at_line_start = next.x == 0.0;
    if (next.x + width_of(item) > width && !at_line_start) next = {0.0, next.y + line_height};
    places.push_back(next);
    next.x += width_of(item) + item_gap;
  }
  return places;
}

void draw_legend_item(Canvas& canvas, const LegendItem& item, Vec2 baseline_start) {
  const Vec2 middle = baseline_start + Vec2{width_of_sign(item.sign) / 2.0, -legend_style.cap_height / 2.0};
  switch (item.sign) {
    case LegendSign::cell: {
      const int x = static_cast<int>(middle.x) - 7;
      const int y = static_cast<int>(middle.y) - 7;
      canvas.fill_rect(x, y, x + 15, y + 15, palette::frame);
      canvas.fill_rect(x + 1, y + 1, x + 14, y + 14, item.color);
      break;
    }
    case LegendSign::point: draw_point_mark(canvas, middle, item.label, 4.0); break;
    case LegendSign::path: draw_stroke_sign(canvas, middle, path_width, palette::path, path_opacity); break;
    case LegendSign::surface: draw_stroke_sign(canvas, middle, surface_width, palette::surface); break;
    case LegendSign::mover: draw_stroke_sign(canvas, middle, mover_width, palette::mover); break;
    case LegendSign::graph: draw_stroke_sign(canvas, middle, graph_width, palette::graph); break;
    case LegendSign::echo: draw_echo_mark(canvas, middle, item.cause, 4.0); break;
    case LegendSign::feature: {
      const bool line =
          item.kind == FeatureKind::tangent || item.kind == FeatureKind::line || item.kind == FeatureKind::wall;
      const Vec2 half = {line ? path_sign_width / 2.0 : 0.0, 0.0};
      draw_feature_mark(canvas, middle - half, middle + half, item.kind);
      break;
    }
    case LegendSign::start: draw_start_mark(canvas, middle); break;
    case LegendSign::end: draw_end_mark(canvas, middle); break;
  }
  draw_text(canvas, item.text, baseline_start + Vec2{width_of_sign(item.sign) + text_gap, 0.0}, legend_style);
}

}  // namespace echoarc::io
