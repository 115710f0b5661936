// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include "echoarc/studies/map_picture.hpp"
#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

constexpr Rgb surface_color{240, 190, 120};
constexpr Rgb path_color{170, 200, 230};
constexpr Rgb map_color{20, 20, 20};
constexpr std::int32_t picture_px = 525;

struct PrintedCounts {
  double arcs;
  double inside;
  double full;
  double empty;
  std::string_view remark;  // how firm the directions are
};

PrintedCounts printed_counts(Place place) {
  if (place == Place::curve) return {350, 284, 201, 100, "inferred from the printed ratios; firm"};
  if (place == Place::room_a) return {738, 697, 953, 161, "inferred from the printed ratios; likely"};
  return {702, 659, 954, 154, "inferred from the printed ratios; weak"};
}

StudyTable count_table(const PlaceStudy& study) {
  const PrintedCounts printed = printed_counts(study.place);
  const std::string place(title_of(study.place));
  StudyTable table{.id = "S2-a", .title = "Arcs and directions of interest", .note = {}, .rows = {}};
  table.rows.push_back(
      row_of({"arcs", place, "", 1}, printed.arcs, figures(study.runs, [](const PlaceRun& run) { return run.arcs; })));
  table.rows.push_back(row_of({"arcs in the map", place, "", 1}, printed.inside,
                              figures(study.runs, [](const PlaceRun& run) { return run.arcs_in_region; })));
  const auto directions = [&](auto member) {
    return figures(study.runs,
                   [&](const PlaceRun& run) { return double(run.printed.front().cells.detection.*member); });
  };
  table.rows.push_back(row_of({"full directions", place, "", 1}, printed.full, directions(&CorrectDetection::full)));
  table.rows.back().remark = printed.remark;
  table.rows.push_back(row_of({"empty directions", place, "", 1}, printed.empty, directions(&CorrectDetection::empty)));
  table.rows.back().remark = printed.remark;
  return table;
}

std::vector<double> over_runs(const PlaceStudy& study, std::size_t row, const Figure& figure) {
  return figures(study.runs, [&](const PlaceRun& run) { return figure(run.printed[row].cells); });
}

StudyTable printed_table(const PlaceStudy& study) {
  StudyTable table{.id = std::string(table_id_of(study.place)),
                   .title = std::string(table_of(study.place)) + ": " + std::string(title_of(study.place)) +
                            ", parameters as printed",
                   .note =
                       "MAE over the centres of occupied cells, for all methods. \"MAE, points\": over the exact "
                       "points of PM, ATM and TBF.",
                   .layout = TableLayout::matrix,
                   .rows = {}};
  const std::vector<PrintedRow> rows = printed_rows(study.place);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const PrintedRow& row = rows[k];
    const std::string label = label_of(row.technique, row.parameter);
    table.rows.push_back(row_of({"MAE", label, "cm", 2}, row.mae_cm, over_runs(study, k, &mae_cm)));
    table.rows.push_back(row_of({"CDR_O", label, "", 3}, row.cdr_overall, over_runs(study, k, &cdr_overall)));
    table.rows.push_back(row_of({"CDR_F", label, "", 3}, row.cdr_full, over_runs(study, k, &cdr_full)));
    table.rows.push_back(row_of({"CDR_E", label, "", 3}, row.cdr_empty, over_runs(study, k, &cdr_empty)));
    table.rows.push_back(
        row_of({"MAE, points", label, "cm", 2}, no_figure,
               figures(study.runs, [&](const PlaceRun& run) { return mae_cm(run.printed[k].points); })));
  }
  return table;
}

PictureFigure picture_of(const PlaceStudy& study, const std::vector<Vec2>& cells, std::string id, std::string caption) {
  MapPicture picture(study.scoring.region, picture_px);
  picture.add_surfaces(study.world, surface_color, 3);
  picture.add_line(study.runs.front().path, path_color, 2);
  const double pixels_per_cell =
      picture_px * study.scoring.cell_m / (study.scoring.region.high.x - study.scoring.region.low.x);
  picture.add_points(cells, map_color, std::max(2, std::int32_t(std::lround(pixels_per_cell))));
  return {std::move(id), std::move(caption), picture.image()};
}

/// Figures 3, 11, 12: the arc map and a map per technique.
std::vector<PictureFigure> pictures_of(const PlaceStudy& study) {
  const PlaceRun& run = study.runs.front();
  const std::string scene(scene_name(study.place));
  std::vector<PictureFigure> pictures{picture_of(study, run.votes, scene + "-uam", "All arcs")};
  for (std::size_t k = 0; k < technique_count; ++k) {
    const auto technique = Technique(k);
    const std::size_t row = ranked_row(study.place, technique);
    const std::string caption = label_of(technique, printed_rows(study.place)[row].parameter);
    const std::span<const Vec2> cells = run.printed[row].map.points();
    pictures.push_back(
        picture_of(study, {cells.begin(), cells.end()}, scene + "-" + std::string(name_of(technique)), caption));
  }
  return pictures;
}

}  // namespace

double mae_cm(const MapScore& score) {
  return 100.0 * score.mae_m;
}
double cdr_overall(const MapScore& score) {
  return score.detection.overall_ratio();
}
double cdr_full(const MapScore& score) {
  return score.detection.full_ratio();
}
double cdr_empty(const MapScore& score) {
  return score.detection.empty_ratio();
}

StudySection comparison_section(const PlaceStudy& study) {
  StudySection section;
  section.id = std::string(scene_name(study.place));
  section.title = std::string(table_of(study.place)) + ": " + std::string(title_of(study.place));
  section.tables = {count_table(study), printed_table(study)};
  section.pictures = pictures_of(study);
  section.remarks = {"Pictures: maps of the first seed; surfaces ochre, the robot's way blue."};
  return section;
}

}  // namespace echoarc::studies::barshan
