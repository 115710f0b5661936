// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <utility>

#include "studies/chart_axis.hpp"
#include "studies/comparison/chapters.hpp"

namespace echoarc::studies::comparison {
namespace {

// What the claimed bound has to hold: of everything pooled, and of one place.
constexpr std::pair<double, double> pooled_target{0.88, 0.93};
constexpr std::pair<double, double> place_target{0.85, 0.97};
// Bins with fewer points say nothing.
constexpr std::uint64_t least_points = 20;
// Charts of bounds end here; what claims to be no nearer than half a metre is of no interest.
constexpr double most_bound_cm = 50.0;

std::string verdict(const ObservedShare& held, std::pair<double, double> target) {
  if (held.of == 0) return "-";
  return held.share >= target.first && held.share <= target.second ? "yes" : "no";
}

std::vector<std::string> calibration_row(std::string name, const std::vector<ClaimedPoint>& claims,
                                         std::pair<double, double> target) {
  const Calibration all = calibrate(claims);
  return {std::move(name),    std::to_string(all.points),    percent(all.claimed),           percent(all.right.share),
          percent(all.error), percent(all.bound_held.share), verdict(all.bound_held, target)};
}

const std::vector<std::string> calibration_head{"place",    "cells",           "claimed p", "within 10 cm",
                                                "mean gap", "90 % bound held", "in range"};

TextTable place_table(const Comparison& comparison, std::size_t method) {
  TextTable table{.id = "calibration-" + anchor_of(comparison.methods[method].label),
                  .title = comparison.methods[method].label,
                  .note =
                      "In percent, one point per 5 cm cell. Mean gap: between claimed and observed over bins of a "
                      "tenth. In range: pooled 88 to 93, a place 85 to 97. Pooled scenes: the first seed of each.",
                  .head = calibration_head,
                  .rows = {}};
  const auto pooled = [&](const char* name, Pool pool) {
    const std::vector<ClaimedPoint> claims = pooled_claims(comparison, method, pool);
    if (!claims.empty()) table.rows.push_back(calibration_row(name, claims, pooled_target));
  };
  pooled("all pooled", Pool::all);
  pooled("logs pooled", Pool::logs);
  pooled("scenes pooled", Pool::scenes);
  for (const ComparedPlace& place : comparison.places)
    table.rows.push_back(calibration_row(place.name, claims_of(place, method), place_target));
  return table;
}

TextTable label_table(const Comparison& comparison, std::span<const std::size_t> methods) {
  TextTable table{.id = "calibration-labels",
                  .title = "By label",
                  .note = "All logs and the first seed of all scenes pooled.",
                  .head = {"method", "label", "cells", "claimed p", "within 10 cm", "mean gap", "90 % bound held"},
                  .rows = {},
                  .words = 2};
  for (const std::size_t m : methods) {
    const std::vector<ClaimedPoint> claims = pooled_claims(comparison, m, Pool::all);
    for (std::size_t k = 0; k < point_label_count; ++k) {
      const Calibration part = calibrate(with_label(claims, PointLabel(k)));
      if (part.points > 0)
        table.rows.push_back({comparison.methods[m].label, std::string(name(PointLabel(k))),
                              std::to_string(part.points), percent(part.claimed), percent(part.right.share),
                              percent(part.error), percent(part.bound_held.share)});
    }
  }
  return table;
}

ChartSeries curve(std::string name, const std::vector<CalibrationBin>& bins, double factor, double most_claimed) {
  ChartSeries series{.name = std::move(name), .mark = ChartMark::both};
  for (const CalibrationBin& bin : bins) {
    if (bin.observed.of < least_points || factor * bin.claimed > most_claimed) continue;
    series.x.push_back(factor * bin.claimed);
    series.y.push_back(bin.observed.share);
    series.low.push_back(bin.observed.low);
    series.high.push_back(bin.observed.high);
  }
  return series;
}

ChartSeries without_band(ChartSeries series) {
  series.low.clear();
  series.high.clear();
  return series;
}

Chart probability_chart(std::string title) {
  Chart chart{.title = std::move(title),
              .x = {.title = "claimed probability", .low = 0.0, .high = 1.0},
              .y = {.title = "observed share within 10 cm", .low = 0.0, .high = 1.0}};
  chart.series.push_back({.name = "as claimed", .x = {0.0, 1.0}, .y = {0.0, 1.0}, .dashed = true, .color = 7});
  return chart;
}

Chart bound_chart(std::string title) {
  Chart chart{.title = std::move(title),
              .x = {.title = "claimed 90 % bound (cm)", .low = 0.0, .high = most_bound_cm},
              .y = {.title = "observed share within the bound", .low = 0.0, .high = 1.0}};
  chart.series.push_back(
      {.name = "as claimed", .x = {0.0, most_bound_cm}, .y = {0.9, 0.9}, .dashed = true, .color = 7});
  return chart;
}

void add_pooled_charts(const Comparison& comparison, std::size_t m, ComparisonSection& section) {
  const std::string& label = comparison.methods[m].label;
  Chart p = probability_chart(label + ": probability");
  Chart bound = bound_chart(label + ": bound");
  const auto add = [&](const char* name, Pool pool) {
    const Calibration all = calibrate(pooled_claims(comparison, m, pool));
    if (all.points == 0) return;
    p.series.push_back(curve(name, all.by_p, 1.0, 1.0));
    bound.series.push_back(curve(name, all.bound, 100.0, most_bound_cm));
  };
  add("logs", Pool::logs);
  add("scenes", Pool::scenes);
  const std::string caption = "bins of 20 points or more; bands: 95 % intervals";
  section.charts.push_back({"calibration-p-" + anchor_of(label), label + ", pooled; " + caption, std::move(p)});
  section.charts.push_back({"calibration-bound-" + anchor_of(label), label + ", pooled; " + caption, std::move(bound)});
}

void add_log_charts(const Comparison& comparison, std::size_t m, ComparisonSection& section) {
  const std::string& label = comparison.methods[m].label;
  Chart p = probability_chart(label + ": probability, log by log");
  Chart labels = probability_chart(label + ": probability, by label");
  for (const ComparedPlace& place : comparison.places)
    if (place.kind == PlaceKind::log)
      p.series.push_back(without_band(curve(place.name, calibrate(claims_of(place, m)).by_p, 1.0, 1.0)));
  const std::vector<ClaimedPoint> claims = pooled_claims(comparison, m, Pool::all);
  for (std::size_t k = 0; k < point_label_count; ++k) {
    const Calibration part = calibrate(with_label(claims, PointLabel(k)));
    if (part.points > 0)
      labels.series.push_back(without_band(curve(std::string(name(PointLabel(k))), part.by_p, 1.0, 1.0)));
  }
  if (p.series.size() > 1)
    section.charts.push_back({"calibration-logs-" + anchor_of(label), label + ", each recorded log", std::move(p)});
  section.charts.push_back(
      {"calibration-labels-" + anchor_of(label), label + ", each label, everything pooled", std::move(labels)});
}

}  // namespace

ComparisonSection calibration_section(const Comparison& comparison) {
  ComparisonSection section{.id = "calibration", .title = "Whether claims hold"};
  section.paragraphs = {
      "Some methods say of each point how probable it is that it lies within 10 cm of a surface, and within which "
      "bound "
      "it does with 90 %. A point of probability .8 should be right four times in five; a 90 % bound should hold nine "
      "times in ten, not more."};
  std::vector<std::size_t> claiming;
  for (std::size_t m = 0; m < comparison.methods.size(); ++m)
    if (!pooled_claims(comparison, m, Pool::all).empty()) claiming.push_back(m);
  if (claiming.empty()) return section;
  for (const std::size_t m : claiming) {
    section.tables.push_back(place_table(comparison, m));
    add_pooled_charts(comparison, m, section);
  }
  if (const auto shipped = comparison.find(default_consensus)) add_log_charts(comparison, *shipped, section);
  section.tables.push_back(label_table(comparison, claiming));
  return section;
}

}  // namespace echoarc::studies::comparison
