// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

using T = Technique;

std::vector<double> ranked(const PlaceStudy& study, Technique technique, const Figure& figure) {
  const std::size_t row = ranked_row(study.place, technique);
  return figures(study.runs, [&](const PlaceRun& run) { return figure(run.printed[row].cells); });
}

/// "MAE of DM < VT": the figure of `low` is the smaller one.
Claim pair(const PlaceStudy& study, Technique low, Technique high, bool mae) {
  const std::string what = mae ? "MAE" : "CDR_O";
  const std::string place(title_of(study.place));
  const std::string left(name_of(mae ? low : high));
  const std::string right(name_of(mae ? high : low));
  return claim_less({.id = "S2-" + what + "-" + std::string(scene_name(study.place)) + "-" + left + "-" + right,
                     .text = what + ", " + place + ": " + left + (mae ? " < " : " > ") + right,
                     .source = mae && study.place == Place::curve ? "3.8" : "4.2"},
                    ranked(study, low, mae ? Figure(&mae_cm) : Figure(&cdr_overall)),
                    ranked(study, high, mae ? Figure(&mae_cm) : Figure(&cdr_overall)),
                    {mae ? "cm" : "", mae ? 2 : 3, 1.0});
}

/// That the CDRs of VT and DM are equal, seed by seed.
Claim equal_detection(const PlaceStudy& study) {
  const std::vector<double> vt = ranked(study, T::vt, &cdr_overall);
  const std::vector<double> dm = ranked(study, T::dm, &cdr_overall);
  Claim claim;
  claim.id = "S2-CDR_O-" + std::string(scene_name(study.place)) + "-DM-VT";
  claim.text = "CDR_O, " + std::string(title_of(study.place)) + ": DM = VT";
  claim.source = "4.3: always equal";
  claim.seeds = vt.size();
  double worst = 0.0;
  for (std::size_t k = 0; k < vt.size(); ++k) {
    worst = std::max(worst, std::abs(vt[k] - dm[k]));
    if (vt[k] == dm[k]) ++claim.holds_on;
  }
  claim.verdict = claim.holds_on == claim.seeds ? Verdict::holds : Verdict::fails;
  claim.evidence = figure_text(spread_of(dm).mean, 3, "") + " and " + figure_text(spread_of(vt).mean, 3, "") +
                   "; largest difference of a seed " + figure_text(worst, 3, "");
  return claim;
}

constexpr std::array curve_mae{T::atm_mod, T::dm, T::vt, T::tbf, T::atm_org, T::mp, T::bu, T::pm};
// Falling; DM and VT share the first place.
constexpr std::array room_detection{T::vt, T::mp, T::bu, T::pm, T::atm_org, T::atm_mod, T::tbf};

/// How many of all pairs of an order come out in that order.
StudyRow concordance(const PlaceStudy& study, std::span<const Technique> rising, bool mae) {
  std::vector<double> right;
  for (const PlaceRun& run : study.runs) {
    double count = 0.0;
    for (std::size_t a = 0; a < rising.size(); ++a)
      for (std::size_t b = a + 1; b < rising.size(); ++b) {
        const auto figure = [&](Technique t) {
          const MapScore& score = run.printed[ranked_row(study.place, t)].cells;
          return mae ? mae_cm(score) : -cdr_overall(score);
        };
        if (figure(rising[a]) < figure(rising[b])) count += 1.0;
      }
    right.push_back(count);
  }
  const double pairs = 0.5 * double(rising.size() * (rising.size() - 1));
  StudyRow row =
      row_of({"pairs in the paper's order", (mae ? "MAE, " : "CDR_O, ") + std::string(title_of(study.place)), "", 1},
             pairs, right);
  row.remark = "of all pairs, not of neighbours alone";
  return row;
}

/// 4.2, in words: the rooms' order of MAE. DM and VT are called comparable to ATM-mod; BU and PM swap places in
/// Table 7.
void add_room_errors(StudySection& section, const PlaceStudy& room) {
  constexpr std::array order{T::atm_mod, T::dm, T::tbf, T::atm_org, T::mp};
  for (std::size_t k = 1; k < order.size(); ++k) section.claims.push_back(pair(room, order[k - 1], order[k], true));
  section.claims.push_back(pair(room, T::atm_org, T::bu, true));
  section.claims.push_back(pair(room, T::atm_org, T::pm, true));
}

Claim advantage(const PlaceStudy& curve) {
  std::vector<double> gain = ranked(curve, T::dm, &cdr_overall);
  const std::vector<double> mod = ranked(curve, T::atm_mod, &cdr_overall);
  for (std::size_t k = 0; k < gain.size(); ++k) gain[k] -= mod[k];
  return claim_at_least(
      {"S2-c", "CDR_O of DM is about 0.21 above that of ATM-mod, curved surface (at least 0.10)", "3.8"}, gain, 0.10,
      {"", 3, 1.0});
}

}  // namespace

StudySection ranking_section(const std::vector<const PlaceStudy*>& places) {
  StudySection section;
  section.id = "rankings";
  section.title = "Rankings, neighbour by neighbour";
  section.paragraphs = {
      "Parameters are those of the paper's figures: threshold 4 of VT and DM (5 in room (c)), m = 8 on the curve and 7 "
      "in the rooms, BU 0.999 on the curve and 0.998 in the rooms, θt 13° and 5°, nt 4 and 2. Every neighbouring pair "
      "of a printed order is a claim of its own."};
  StudyTable all{.id = "", .title = "All pairs of an order", .note = "Paper: how many pairs there are.", .rows = {}};
  for (const PlaceStudy* study : places) {
    if (study->place == Place::curve) {
      for (std::size_t k = 1; k < curve_mae.size(); ++k)
        section.claims.push_back(pair(*study, curve_mae[k - 1], curve_mae[k], true));
      section.claims.push_back(advantage(*study));
      all.rows.push_back(concordance(*study, curve_mae, true));
      continue;
    }
    section.claims.push_back(equal_detection(*study));
    for (std::size_t k = 1; k < room_detection.size(); ++k)
      section.claims.push_back(pair(*study, room_detection[k], room_detection[k - 1], false));
    all.rows.push_back(concordance(*study, room_detection, false));
  }
  for (const PlaceStudy* study : places)
    if (study->place != Place::curve) add_room_errors(section, *study);
  section.tables.push_back(std::move(all));
  return section;
}

}  // namespace echoarc::studies::barshan
