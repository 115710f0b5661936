// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

#include "io/picture/canvas.hpp"

namespace echoarc::io {

/// A font of lines, drawn for this project, for the few words on a picture. ASCII; anything else becomes a small box.
struct TextStyle {
  double cap_height = 11.0;  ///< of a capital letter, pixels
  Color color;
  bool bold = false;
};

/// Width of the text in pixels.
[[nodiscard]] double text_width(std::string_view text, const TextStyle& style);
/// Draws from `baseline_start` to the right; returns where the text ends.
double draw_text(Canvas& canvas, std::string_view text, Vec2 baseline_start, const TextStyle& style);

}  // namespace echoarc::io
