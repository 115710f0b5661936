// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

using Scores = std::vector<MapScore> PlaceRun::*;

std::vector<double> at(const PlaceStudy& study, Scores scores, int degree, const Figure& figure) {
  return figures(study.runs, [&](const PlaceRun& run) { return figure((run.*scores)[std::size_t(degree)]); });
}

ChartSeries series_of(const PlaceStudy& study, Scores scores, std::string name, const Figure& figure) {
  ChartSeries series{.name = std::move(name)};
  for (int degree = 0; degree < angle_count; ++degree) {
    const Spread spread = spread_of(at(study, scores, degree, figure));
    series.x.push_back(degree);
    series.y.push_back(spread.mean);
    series.low.push_back(spread.min);
    series.high.push_back(spread.max);
  }
  return series;
}

ChartFigure chart_of(const PlaceStudy& study, std::string number, const std::string& quantity, const std::string& axis,
                     const Figure& figure) {
  Chart chart{.title = quantity + ", " + std::string(title_of(study.place)),
              .x = {.title = "transversal angle θt (degrees)", .low = 0.0, .high = 90.0},
              .y = {.title = axis, .low = 0.0}};
  chart.height_px = 330;
  chart.series = {series_of(study, &PlaceRun::atm_org, "ATM-org", figure),
                  series_of(study, &PlaceRun::atm_mod, "ATM-mod", figure)};
  return {"angle-" + quantity + "-" + std::string(scene_name(study.place)),
          std::move(number) + "; bands: least to largest of the seeds.", std::move(chart)};
}

/// The largest angle at which ATM-mod still has a point.
std::vector<double> last_angles(const PlaceStudy& study) {
  return figures(study.runs, [](const PlaceRun& run) {
    double last = no_figure;
    for (int degree = 0; degree < angle_count; ++degree)
      if (run.atm_mod[std::size_t(degree)].points > 0) last = degree;
    return last;
  });
}

void add_curve_claims(StudySection& section, const PlaceStudy& curve) {
  const FigureFormat cm{"cm", 2, 1.0};
  const FigureFormat share{"", 3, 1.0};
  section.claims.push_back(claim_less({"S2-d-org", "curved surface: MAE of ATM-org rises from θt = 13° to 30°", "4.3"},
                                      at(curve, &PlaceRun::atm_org, 13, &mae_cm),
                                      at(curve, &PlaceRun::atm_org, 30, &mae_cm), cm));
  section.claims.push_back(
      claim_less({"S2-d-mod", "curved surface: MAE of ATM-mod is smaller at 40° than at 25°", "4.3"},
                 at(curve, &PlaceRun::atm_mod, 40, &mae_cm), at(curve, &PlaceRun::atm_mod, 25, &mae_cm), cm));
  section.claims.push_back(claim_less(
      {"S2-d-cdr", "curved surface: CDR_O of ATM-mod falls from θt = 20° to 40°", "4.3"},
      at(curve, &PlaceRun::atm_mod, 40, &cdr_overall), at(curve, &PlaceRun::atm_mod, 20, &cdr_overall), share));
  StudyTable table{.id = "S2-d", .title = "Transversal angle, curved surface", .note = {}, .rows = {}};
  table.rows.push_back(row_of({"last angle with a point", "ATM-mod", "degrees", 0}, 83.0, last_angles(curve)));
  section.tables.push_back(std::move(table));
}

}  // namespace

StudySection angle_section(const std::vector<const PlaceStudy*>& places) {
  StudySection section;
  section.id = "angles";
  section.title = "Figures 13 to 15: the transversal angle of ATM";
  section.paragraphs = {"The paper takes θt = 13° on the curve and 5° in the rooms, by looking at these curves."};
  for (const PlaceStudy* study : places) {
    const std::string number = "Figure " + std::to_string(13 + int(study->place));
    section.charts.push_back(chart_of(*study, number + "a", "MAE", "MAE (cm)", &mae_cm));
    section.charts.push_back(chart_of(*study, number + "b", "CDR_O", "CDR_O", &cdr_overall));
    if (study->place == Place::curve) add_curve_claims(section, *study);
  }
  return section;
}

}  // namespace echoarc::studies::barshan
