// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/spread.hpp"
#include "studies/chart_axis.hpp"
#include "studies/comparison/chapters.hpp"

namespace echoarc::studies::comparison {
namespace {

std::string mean_and_spread(std::span<const ComparedMap> maps, double factor, int decimals, auto figure) {
  std::vector<double> values;
  for (const ComparedMap& map : maps)
    if (map.pixels) values.push_back(factor * figure(*map.pixels));
  const Spread spread = spread_of(values);
  if (spread.values == 0) return "-";
  std::string text = fixed(spread.mean, decimals);
  if (spread.values > 1) text += " ± " + fixed(spread.deviation, decimals);
  return text;
}

TextTable pixel_table(const Comparison& comparison, const ComparedPlace& place) {
  TextTable table{.id = "pixels-" + anchor_of(place.name),
                  .title = place.experiment + ", " + place.name,
                  .note = "",
                  .head = {"method", "pixels", "MAE, cm", "CDR full", "CDR empty", "CDR overall"},
                  .rows = {}};
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
    const std::vector<ComparedMap>& maps = place.maps[m];
    if (maps.empty() || !maps.front().pixels) continue;
    table.rows.push_back(
        {comparison.methods[m].label,
         mean_and_spread(maps, 1.0, 0, [](const MapScore& score) { return double(score.points); }),
         mean_and_spread(maps, 100.0, 2, [](const MapScore& score) { return score.mae_m; }),
         mean_and_spread(maps, 1.0, 3, [](const MapScore& score) { return score.detection.full_ratio(); }),
         mean_and_spread(maps, 1.0, 3, [](const MapScore& score) { return score.detection.empty_ratio(); }),
         mean_and_spread(maps, 1.0, 3, [](const MapScore& score) { return score.detection.overall_ratio(); })});
  }
  return table;
}

}  // namespace

ComparisonSection pixel_section(const Comparison& comparison) {
  ComparisonSection section{.id = "pixels", .title = "Pixels of the simulated rooms"};
  section.paragraphs = {
      "The scores of [Barshan07]: mean absolute error (MAE) of the occupied pixels of 1 cm, and correct detection "
      "ratio "
      "(CDR) over the directions of interest, without a tolerance. Mean ± standard deviation over the seeds. Options "
      "as "
      "shipped; what the paper chose for each scene, and its figures, are in the reproductions."};
  for (const ComparedPlace& place : comparison.places)
    if (!place.experiment.empty()) section.tables.push_back(pixel_table(comparison, place));
  return section;
}

}  // namespace echoarc::studies::comparison
