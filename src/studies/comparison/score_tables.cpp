// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>

#include "studies/chart_axis.hpp"
#include "studies/comparison/chapters.hpp"

namespace echoarc::studies::comparison {
namespace {

/// Those that the overview shows; the tables of the places have all.
constexpr std::array<std::string_view, 9> overview{"consensus strict", "consensus balanced", "consensus complete",
                                                   "atm_mod < 3 m",    "atm_mod 5° < 3 m",   "centerline < 3 m",
                                                   "carve < 3 m",      "tbf < 3 m",          "evidence < 3 m"};

void add_scores(const MeanScores& scores, std::vector<std::string>& row) {
  row.push_back(fixed(scores.points, 0));
  for (const double accuracy : scores.accuracy) row.push_back(percent(accuracy));
  row.push_back(percent(scores.coverage));
}

TextTable place_table(const Comparison& comparison, const ComparedPlace& place) {
  TextTable table{.id = "scores-" + anchor_of(place.name),
                  .title = place.name,
                  .note = "Against: " + place.provenance + ".",
                  .head = {"method", "points", "≤ 5 cm", "≤ 10 cm", "≤ 20 cm", "coverage", "cells", "≤ 5 cm", "≤ 10 cm",
                           "≤ 20 cm", "coverage"},
                  .rows = {}};
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
    std::vector<std::string> row{comparison.methods[m].label};
    add_scores(mean_scores(place.maps[m], every_point), row);
    add_scores(mean_scores(place.maps[m], one_per_cell), row);
    table.rows.push_back(std::move(row));
  }
  return table;
}

TextTable overview_table(const Comparison& comparison) {
  TextTable table{.id = "overview",
                  .title = "All places at a glance",
                  .note = "Share of points within 10 cm / coverage, in percent, one point per 5 cm cell.",
                  .head = {"place"},
                  .rows = {}};
  std::vector<std::size_t> columns;
  for (const std::string_view label : overview)
    if (const auto m = comparison.find(label)) {
      columns.push_back(*m);
      table.head.emplace_back(label);
    }
  for (const ComparedPlace& place : comparison.places) {
    if (place.kind == PlaceKind::truncated) continue;
    std::vector<std::string> row{place.name};
    for (const std::size_t m : columns) row.push_back(accuracy_and_coverage(mean_scores(place.maps[m], one_per_cell)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

ComparisonSection score_section(const Comparison& comparison) {
  ComparisonSection section{.id = "scores", .title = "Scores"};
  section.paragraphs = {
      "Accuracy is the share of map points at most so far from the reference. Coverage is the share of the reference "
      "within 2.5 m of the path that has a map point at most 10 cm away. Both in percent, first with every point, then "
      "with one point per 5 cm cell, the first of the map. Scenes: means over the seeds.",
      "No method has been tuned: every one runs with the options it is shipped with, but for what its label says. "
      "\"< 3 m\" leaves out echoes from 3 m on; consensus has that limit of its own. `limited` is helped by the laser "
      "where there is one."};
  section.tables.push_back(overview_table(comparison));
  for (const ComparedPlace& place : comparison.places)
    if (place.kind != PlaceKind::truncated) section.tables.push_back(place_table(comparison, place));
  return section;
}

ComparisonSection truncation_section(const Comparison& comparison) {
  ComparisonSection section{.id = "truncated", .title = "The first seconds of a log"};
  const auto median = comparison.find(careful_median);
  const auto consensus = comparison.find(default_consensus);
  if (!median || !consensus) return section;
  section.paragraphs = {
      "A robot that has just set out has few arcs. Each log is cut after so many seconds, mapped, and held against "
      "what "
      "its laser has seen until then; in the last columns against the laser of the whole log. Every point counts. The "
      "difference is consensus less `" +
      std::string(careful_median) + "`, in percent points."};
  TextTable table{.id = "truncated",
                  .title = "Consensus, balanced, and the transversal median at 13°",
                  .note = "Places where the median has fewer than 100 points are not compared (in brackets).",
                  .head = {"log", "points of the median", "median", "consensus", "more accurate by", "more complete by",
                           "more accurate by, whole laser", "per 5 cm cell, more accurate by"},
                  .rows = {}};
  for (const ComparedPlace& place : comparison.places) {
    if (place.kind != PlaceKind::truncated) continue;
    const auto scores = [&](std::size_t m, Counting counting) { return mean_scores(place.maps[m], counting); };
    const MeanScores theirs = scores(*median, every_point);
    const MeanScores ours = scores(*consensus, every_point);
    const bool few = theirs.points < compared_points;
    const auto gain = [](const MeanScores& a, const MeanScores& b) { return percent(a.accuracy[1] - b.accuracy[1]); };
    table.rows.push_back({few ? std::string("(").append(place.name).append(")") : place.name, fixed(theirs.points, 0),
                          accuracy_and_coverage(theirs), accuracy_and_coverage(ours), gain(ours, theirs),
                          percent(ours.coverage - theirs.coverage),
                          gain(mean_scores_against_whole(place.maps[*consensus], every_point),
                               mean_scores_against_whole(place.maps[*median], every_point)),
                          gain(scores(*consensus, one_per_cell), scores(*median, one_per_cell))});
  }
  if (!table.rows.empty()) section.tables.push_back(std::move(table));
  return section;
}

}  // namespace echoarc::studies::comparison
