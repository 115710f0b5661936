// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/yamauchi.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/mapping/evidence_grid.hpp"
#include "echoarc/mapping/limited_grid.hpp"
#include "studies/findings.hpp"
#include "studies/grid_scores.hpp"

namespace echoarc::studies {
namespace {

using Maps = std::vector<GridScore>;  // of one seed: sonar alone, laser-limited

constexpr std::array<std::string_view, 2> names{"sonar alone", "laser-limited sonar"};

std::vector<AnyMethod> two_methods() {
  std::vector<AnyMethod> methods;
  methods.emplace_back(EvidenceGrid());
  methods.emplace_back(LimitedGrid());
  return methods;
}

// The robot stands while it takes one scan and fires all its sonars, so the scan holds for all of them.
SensingOptions sensing_at_stops() {
  SensingOptions options;
  options.laser_max_age_s = 2.0;
  return options;
}

template <class Count>
std::vector<double> area_m2(const std::vector<Maps>& runs, std::size_t map, const Count& count) {
  return figures(runs, [&](const Maps& maps) { return double(count(maps[map].cells)) * maps[map].cells.cell_area_m2; });
}

std::uint64_t false_free(const FreeCells& cells) {
  return cells.false_free();
}

StudyTable table_of(const std::vector<Maps>& runs) {
  StudyTable table;
  table.id = "S3";
  table.title = "Cells that look open";
  table.note =
      "False open: cells of 5 cm called free though a surface runs through them or they lie behind one. The page shows "
      "two pictures and gives no numbers.";
  table.layout = TableLayout::matrix;
  for (std::size_t m = 0; m < names.size(); ++m) {
    const std::string name(names[m]);
    table.rows.push_back(row_of({"false open", name, "m²", 3}, no_figure, area_m2(runs, m, false_free)));
    table.rows.push_back(row_of({"of it behind surfaces", name, "m²", 3}, no_figure,
                                area_m2(runs, m, [](const FreeCells& cells) { return cells.behind; })));
    table.rows.push_back(row_of({"rightly open", name, "m²", 2}, no_figure,
                                area_m2(runs, m, [](const FreeCells& cells) { return cells.true_free; })));
  }
  return table;
}

StudySection section_of(const StudyScene& scene, const std::vector<Maps>& runs) {
  StudySection section;
  section.id = "alcove";
  section.title = "A robot in an alcove";
  section.claims.push_back(claim_less({"S3-open", "Laser-limited sonar has less false open area than sonar alone",
                                       "Sonar Evidence Grid and Laser-Limited Sonar Evidence Grid"},
                                      area_m2(runs, 1, false_free), area_m2(runs, 0, false_free),
                                      {.unit = "m²", .decimals = 3}));
  section.tables.push_back(table_of(runs));
  for (std::size_t m = 0; m < names.size(); ++m)
    section.pictures.push_back({"alcove-" + std::to_string(m + 1),
                                std::string(names[m]) + ", seed 1. True surfaces in red.",
                                grid_picture(scene, runs.front()[m].states)});
  return section;
}

}  // namespace

Result<StudyReport> yamauchi(const StudyHost& host) {
  StudyReport report;
  report.name = "yamauchi";
  report.title = "Laser-Limited Sonar";
  report.source = "Yamauchi, Frontier-Based Exploration, 1997";
  report.seeds = host.seeds;
  report.summary = {
      "The robot turns once on the spot in an alcove with walls like mirrors. Silence clears cells up to the range to "
      "which the sonar is trusted; a slanted smooth wall is as silent as an empty room, and that is where most of the "
      "false open cells of sonar alone come from, beside mirror images."};
  Result<StudyScene> scene = host.scene("alcove");
  if (!scene) return scene.error();
  const DenseGrid<CellState> truth = scene_truth(*scene, EvidenceGridOptions{}.cell_m);
  StudyProgress progress(host, std::size_t(host.seeds));
  const auto runs = run_tasks<Maps>(host, std::size_t(host.seeds), progress, [&](std::size_t k) {
    return score_grids(*scene, k + 1, two_methods(), truth, k == 0, sensing_at_stops());
  });
  if (!runs) return runs.error();
  report.sections.push_back(section_of(*scene, *runs));
  return report;
}

}  // namespace echoarc::studies
