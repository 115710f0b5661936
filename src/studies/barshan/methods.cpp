// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/barshan/methods.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "studies/chart_axis.hpp"

namespace echoarc::studies::barshan {
namespace {

struct Names {
  std::string_view name;
  std::string_view method;
  std::string_view option;     // the paper's variable parameter
  std::string_view parameter;  // as labels write it
};

constexpr std::array<Names, technique_count> names{{{"PM", "centerline", "", ""},
                                                    {"VT", "vt", "threshold", "threshold "},
                                                    {"DM", "dm", "threshold", "threshold "},
                                                    {"MP", "mp", "neighbours", "m = "},
                                                    {"BU", "bu", "threshold", "threshold "},
                                                    {"ATM-org", "atm_org", "theta_t_deg", "θt = "},
                                                    {"ATM-mod", "atm_mod", "theta_t_deg", "θt = "},
                                                    {"TBF", "tbf", "threshold", "nt ≥ "}}};

const Names& of(Technique technique) {
  return names[static_cast<std::size_t>(technique)];
}

/// The direction of interest as the paper chose it (3.3, 4.2); rays around the robot where it only turned. In rooms the
/// corners lie beside every line at right angles to the path: what no line visits stays, or VT and DM could not detect
/// alike, as 4.3 says they always do.
OptionMap direction_options(Place place) {
  if (place == Place::curve) return {{"doi", std::string("axis")}, {"axis_deg", 90.0}};
  if (place == Place::corner) return {{"doi", std::string("polar")}};
  return {{"doi", std::string("followed_wall")}, {"unvisited", std::string("keep")}};
}

/// Window of 5 x 20 or 3 x 20, a column per stop (3.7).
OptionMap window_options(Place place) {
  OptionMap options{{"rows", std::int64_t{place == Place::curve || place == Place::corner ? 5 : 3}},
                    {"columns", std::int64_t{20}},
                    {"column_m", 0.024}};
  if (place == Place::corner) options["column_turn_deg"] = 0.9;
  return options;
}

using T = Technique;
constexpr std::array<PrintedRow, 9> table_1{{{T::pm, 0, 11.10, .817, .796, .860, .005},
                                             {T::vt, 4, 3.46, .960, .955, .970, .035},
                                             {T::dm, 4, 2.23, .960, .955, .970, .031},
                                             {T::mp, 7, 5.87, .897, 1.000, .690, .030},
                                             {T::mp, 8, 4.62, .967, .995, .910, .031},
                                             {T::bu, .999, 10.23, .734, .761, .680, .352},
                                             {T::atm_org, 13, 4.33, .748, .682, .880, .310},
                                             {T::atm_mod, 13, 1.81, .754, .632, 1.000, .304},
                                             {T::tbf, 4, 4.28, .595, .393, 1.000, .010}}};
constexpr std::array<PrintedRow, 12> table_7{{{T::pm, 0, 6.17, .627, .575, .932, .004},
                                              {T::vt, 4, 2.57, .938, .951, .863, .077},
                                              {T::vt, 5, 1.87, .858, .847, .926, .077},
                                              {T::dm, 4, 2.36, .938, .951, .863, .085},
                                              {T::dm, 5, 1.96, .858, .847, .926, .086},
                                              {T::mp, 7, 5.85, .835, .826, .888, .083},
                                              {T::bu, .997, 8.13, .788, .787, .795, .587},
                                              {T::bu, .998, 7.56, .775, .771, .795, .584},
                                              {T::bu, .999, 6.93, .762, .752, .820, .584},
                                              {T::atm_org, 5, 4.47, .624, .570, .944, 1.126},
                                              {T::atm_mod, 5, 1.70, .535, .463, .963, 1.128},
                                              {T::tbf, 2, 2.82, .427, .334, .981, .010}}};
constexpr std::array<PrintedRow, 10> table_8{{{T::pm, 0, 6.06, .631, .579, .955, .001},
                                              {T::vt, 5, 2.63, .883, .881, .896, .074},
                                              {T::dm, 5, 2.37, .883, .881, .896, .078},
                                              {T::mp, 7, 4.89, .820, .824, .799, .082},
                                              {T::bu, .997, 5.29, .785, .783, .799, .563},
                                              {T::bu, .998, 5.20, .773, .768, .799, .563},
                                              {T::bu, .999, 4.85, .754, .741, .831, .566},
                                              {T::atm_org, 5, 4.78, .606, .549, .955, 1.054},
                                              {T::atm_mod, 5, 1.68, .522, .449, .947, .871},
                                              {T::tbf, 2, 2.70, .414, .320, 1.000, .010}}};
// Figures 4 and 5; nothing is printed but the parameters. theta_t is that of the rooms: none is given.
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<PrintedRow, 8> corners{{{T::pm, 0, none, none, none, none, none},
                                             {T::vt, 25, none, none, none, none, none},
                                             {T::dm, 25, none, none, none, none, none},
                                             {T::mp, 4, none, none, none, none, none},
                                             {T::bu, .999999, none, none, none, none, none},
                                             {T::atm_org, 5, none, none, none, none, none},
                                             {T::atm_mod, 5, none, none, none, none, none},
                                             {T::tbf, 3, none, none, none, none, none}}};

/// Parameters of Figures 3, 11 and 12 where the tables have several.
double figure_parameter(Place place, Technique technique) {
  if (technique == T::vt || technique == T::dm) return place == Place::room_c ? 5 : place == Place::corner ? 25 : 4;
  if (technique == T::mp) return place == Place::curve ? 8 : place == Place::corner ? 4 : 7;
  if (technique == T::bu) return place == Place::curve ? .999 : place == Place::corner ? .999999 : .998;
  return none;
}

}  // namespace

std::string_view scene_name(Place place) {
  constexpr std::array<std::string_view, 4> scenes{"curve", "room-a", "room-c", "corner-90"};
  return scenes[static_cast<std::size_t>(place)];
}

std::string_view title_of(Place place) {
  constexpr std::array<std::string_view, 4> titles{"curved surface", "room (a)", "room (c)", "corner"};
  return titles[static_cast<std::size_t>(place)];
}

std::string_view table_of(Place place) {
  constexpr std::array<std::string_view, 4> tables{"Table 1", "Table 7", "Table 8", "Figures 4, 5"};
  return tables[static_cast<std::size_t>(place)];
}

std::string_view table_id_of(Place place) {
  constexpr std::array<std::string_view, 4> ids{"S2-T1", "S2-T7", "S2-T8", "S2-e"};
  return ids[static_cast<std::size_t>(place)];
}

std::string_view name_of(Technique technique) {
  return of(technique).name;
}

std::string label_of(Technique technique, double parameter) {
  std::string label(of(technique).name);
  if (technique == T::pm) return label;
  const int decimals = technique != T::bu ? 0 : parameter > 0.9995 ? 6 : 3;
  label += ", " + std::string(of(technique).parameter) + fixed(parameter, decimals);
  if (technique == T::atm_org || technique == T::atm_mod) label += "°";
  return label;
}

MethodSpec spec_of(Technique technique, Place place, double parameter) {
  MethodSpec spec{label_of(technique, parameter), std::string(of(technique).method), {}};
  if (technique == T::dm) spec.options = direction_options(place);
  if (technique == T::tbf) spec.options = window_options(place);
  if (technique == T::atm_org || technique == T::atm_mod) spec.options = {{"history", std::string("all")}};
  const bool whole = technique == T::vt || technique == T::dm || technique == T::mp || technique == T::tbf;
  const std::string option(of(technique).option);
  if (!option.empty())
    spec.options[option] = whole ? OptionValue(std::int64_t(std::llround(parameter))) : OptionValue(parameter);
  return spec;
}

std::vector<PrintedRow> printed_rows(Place place) {
  switch (place) {
    case Place::curve: return {table_1.begin(), table_1.end()};
    case Place::room_a: return {table_7.begin(), table_7.end()};
    case Place::room_c: return {table_8.begin(), table_8.end()};
    default: return {corners.begin(), corners.end()};
  }
}

std::size_t ranked_row(Place place, Technique technique) {
  const std::vector<PrintedRow> rows = printed_rows(place);
  const double parameter = figure_parameter(place, technique);
  const auto found = std::ranges::find_if(rows, [&](const PrintedRow& row) {
    return row.technique == technique && (std::isnan(parameter) || row.parameter == parameter);
  });
  assert(found != rows.end());
  return std::size_t(found - rows.begin());
}

}  // namespace echoarc::studies::barshan
