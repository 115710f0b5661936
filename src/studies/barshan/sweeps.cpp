// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "echoarc/eval/parameter_choice.hpp"
#include "echoarc/studies/published_sweeps.hpp"
#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

std::vector<double> over_runs(const PlaceStudy& study, std::size_t sweep, std::size_t value, const Figure& figure) {
  return figures(study.runs, [&](const PlaceRun& run) { return figure(run.sweeps[sweep][value]); });
}

const PublishedSweep* printed_sweep(const std::vector<PublishedSweep>& all, std::string_view id) {
  const auto found = std::ranges::find(all, id, &PublishedSweep::id);
  return found == all.end() ? nullptr : &*found;
}

StudyTable sweep_table(const PlaceStudy& study, const SweepPlan& plan, std::size_t index) {
  const std::vector<PublishedSweep> all = published_sweeps();
  const PublishedSweep* printed = printed_sweep(all, plan.id);
  StudyTable table{
      .id = "S2-" + std::string(plan.id),
      .title = printed == nullptr ? std::string(plan.id) : printed->source.substr(12) + ": " + printed->title,
      .note = {},
      .layout = TableLayout::matrix,
      .rows = {}};
  for (std::size_t k = 0; k < plan.values.size(); ++k) {
    const PublishedValue none;
    const PublishedValue& value = printed != nullptr && k < printed->values.size() ? printed->values[k] : none;
    const std::string label = plan.technique == Technique::bu && k + 1 == plan.values.size()
                                  ? "BU, threshold 1.000"
                                  : label_of(plan.technique, plan.values[k]);
    table.rows.push_back(row_of({"MAE", label, "cm", 2}, value.mae_cm, over_runs(study, index, k, &mae_cm)));
    table.rows.push_back(row_of({"CDR_O", label, "", 3}, value.cdr_overall, over_runs(study, index, k, &cdr_overall)));
    table.rows.push_back(row_of({"CDR_F", label, "", 3}, value.cdr_full, over_runs(study, index, k, &cdr_full)));
    table.rows.push_back(row_of({"CDR_E", label, "", 3}, value.cdr_empty, over_runs(study, index, k, &cdr_empty)));
  }
  return table;
}

ChartSeries printed_series(const SweepPlan& plan, const StudyTable& table, std::string_view quantity, int color) {
  ChartSeries series{.name = std::string(name_of(plan.technique)) + ", paper", .dashed = true, .color = color};
  std::size_t k = 0;
  for (const StudyRow& row : table.rows)
    if (row.quantity == quantity) {
      series.x.push_back(plan.values[k++]);
      series.y.push_back(row.paper);
    }
  return series;
}

ChartSeries our_series(const SweepPlan& plan, const StudyTable& table, std::string_view quantity, int color) {
  ChartSeries series{.name = std::string(name_of(plan.technique)) + ", ours", .color = color};
  std::size_t k = 0;
  for (const StudyRow& row : table.rows)
    if (row.quantity == quantity) {
      series.x.push_back(plan.values[k++]);
      series.y.push_back(row.ours.mean);
      series.low.push_back(row.ours.min);
      series.high.push_back(row.ours.max);
    }
  return series;
}

/// A sweep as curves of MAE and CDR, the paper's dashed.
ChartFigure sweep_chart(const SweepPlan& plan, const StudyTable& table, std::string x_title) {
  Chart chart{.title = table.title, .x = {.title = std::move(x_title)}, .y = {.title = "share"}};
  chart.height_px = 330;
  int color = 0;
  for (const std::string_view quantity : {"CDR_O", "CDR_F", "CDR_E"}) {
    ChartSeries ours = our_series(plan, table, quantity, color);
    ChartSeries paper = printed_series(plan, table, quantity, color);
    ours.name = std::string(quantity) + ", ours";
    paper.name = std::string(quantity) + ", paper";
    chart.series.push_back(std::move(ours));
    chart.series.push_back(std::move(paper));
    ++color;
  }
  return {"cdr-" + std::string(plan.id),
          "Correct detection against the parameter; bands: least to largest of the seeds.", std::move(chart)};
}

std::string_view parameter_title(Technique technique) {
  if (technique == Technique::mp) return "m";
  if (technique == Technique::tbf) return "least number of triangulations";
  return "threshold";
}

/// What the paper's rule takes on the means over our seeds.
std::optional<ParameterChoice> choice_of(const PlaceStudy& study, std::size_t sweep) {
  const std::vector<double> mae = mean_by_parameter(study, sweep, &mae_cm);
  const std::vector<double> full = mean_by_parameter(study, sweep, &cdr_full);
  const std::vector<double> empty = mean_by_parameter(study, sweep, &cdr_empty);
  const std::vector<double> overall = mean_by_parameter(study, sweep, &cdr_overall);
  std::vector<ParameterScore> scores;
  for (std::size_t k = 0; k < mae.size(); ++k) scores.push_back({full[k], empty[k], overall[k], 0.01 * mae[k]});
  return choose_parameter(scores);
}

const PrintedRow& printed_row(const std::vector<PrintedRow>& rows, Place place, Technique technique) {
  return rows[ranked_row(place, technique)];
}

void add_rule_rows(StudyTable& table, const PlaceStudy& study) {
  const std::vector<PrintedRow> rows = printed_rows(study.place);
  const std::vector<SweepPlan> plans = sweep_plans();
  for (const std::string_view id : {"T2-vt", "T2-dm", "T3-mp", "T4-bu", "T5-tbf"}) {
    const std::size_t sweep = sweep_index(id);
    const std::optional<ParameterChoice> choice = choice_of(study, sweep);
    if (!choice) continue;
    const Technique technique = plans[sweep].technique;
    const PrintedRow& printed = printed_row(rows, study.place, technique);
    const std::string label = label_of(technique, plans[sweep].values[choice->best]) + " (paper: " +
                              label_of(technique, printed.parameter).substr(name_of(technique).size() + 2) + ")";
    const auto add = [&](std::string quantity, std::string unit, int decimals, double paper, const Figure& figure) {
      table.rows.push_back(row_of({std::move(quantity), label, std::move(unit), decimals}, paper,
                                  over_runs(study, sweep, choice->best, figure)));
    };
    add("MAE", "cm", 2, printed.mae_cm, &mae_cm);
    add("CDR_O", "", 3, printed.cdr_overall, &cdr_overall);
    add("CDR_F", "", 3, printed.cdr_full, &cdr_full);
    add("CDR_E", "", 3, printed.cdr_empty, &cdr_empty);
  }
}

}  // namespace

std::vector<double> mean_by_parameter(const PlaceStudy& study, std::size_t sweep, const Figure& figure) {
  std::vector<double> means;
  for (std::size_t k = 0; k < study.runs.front().sweeps[sweep].size(); ++k)
    means.push_back(spread_of(over_runs(study, sweep, k, figure)).mean);
  return means;
}

StudySection rule_section(const std::vector<const PlaceStudy*>& places) {
  StudySection section;
  section.id = "rule";
  section.title = "Parameters by the paper's rule";
  section.paragraphs = {
      "Section 4.2: a parameter is chosen so that CDR_F and CDR_E come as close as possible. Applied to the means over "
      "our seeds, the rule takes the parameters below; the paper's figures beside them are those of the parameter it "
      "chose on its own data."};
  for (const PlaceStudy* study : places) {
    StudyTable table{.id = std::string(table_id_of(study->place)) + "-rule",
                     .title = std::string(title_of(study->place)),
                     .note = {},
                     .layout = TableLayout::matrix,
                     .rows = {}};
    add_rule_rows(table, *study);
    section.tables.push_back(std::move(table));
  }
  return section;
}

StudySection sweep_section(const std::vector<const PlaceStudy*>& places) {
  StudySection section;
  section.id = "sweeps";
  section.title = "Tables 2 to 6: parameters varied";
  section.paragraphs = {
      "One arc map per seed serves all values of a parameter. Tables with windows of 10 columns, "
      "which the paper tried and did not print, have no printed figures."};
  const std::vector<SweepPlan> plans = sweep_plans();
  for (std::size_t k = 0; k < plans.size(); ++k)
    for (const PlaceStudy* study : places) {
      if (title_of(study->place) != plans[k].published) continue;
      section.tables.push_back(sweep_table(*study, plans[k], k));
      if (plans[k].columns == 20)
        section.charts.push_back(
            sweep_chart(plans[k], section.tables.back(), std::string(parameter_title(plans[k].technique))));
    }
  return section;
}

}  // namespace echoarc::studies::barshan
