// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace echoarc::studies {

/// Text that is safe between tags and inside attributes; control characters are dropped.
[[nodiscard]] std::string escaped(std::string_view text);
/// A coordinate, in tenths of a pixel.
[[nodiscard]] std::string px(double value);

/// Appends SVG elements to a text. Coordinates in pixels from the upper left corner.
class SvgPen {
 public:
  /// `anchor`: start, middle or end; `more`: further attributes.
  void text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more = "");
  void segment(double x1, double y1, double x2, double y2, std::string_view style);
  /// Disc, square or triangle, by the number of the shape.
  void marker(double x, double y, std::size_t shape, std::string_view color);
  void rectangle(double x, double y, double width, double height, std::string_view color);

 protected:
  std::string out;
};

}  // namespace echoarc::studies
