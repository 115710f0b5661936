// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/io/picture.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/palette.hpp"
#include "io/picture/stroke_font.hpp"

namespace echoarc::io {

inline constexpr TextStyle legend_style = {.cap_height = 11.0, .color = palette::quiet_ink};

enum class LegendSign { cell, point, feature, surface, mover, graph, echo, path, start, end };

/// One explained sign.
struct LegendItem {
  LegendSign sign = LegendSign::cell;
  Color color;                                ///< of a cell
  PointLabel label = PointLabel::centerline;  ///< of a point
  FeatureKind kind = FeatureKind::line;       ///< of a feature
  EchoCause cause = EchoCause::unknown;       ///< of an echo
  std::string text;
};

/// What the picture shows and nothing else.
[[nodiscard]] std::vector<LegendItem> legend_of(const PictureContent& content);

/// Left ends of the items' baselines, relative to the first line's start: side by side from `first_line_start` on, in
/// further lines from 0 on, no wider than `width`.
[[nodiscard]] std::vector<Vec2> place_legend(const std::vector<LegendItem>& items, double first_line_start,
                                             double width);
void draw_legend_item(Canvas& canvas, const LegendItem& item, Vec2 baseline_start);

}  // namespace echoarc::io
