// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "echoarc/studies/map_picture.hpp"
#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

constexpr std::array<std::string_view, 3> degrees_of{"90°", "60°", "30°"};
constexpr Rgb surface_color{240, 190, 120};
constexpr Rgb map_color{20, 20, 20};

std::vector<double> over_runs(const PlaceStudy& study, std::size_t row, const Figure& figure) {
  return figures(study.runs, [&](const PlaceRun& run) { return figure(run.printed[row].cells); });
}

/// MAE of a run, averaged over the techniques that have a point.
std::vector<double> mean_mae(const PlaceStudy& study) {
  return figures(study.runs, [](const PlaceRun& run) {
    std::vector<double> all;
    for (const MethodResult& result : run.printed) all.push_back(mae_cm(result.cells));
    return spread_of(all).mean;
  });
}

StudyTable corner_table(const std::vector<PlaceStudy>& corners) {
  StudyTable table{
      .id = "S2-e",
      .title = "Corners, parameters as printed",
      .note =
          "The paper prints pictures and words, no figures. The transversal angle is not given; 5° as in the rooms.",
      .layout = TableLayout::matrix,
      .rows = {}};
  const std::vector<PrintedRow> rows = printed_rows(Place::corner);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string label = label_of(rows[k].technique, rows[k].parameter);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::string wedge(degrees_of[c]);
      table.rows.push_back(row_of({"MAE, " + wedge, label, "cm", 2}, no_figure, over_runs(corners[c], k, &mae_cm)));
      table.rows.push_back(
          row_of({"CDR_O, " + wedge, label, "", 3}, no_figure, over_runs(corners[c], k, &cdr_overall)));
    }
  }
  return table;
}

/// Figures 4 and 5: a row of pictures per wedge.
void add_pictures(StudySection& section, const PlaceStudy& corner, std::string_view wedge) {
  const PlaceRun& run = corner.runs.front();
  const auto add = [&](std::span<const Vec2> cells, const std::string& name) {
    MapPicture picture(corner.scoring.region, 400);
    picture.add_surfaces(corner.world, surface_color, 3);
    picture.add_points(cells, map_color, 2);
    section.pictures.push_back(
        {"corner-" + std::string(wedge) + "-" + name, std::string(wedge) + ": " + name, picture.image()});
  };
  add(run.votes, "all arcs");
  const std::vector<PrintedRow> rows = printed_rows(Place::corner);
  for (std::size_t k = 0; k < rows.size(); ++k)
    add(run.printed[k].map.points(), label_of(rows[k].technique, rows[k].parameter));
}

}  // namespace

StudySection corner_section(const std::vector<PlaceStudy>& corners) {
  StudySection section;
  section.id = "corners";
  section.title = "Figures 4 and 5: corners of 90°, 60° and 30°";
  section.paragraphs = {
      "Five sonars turn in steps of 1°. The paper judges by eye; ours are figures over rays around the robot."};
  const FigureFormat cm{"cm", 2, 1.0};
  section.claims.push_back(claim_less({"S2-e-60", "60° is worse than 90°: mean MAE of the techniques", "3.7"},
                                      mean_mae(corners[0]), mean_mae(corners[1]), cm));
  section.claims.push_back(claim_less({"S2-e-30", "30° is worse than 60°: mean MAE of the techniques", "3.7"},
                                      mean_mae(corners[1]), mean_mae(corners[2]), cm));
  section.tables.push_back(corner_table(corners));
  for (std::size_t c = 0; c < corners.size(); ++c) add_pictures(section, corners[c], degrees_of[c]);
  return section;
}

}  // namespace echoarc::studies::barshan
