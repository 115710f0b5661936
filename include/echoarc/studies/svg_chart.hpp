// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace echoarc::studies {

/// How a series is drawn.
enum class ChartMark : std::uint8_t {
  line,     ///< straight from value to value
  scatter,  ///< a marker at every value
  both,     ///< line and markers
  bar,      ///< upright bars from zero, side by side with those of the other bar series
};

/// Values over places. `x` and `y` of equal length; a `y` that is not finite is a gap.
struct ChartSeries {
  std::string name;  ///< for the legend
  std::vector<double> x;
  std::vector<double> y;
  /// Ends of the spread around each `y`, drawn as a band behind lines and as whiskers elsewhere; both empty: none.
  std::vector<double> low;
  std::vector<double> high;
  ChartMark mark = ChartMark::line;
  bool dashed = false;
  /// Series of one number share a colour (counted from 0); none: the next free one.
  std::optional<int> color;
};

struct ChartAxis {
  std::string title;  ///< with its unit: "radius (m)"
  std::optional<double> low;
  std::optional<double> high;  ///< ends of the axis; none: from the values
  bool logarithmic = false;    ///< values that are not positive are gaps
};

/// A plain picture of a few series over one pair of axes.
struct Chart {
  std::string title;
  ChartAxis x;
  ChartAxis y;
  /// Names of the places 0, 1, ... of the x axis, which then has no ticks of its own.
  std::vector<std::string> categories;
  std::vector<ChartSeries> series;
  int width_px = 720;
  int height_px = 400;
};

/// The chart as one `<svg>` element that stands alone, as a file or inside HTML: no scripts, no fonts, no ids. Colours
/// are those of Okabe and Ito, which everybody can tell apart; markers and dashes differ, too. Text is escaped. A chart
/// without any finite value has axes and says so.
[[nodiscard]] std::string svg(const Chart& chart);

}  // namespace echoarc::studies
