// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/sweep_output.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/text_file.hpp"
#include "echoarc/io/run_report.hpp"
#include "echoarc/studies/sweep_charts.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;
using studies::Spread;
using studies::SweepAxis;
using studies::SweepChoice;
using studies::SweepMetric;
using studies::SweepResult;
using studies::SweepRow;

/// How people read a score: shares in per cent, lengths in cm, times in us.
std::string shown(const SweepMetric& metric, const Spread& spread, bool several) {
  if (std::isnan(spread.mean)) return "-";
  if (metric.unit == "share") return fmt::format("{:.3f}", spread.mean);
  if (metric.unit == "s") return fmt::format("{:.1f}", 1e6 * spread.mean);
  if (metric.unit != "m") return fmt::format("{:.0f}", spread.mean);
  const std::string deviation = several ? fmt::format(" +-{:.2f}", 100.0 * spread.deviation) : "";
  return fmt::format("{:.2f}{}", 100.0 * spread.mean, deviation);
}

std::string heading(const SweepMetric& metric) {
  const std::string_view unit = metric.unit == "m" ? " [cm]" : metric.unit == "s" ? " [us]" : "";
  return std::string(metric.title) + std::string(unit);
}

/// Scores that at least one row has.
std::vector<const SweepMetric*> measured(const SweepResult& result) {
  std::vector<const SweepMetric*> metrics;
  for (const SweepMetric& metric : studies::sweep_metrics()) {
    const auto has = [&](const SweepRow& row) { return row.spread(metric).values > 0; };
    if (std::ranges::any_of(result.rows, has)) metrics.push_back(&metric);
  }
  return metrics;
}

/// "*" where the parameter rule chooses, "o" where it would as well.
std::string mark_of(const SweepResult& result, std::size_t row) {
  for (const SweepChoice& choice : result.choices) {
    if (choice.best == row) return "*";
    if (std::ranges::find(choice.candidates, row) != choice.candidates.end()) return "o";
  }
  return "";
}

/// "sonar.threshold_db = 30, threshold = 4": what is the same in all rows.
std::string fixed_options(const SweepResult& result) {
  std::string text;
  for (const SweepAxis& axis : result.axes)
    if (axis.values.size() == 1)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", axis.key(), to_text(axis.values.front()));
  return text;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const OptionValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

Json values_json(const SweepResult& result, const SweepRow& row) {
  Json values = Json::object();
  for (std::size_t k = 0; k < result.axes.size(); ++k) values[result.axes[k].key()] = json_of(row.values[k]);
  return values;
}

Json scores_json(const SweepRow& row) {
  Json scores = Json::object();
  for (const SweepMetric& metric : studies::sweep_metrics()) {
    const Spread spread = row.spread(metric);
    Json runs = Json::array();
    for (const studies::SweepScores& run : row.runs) runs.push_back(number(run.*metric.value));
    scores[std::string(metric.name)] = {{"mean", number(spread.mean)},
                                        {"deviation", number(spread.deviation)},
                                        {"min", number(spread.min)},
                                        {"max", number(spread.max)},
                                        {"runs", std::move(runs)}};
  }
  return scores;
}

Json choices_json(const SweepResult& result) {
  Json choices = Json::array();
  for (const SweepChoice& choice : result.choices) {
    Json candidates = Json::array();
    for (const std::size_t row : choice.candidates) candidates.push_back(values_json(result, result.rows[row]));
    choices.push_back({{"method", choice.method},
                       {"best", values_json(result, result.rows[choice.best])},
                       {"candidates", std::move(candidates)}});
  }
  return choices;
}

std::string head_of_csv(const SweepResult& result) {
  std::string head = "method";
  for (const SweepAxis& axis : result.axes) head += "," + axis.key();
  return head;
}

std::string line_of_csv(const SweepRow& row) {
  std::string line = row.method;
  for (const OptionValue& value : row.values) line += "," + to_text(value);
  return line;
}

/// Nothing where there is no value: spreadsheets know no NaN.
std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string means_csv(const SweepResult& result) {
  std::string text = head_of_csv(result);
  for (const SweepMetric& metric : studies::sweep_metrics())
    text += fmt::format(",{0},{0}_deviation,{0}_min,{0}_max", metric.name);
  text += "\n";
  for (const SweepRow& row : result.rows) {
    text += line_of_csv(row);
    for (const SweepMetric& metric : studies::sweep_metrics()) {
      const Spread spread = row.spread(metric);
      for (const double value : {spread.mean, spread.deviation, spread.min, spread.max}) text += "," + cell(value);
    }
    text += "\n";
  }
  return text;
}

std::string runs_csv(const SweepResult& result) {
  std::string text = head_of_csv(result) + ",seed";
  for (const SweepMetric& metric : studies::sweep_metrics()) text += fmt::format(",{}", metric.name);
  text += "\n";
  for (const SweepRow& row : result.rows)
    for (std::size_t run = 0; run < row.runs.size(); ++run) {
      text += fmt::format("{},{}", line_of_csv(row), result.seeds[run]);
      for (const SweepMetric& metric : studies::sweep_metrics()) text += "," + cell(row.runs[run].*metric.value);
      text += "\n";
    }
  return text;
}

}  // namespace

std::string sweep_table(const SweepReport& report) {
  const SweepResult& result = report.result;
  const std::vector<const SweepMetric*> metrics = measured(result);
  std::vector<std::string> head{"method"};
  for (const SweepAxis& axis : result.axes)
    if (axis.values.size() > 1) head.push_back(axis.key());
  for (const SweepMetric* metric : metrics) head.push_back(heading(*metric));
  head.emplace_back("");
  Table table(head);
  for (std::size_t row = 0; row < result.rows.size(); ++row) {
    std::vector<std::string> cells{result.rows[row].method};
    for (std::size_t k = 0; k < result.axes.size(); ++k)
      if (result.axes[k].values.size() > 1) cells.push_back(to_text(result.rows[row].values[k]));
    for (const SweepMetric* metric : metrics)
      cells.push_back(shown(*metric, result.rows[row].spread(*metric), result.seeds.size() > 1));
    cells.push_back(mark_of(result, row));
    table.add(std::move(cells));
  }
  std::string text = report.subject;
  if (result.seeds.front() > 0) text += fmt::format(", mean of {}", counted(result.seeds.size(), "seed"));
  if (const std::string fixed = fixed_options(result); !fixed.empty()) text += "; " + fixed;
  text += "\n\n" + table.text();
  if (!result.choices.empty())
    text += "\n*: chosen by the rule of [Barshan07] 4.2, CDR_F and CDR_E nearest to each other; o: within 0.05 of it\n";
  return text;
}

std::string sweep_json(const SweepReport& report) {
  const SweepResult& result = report.result;
  Json axes = Json::array();
  for (const SweepAxis& axis : result.axes) {
    Json values = Json::array();
    for (const OptionValue& value : axis.values) values.push_back(json_of(value));
    axes.push_back({{"key", axis.key()}, {"unit", axis.unit}, {"values", std::move(values)}});
  }
  Json rows = Json::array();
  for (const SweepRow& row : result.rows)
    rows.push_back({{"method", row.method}, {"values", values_json(result, row)}, {"scores", scores_json(row)}});
  const Json all{{"written_by", "echoarc"},   {"version", ECHOARC_VERSION},     {"command", report.command},
                 {"subject", report.subject}, {"seeds", result.seeds},          {"axes", std::move(axes)},
                 {"rows", std::move(rows)},   {"choices", choices_json(result)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> write_sweep(const std::filesystem::path& folder, const SweepReport& report) {
  if (Result<void> written = write_text(folder / io::run_report_name, sweep_json(report)); !written) return written;
  if (Result<void> written = write_text(folder / "sweep.csv", means_csv(report.result)); !written) return written;
  if (Result<void> written = write_text(folder / "runs.csv", runs_csv(report.result)); !written) return written;
  for (const studies::NamedChart& chart : studies::sweep_charts(report.result))
    if (Result<void> written = write_text(folder / (chart.name + ".svg"), studies::svg(chart.chart)); !written)
      return written;
  return {};
}

}  // namespace echoarc::cli
