// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/svg_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "studies/chart_axis.hpp"
#include "studies/svg_pen.hpp"

namespace echoarc::studies {
namespace {

// Okabe and Ito's colours, without the yellow that is hard to see on white.
constexpr std::array<std::string_view, 7> colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#000000"};
constexpr double character_px = 6.6;  // mean width of 12 px sans-serif text
constexpr double legend_row_px = 18.0;

/// Writes one chart, part by part.
class Drawing : private SvgPen {
 public:
  explicit Drawing(const Chart& chart);
  std::string take() &&;

 private:
  void fit_axes();
  void draw_axes();
  void draw_ticks();
  void draw_series(std::size_t index);
  void draw_band(const ChartSeries& series, std::string_view color);
  void draw_line(const ChartSeries& series, std::string_view color);
  void draw_marks(const ChartSeries& series, std::size_t index);
  void draw_bars(const ChartSeries& series, std::string_view color);
  void draw_whiskers(const ChartSeries& series, std::string_view color, double offset);
  void draw_legend();

  [[nodiscard]] std::string_view color_of(std::size_t index) const;
  [[nodiscard]] bool shown(double x, double y) const;
  [[nodiscard]] double x_px(double x) const { return left_ + (right_ - left_) * x_.share(x); }
  [[nodiscard]] double y_px(double y) const { return bottom_ - (bottom_ - top_) * y_.share(y); }
  [[nodiscard]] double bar_offset(const ChartSeries& series) const;
  [[nodiscard]] std::size_t bar_count() const;

  const Chart& chart_;
  AxisScale x_;
  AxisScale y_;
  double left_ = 66.0;
  double right_ = 0.0;
  double top_ = 36.0;
  double bottom_ = 0.0;
  double width_ = 0.0;
  double height_ = 0.0;
};

/// Whether a chart needs to say which series is which.
bool has_legend(const Chart& chart) {
  return chart.series.size() > 1;
}

Drawing::Drawing(const Chart& chart)
    : chart_(chart), width_(std::clamp(chart.width_px, 240, 4000)), height_(std::clamp(chart.height_px, 160, 4000)) {
  std::size_t longest = 0;
  for (const ChartSeries& series : chart.series) longest = std::max(longest, series.name.size());
  const double legend = has_legend(chart) ? std::min(40.0 + character_px * double(longest), 0.4 * width_) : 0.0;
  right_ = width_ - 18.0 - legend;
  bottom_ = height_ - 54.0;
  if (chart.title.empty()) top_ = 16.0;
  fit_axes();
}

/// Ends of the finite values, with those of the spreads.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value, bool logarithmic) {
    if (!std::isfinite(value) || (logarithmic && value <= 0.0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

void Drawing::fit_axes() {
  Extent across;
  Extent up;
  for (const ChartSeries& series : chart_.series) {
    if (series.mark == ChartMark::bar) up.add(0.0, chart_.y.logarithmic);
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
      if (!std::isfinite(series.y[k])) continue;
      across.add(series.x[k], chart_.x.logarithmic);
      up.add(series.y[k], chart_.y.logarithmic);
      if (k < series.low.size()) up.add(series.low[k], chart_.y.logarithmic);
      if (k < series.high.size()) up.add(series.high[k], chart_.y.logarithmic);
    }
  }
  y_ = scale_for(chart_.y, up.low, up.high, int((bottom_ - top_) / 55.0), true);
  if (chart_.categories.empty()) {
    x_ = scale_for(chart_.x, across.low, across.high, int((right_ - left_) / 80.0), false);
    return;
  }
  x_ = {.low = -0.5, .high = double(chart_.categories.size()) - 0.5};
  for (std::size_t k = 0; k < chart_.categories.size(); ++k) x_.ticks.push_back({double(k), chart_.categories[k]});
}

bool Drawing::shown(double x, double y) const {
  if (!std::isfinite(x) || !std::isfinite(y)) return false;
  return (!x_.logarithmic || x > 0.0) && (!y_.logarithmic || y > 0.0);
}

std::string_view Drawing::color_of(std::size_t index) const {
  const int wanted = chart_.series[index].color.value_or(int(index));
  return colors[std::size_t(std::max(wanted, 0)) % colors.size()];
}

std::size_t Drawing::bar_count() const {
  return std::size_t(std::ranges::count(chart_.series, ChartMark::bar, &ChartSeries::mark));
}

void Drawing::draw_ticks() {
  // Names that would run into each other are written aslant.
  double needed = 0.0;
  for (const Tick& tick : x_.ticks) needed += character_px * double(tick.text.size()) + 8.0;
  const bool aslant = needed > right_ - left_;
  for (const Tick& tick : y_.ticks) {
    segment(left_, y_px(tick.value), right_, y_px(tick.value), "stroke=\"#e4e4e4\"");
    text(left_ - 8.0, y_px(tick.value) + 4.0, "end", tick.text);
  }
  for (const Tick& tick : x_.ticks) {
    const double x = x_px(tick.value);
    segment(x, bottom_, x, bottom_ + 5.0, "stroke=\"#444\"");
    const std::string turn = "transform=\"rotate(-30 " + px(x) + " " + px(bottom_ + 16.0) + ")\"";
    text(x, bottom_ + 18.0, aslant ? "end" : "middle", tick.text, aslant ? turn : "");
  }
}

void Drawing::draw_axes() {
  draw_ticks();
  segment(left_, bottom_, right_, bottom_, "stroke=\"#444\"");
  segment(left_, top_, left_, bottom_, "stroke=\"#444\"");
  if (!chart_.title.empty()) text(left_, 22.0, "start", chart_.title, "font-weight=\"bold\" font-size=\"14\"");
  text(0.5 * (left_ + right_), height_ - 12.0, "middle", chart_.x.title);
  const double middle = 0.5 * (top_ + bottom_);
  text(16.0, middle, "middle", chart_.y.title, "transform=\"rotate(-90 16 " + px(middle) + ")\"");
}

void Drawing::draw_band(const ChartSeries& series, std::string_view color) {
  std::string there;
  std::string back;
  const std::size_t count = std::min({series.x.size(), series.low.size(), series.high.size()});
  for (std::size_t k = 0; k < count; ++k) {
    if (!shown(series.x[k], series.low[k]) || !shown(series.x[k], series.high[k])) continue;
    there += px(x_px(series.x[k])) + "," + px(y_px(series.high[k])) + " ";
    back.insert(0, px(x_px(series.x[k])) + "," + px(y_px(series.low[k])) + " ");
  }
  if (there.empty()) return;
  out += "<polygon points=\"" + there + back + "\" fill=\"" + std::string(color) + R"(" fill-opacity="0.15"/>)" + "\n";
}

void Drawing::draw_line(const ChartSeries& series, std::string_view color) {
  std::string path;
  bool pen_down = false;
  for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
    const bool here = shown(series.x[k], series.y[k]);
    if (here) path += (pen_down ? "L" : "M") + px(x_px(series.x[k])) + " " + px(y_px(series.y[k])) + " ";
    pen_down = here;
  }
  if (path.empty()) return;
  out += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + std::string(color) + "\" stroke-width=\"2\"" +
         (series.dashed ? " stroke-dasharray=\"7 4\"" : "") + "/>\n";
}

void Drawing::draw_marks(const ChartSeries& series, std::size_t index) {
  for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k)
    if (shown(series.x[k], series.y[k])) marker(x_px(series.x[k]), y_px(series.y[k]), index, color_of(index));
}

/// Where the bars of this series stand, in px from their place; bars of all series share 80 % of the room.
double Drawing::bar_offset(const ChartSeries& series) const {
  std::size_t before = 0;
  for (const ChartSeries& other : chart_.series) {
    if (&other == &series) break;
    before += other.mark == ChartMark::bar ? 1 : 0;
  }
  const std::size_t places = std::max({chart_.categories.size(), series.x.size(), std::size_t{1}});
  const double room = 0.8 * (right_ - left_) / double(places);
  return room * ((double(before) + 0.5) / double(bar_count()) - 0.5);
}

void Drawing::draw_bars(const ChartSeries& series, std::string_view color) {
  const std::size_t places = std::max({chart_.categories.size(), series.x.size(), std::size_t{1}});
  const double width = 0.72 * (right_ - left_) / double(places) / double(bar_count());
  const double ground = y_px(y_.logarithmic ? y_.low : std::clamp(0.0, y_.low, y_.high));
  for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
    if (!shown(series.x[k], series.y[k])) continue;
    const double top = std::min(y_px(series.y[k]), ground);
    const double x = x_px(series.x[k]) + bar_offset(series) - 0.5 * width;
    rectangle(x, top, width, std::abs(y_px(series.y[k]) - ground), color);
  }
  draw_whiskers(series, "#333", bar_offset(series));
}

void Drawing::draw_whiskers(const ChartSeries& series, std::string_view color, double offset) {
  const std::string style = "stroke=\"" + std::string(color) + "\"";
  const std::size_t count = std::min({series.x.size(), series.low.size(), series.high.size()});
  for (std::size_t k = 0; k < count; ++k) {
    if (!shown(series.x[k], series.low[k]) || !shown(series.x[k], series.high[k])) continue;
    const double x = x_px(series.x[k]) + offset;
    segment(x, y_px(series.low[k]), x, y_px(series.high[k]), style);
    for (const double end : {series.low[k], series.high[k]}) segment(x - 3.0, y_px(end), x + 3.0, y_px(end), style);
  }
}

void Drawing::draw_series(std::size_t index) {
  const ChartSeries& series = chart_.series[index];
  const std::string_view color = color_of(index);
  if (series.mark == ChartMark::bar) return draw_bars(series, color);
  if (series.mark == ChartMark::scatter)
    draw_whiskers(series, color, 0.0);
  else
    draw_band(series, color);
  if (series.mark != ChartMark::scatter) draw_line(series, color);
  if (series.mark != ChartMark::line) draw_marks(series, index);
}

void Drawing::draw_legend() {
  for (std::size_t k = 0; k < chart_.series.size(); ++k) {
    const ChartSeries& series = chart_.series[k];
    const double x = right_ + 14.0;
    const double y = top_ + 8.0 + legend_row_px * double(k);
    const std::string color(color_of(k));
    const std::string dash = series.dashed ? R"( stroke-dasharray="7 4")" : "";
    if (series.mark == ChartMark::bar)
      rectangle(x, y - 5.0, 18.0, 10.0, color);
    else if (series.mark != ChartMark::scatter)
      segment(x, y, x + 18.0, y, std::string("stroke=\"").append(color).append("\" stroke-width=\"2\"").append(dash));
    if (series.mark == ChartMark::scatter || series.mark == ChartMark::both) marker(x + 9.0, y, k, color);
    text(x + 24.0, y + 4.0, "start", series.name);
  }
}

std::string Drawing::take() && {
  const std::string size = px(width_) + "\" height=\"" + px(height_);
  out = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 )" + px(width_) + " " + px(height_) + "\" width=\"" +
        size + R"(" font-family="sans-serif" font-size="12" fill="#222" role="img">)" + "\n";
  out += "<title>" + escaped(chart_.title) + "</title>\n";
  out += R"(<rect width="100%" height="100%" fill="#fff"/>)" + std::string("\n");
  draw_axes();
  for (std::size_t k = 0; k < chart_.series.size(); ++k) draw_series(k);
  const bool empty = std::ranges::all_of(chart_.series, [](const ChartSeries& series) {
    return std::ranges::none_of(series.y, [](double y) { return std::isfinite(y); });
  });
  if (empty) text(0.5 * (left_ + right_), 0.5 * (top_ + bottom_), "middle", "no values");
  if (has_legend(chart_)) draw_legend();
  return std::move(out) + "</svg>\n";
}

}  // namespace

std::string svg(const Chart& chart) {
  return Drawing(chart).take();
}

}  // namespace echoarc::studies
