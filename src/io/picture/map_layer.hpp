// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/io/picture.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/view.hpp"

namespace echoarc::io {

/// The map itself: cells, marks every scale-bar length, surfaces, movers, path, points, features, echoes.
[[nodiscard]] Canvas draw_map(const PictureContent& content, const View& view);

/// The mark of a point; the legend shows the same.
void draw_point_mark(Canvas& canvas, Vec2 pixel, PointLabel label, double radius);
/// The mark of a feature: a stroke, a ring (corner, region) or a disc (edge).
void draw_feature_mark(Canvas& canvas, Vec2 begin, Vec2 end, FeatureKind kind);
void draw_echo_mark(Canvas& canvas, Vec2 pixel, EchoCause cause, double radius);
/// Where the robot started (a ring) and where it is at the end (a disc).
void draw_start_mark(Canvas& canvas, Vec2 pixel);
void draw_end_mark(Canvas& canvas, Vec2 pixel);

inline constexpr double path_width = 2.2;  ///< pixels
inline constexpr double path_opacity = 0.8;
inline constexpr double surface_width = 3.0;
inline constexpr double mover_width = 1.6;
inline constexpr double graph_width = 2.4;

}  // namespace echoarc::io
