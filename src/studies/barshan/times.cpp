// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

using T = Technique;

std::vector<double> milliseconds(const PlaceStudy& study, Technique technique) {
  const std::size_t row = ranked_row(study.place, technique);
  return figures(study.runs, [&](const PlaceRun& run) { return 1e3 * run.printed[row].cpu_s(); });
}

/// Value by value the larger, or the smaller one.
std::vector<double> merged(std::vector<double> a, const std::vector<double>& b, bool larger) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = larger ? std::max(a[k], b[k]) : std::min(a[k], b[k]);
  return a;
}

StudyTable time_table(const PlaceStudy& study) {
  StudyTable table{.id = std::string(table_id_of(study.place)) + "-cpu",
                   .title = "CPU time, " + std::string(title_of(study.place)),
                   .note = {},
                   .layout = TableLayout::matrix,
                   .rows = {}};
  for (std::size_t k = 0; k < technique_count; ++k) {
    const auto technique = Technique(k);
    const PrintedRow printed = printed_rows(study.place)[ranked_row(study.place, technique)];
    const std::string label = label_of(technique, printed.parameter);
    const double paper_arcs = study.place == Place::curve ? 350.0 : study.place == Place::room_a ? 738.0 : 702.0;
    const std::vector<double> total = milliseconds(study, technique);
    std::vector<double> per_arc = total;
    for (std::size_t run = 0; run < per_arc.size(); ++run) per_arc[run] *= 1e3 / study.runs[run].arcs;
    table.rows.push_back(row_of({"CPU time", label, "ms", 2}, 1e3 * printed.cpu_s, total));
    table.rows.push_back(row_of({"CPU time per arc", label, "µs", 2}, 1e6 * printed.cpu_s / paper_arcs, per_arc));
  }
  return table;
}

void add_claims(StudySection& section, const PlaceStudy& study) {
  const std::string place(title_of(study.place));
  const FigureFormat ms{"ms", 3, 1.0};
  const auto claim = [&](std::string id, const std::string& text, const std::vector<double>& low,
                         const std::vector<double>& high) {
    section.claims.push_back(claim_less({"S2-cpu-" + std::string(scene_name(study.place)) + "-" + std::move(id),
                                         "CPU, " + place + ": " + text, "3.8, 4.4"},
                                        low, high, ms));
  };
  const std::vector<double> tbf = milliseconds(study, T::tbf);
  const std::vector<double> vt = milliseconds(study, T::vt);
  const std::vector<double> dm = milliseconds(study, T::dm);
  const std::vector<double> mp = milliseconds(study, T::mp);
  const std::vector<double> bu = milliseconds(study, T::bu);
  claim("pm-tbf", "PM < TBF", milliseconds(study, T::pm), tbf);
  claim("tbf-grids", "TBF < VT, DM and MP", tbf, merged(merged(vt, dm, false), mp, false));
  claim("grids-bu", "VT, DM and MP < BU", merged(merged(vt, dm, true), mp, true), bu);
  if (study.place != Place::curve)  // about equal on the curve
    claim("bu-atm", "BU < ATM", bu, merged(milliseconds(study, T::atm_org), milliseconds(study, T::atm_mod), false));
}

}  // namespace

StudySection time_section(const std::vector<const PlaceStudy*>& places) {
  StudySection section;
  section.id = "times";
  section.title = "Times of section 4.4";
  section.paragraphs = {
      "Ours: one thread, from readings to the processed map, files left out; one run per seed, so that single figures "
      "are noisy. The paper's were measured in C on a Pentium 4 of 3 GHz, file operations included. These figures are "
      "the only ones of the report that differ from run to run."};
  for (const PlaceStudy* study : places) {
    add_claims(section, *study);
    section.tables.push_back(time_table(*study));
  }
  return section;
}

}  // namespace echoarc::studies::barshan
