// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "studies/comparison/chapters.hpp"

namespace echoarc::studies::comparison {
namespace {

std::string_view words(Counting counting) {
  return counting == every_point ? "every point" : "one per 5 cm cell";
}

TextTable dominator_table(const Comparison& comparison) {
  TextTable table{
      .id = "dominators",
      .title = "Who dominates consensus",
      .note =
          "Share within 10 cm / coverage of both. `limited` is told by the laser that recorded logs are held "
          "against.",
      .head = {"place", "method", "dominates", "counting", "its scores", "scores of consensus"},
      .rows = {},
      .words = 4};
  for (const Dominance& one : dominators_of_consensus(comparison)) {
    const ComparedPlace& place = comparison.places[one.place];
    table.rows.push_back({place.name, comparison.methods[one.better].label, comparison.methods[one.worse].label,
                          std::string(words(one.counting)),
                          accuracy_and_coverage(mean_scores(place.maps[one.better], one.counting)),
                          accuracy_and_coverage(mean_scores(place.maps[one.worse], one.counting))});
  }
  if (table.rows.empty()) table.rows.push_back({"nowhere", "none", "", "", "", ""});
  return table;
}

std::string list_of(const Comparison& comparison, const Duel& duel) {
  if (duel.places == 0) return "nowhere compared";
  if (duel.others.size() == duel.places) return "everywhere";
  std::string names;
  for (const std::size_t p : duel.others) names += (names.empty() ? "" : "; ") + comparison.places[p].name;
  return names;
}

TextTable duel_table(const Comparison& comparison, Counting counting) {
  TextTable table{
      .id = counting == every_point ? "duels-every-point" : "duels",
      .title = "Whom consensus dominates, " + std::string(words(counting)),
      .note =
          "Of the places where both maps have 100 points or more. Not more accurate, not more complete: "
          "places where consensus is not so by a percent point.",
      .head = {"method", "not dominated on", "places", "dominated", "not more accurate", "not more complete"},
      .rows = {},
      .words = 2};
  for (const Duel& duel : duels(comparison, counting))
    table.rows.push_back({comparison.methods[duel.method].label, list_of(comparison, duel), std::to_string(duel.places),
                          std::to_string(duel.dominated), std::to_string(duel.not_more_accurate),
                          std::to_string(duel.not_more_complete)});
  return table;
}

}  // namespace

ComparisonSection duel_section(const Comparison& comparison) {
  ComparisonSection section{.id = "duels", .title = "Who is better than whom"};
  if (!comparison.find(default_consensus)) return section;
  section.paragraphs = {
      "Method A dominates B on a place when both its scores, the share of points within 10 cm and the coverage, are "
      "higher by a percent point or more, and both maps have 100 points or more. Whole logs, cut logs and scenes "
      "count, "
      "each once."};
  section.tables = {dominator_table(comparison), duel_table(comparison, one_per_cell),
                    duel_table(comparison, every_point)};
  return section;
}

}  // namespace echoarc::studies::comparison
