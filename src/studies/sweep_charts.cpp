// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/sweep_charts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace echoarc::studies {
namespace {

bool is_number(const OptionValue& value) {
  return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
}

double number_of(const OptionValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return double(std::get<std::int64_t>(value));
}

/// Rows that differ in the values of one axis alone.
struct Line {
  std::string name;
  std::vector<std::size_t> rows;
};

/// What runs along the x axis: an axis of the sweep, or its methods.
class Abscissa {
 public:
  explicit Abscissa(const SweepResult& sweep) : sweep_(sweep) {
    const auto varies = [](const SweepAxis& axis) { return axis.values.size() > 1; };
    const auto found = std::ranges::find_if(sweep.axes, varies);
    if (found != sweep.axes.end()) axis_ = std::size_t(found - sweep.axes.begin());
    numeric_ = axis_ && std::ranges::all_of(found->values, is_number);
  }

  void prepare(Chart& chart) const {
    if (!axis_) {
      for (const SweepRow& row : sweep_.rows) chart.categories.push_back(row.method);
      return;
    }
    const SweepAxis& axis = sweep_.axes[*axis_];
    chart.x.title = axis.key() + (axis.unit.empty() ? "" : " (" + axis.unit + ")");
    if (!numeric_)
      for (const OptionValue& value : axis.values) chart.categories.push_back(to_text(value));
  }

  [[nodiscard]] double place_of(std::size_t row, std::size_t index) const {
    return numeric_ ? number_of(sweep_.rows[row].values[*axis_]) : double(index);
  }
  [[nodiscard]] ChartMark mark() const { return numeric_ ? ChartMark::both : ChartMark::bar; }

  [[nodiscard]] std::vector<Line> lines() const {
    std::vector<Line> lines;
    for (std::size_t row = 0; row < sweep_.rows.size(); ++row) {
      const std::string name = name_of(sweep_.rows[row]);
      auto line = std::ranges::find(lines, name, &Line::name);
      if (line == lines.end()) {
        if (lines.size() == max_chart_lines) continue;
        line = lines.insert(lines.end(), {.name = name, .rows = {}});
      }
      line->rows.push_back(row);
    }
    return lines;
  }

 private:
  /// The method and the values of all other axes that vary.
  [[nodiscard]] std::string name_of(const SweepRow& row) const {
    std::string name = axis_ ? row.method : "";
    for (std::size_t k = 0; k < sweep_.axes.size(); ++k)
      if (k != axis_ && sweep_.axes[k].values.size() > 1)
        name += ", " + sweep_.axes[k].option + " " + to_text(row.values[k]);
    return name;
  }

  const SweepResult& sweep_;
  std::optional<std::size_t> axis_;
  bool numeric_ = false;
};

const SweepMetric& metric_named(std::string_view name) {
  return *std::ranges::find(sweep_metrics(), name, &SweepMetric::name);
}

ChartSeries series_of(const SweepResult& sweep, const Abscissa& abscissa, const Line& line, const SweepMetric& metric,
                      double scale) {
  ChartSeries series{.name = line.name, .mark = abscissa.mark()};
  for (std::size_t k = 0; k < line.rows.size(); ++k) {
    const Spread spread = sweep.rows[line.rows[k]].spread(metric);
    series.x.push_back(abscissa.place_of(line.rows[k], k));
    series.y.push_back(scale * spread.mean);
    if (sweep.seeds.size() < 2) continue;
    series.low.push_back(scale * spread.min);
    series.high.push_back(scale * spread.max);
  }
  return series;
}

bool has_value(const ChartSeries& series) {
  return std::ranges::any_of(series.y, [](double y) { return std::isfinite(y); });
}

void add(std::vector<NamedChart>& charts, NamedChart chart, std::vector<ChartSeries> series) {
  std::erase_if(series, [](const ChartSeries& one) { return !has_value(one); });
  if (series.empty()) return;
  chart.chart.series = std::move(series);
  charts.push_back(std::move(chart));
}

/// Several shares of one line, or the last one of several lines.
std::vector<ChartSeries> share_series(const SweepResult& sweep, const Abscissa& abscissa,
                                      const std::vector<Line>& lines, std::span<const std::string_view> names) {
  std::vector<ChartSeries> series;
  for (const Line& line : lines) {
    if (lines.size() > 1) {
      series.push_back(series_of(sweep, abscissa, line, metric_named(names.back()), 1.0));
      continue;
    }
    for (const std::string_view name : names) {
      series.push_back(series_of(sweep, abscissa, line, metric_named(name), 1.0));
      series.back().name = std::string(metric_named(name).title);
    }
  }
  return series;
}

}  // namespace

std::vector<NamedChart> sweep_charts(const SweepResult& sweep) {
  const Abscissa abscissa(sweep);
  const std::vector<Line> lines = abscissa.lines();
  Chart frame;
  abscissa.prepare(frame);
  std::vector<NamedChart> charts;
  const auto chart_of = [&](std::string name, std::string title, std::string y) {
    NamedChart chart{std::move(name), frame};
    chart.chart.title = std::move(title);
    chart.chart.y.title = std::move(y);
    return chart;
  };
  std::vector<ChartSeries> errors;
  for (const Line& line : lines) errors.push_back(series_of(sweep, abscissa, line, metric_named("mae"), 100.0));
  NamedChart mae = chart_of("mae", "Mean absolute error of occupied cells", "MAE (cm)");
  mae.chart.y.low = 0.0;
  add(charts, std::move(mae), std::move(errors));
  const bool single = lines.size() == 1;
  constexpr std::array<std::string_view, 3> ratios{"cdr_full", "cdr_empty", "cdr_overall"};
  add(charts, chart_of("cdr", "Correct detection ratio", single ? "share" : "CDR_O (share)"),
      share_series(sweep, abscissa, lines, ratios));
  constexpr std::array<std::string_view, 2> shares{"within_10cm", "coverage"};
  add(charts, chart_of("coverage", "Coverage of the reference", single ? "share" : "coverage (share)"),
      share_series(sweep, abscissa, lines, shares));
  return charts;
}

}  // namespace echoarc::studies
