// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/atm_options.hpp"
#include "echoarc/mapping/atm_resolution.hpp"
#include "studies/choset/chapters.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::choset {
namespace {

constexpr double hundred_inches_m = 100.0 * inch_m;
constexpr Angle polaroid = degrees(22.5);
constexpr Angle crossing = degrees(30.0);

StudyRow number(RowText text, double paper, double ours) {
  return row_of(std::move(text), paper, std::span(&ours, 1));
}

}  // namespace

StudySection resolution_numbers(const sim::Scene& scene) {
  StudySection section;
  section.id = "numbers";
  section.title = "Resolution of crossing arcs (Section IV)";
  StudyTable table;
  table.id = "S1-a ... S1-d";
  table.title = "Worked numbers";
  table.note =
      "For a range of 100 inches, a beam of 22.5 degrees, ranges in steps of one inch and arcs that cross at 30 "
      "degrees. "
      "The paper rounds the half travel down to 25.8.";
  const double travel_m = crossing_baseline_m(hundred_inches_m, hundred_inches_m, crossing);
  const double sweep_s = scene.sonar.interval_s * double(scene.robot.sensors.size());
  table.rows = {
      number({"gain in resolution", "S1-a", "", 1}, 10.5,
             resolution_gain(hundred_inches_m, polaroid, inch_m, crossing)),
      number({"interval along the arc", "S1-b", "in", 2}, 3.73, crossing_interval_m(inch_m, crossing) / inch_m),
      number({"half the travel for a crossing", "S1-c", "in", 1}, 25.8, 0.5 * travel_m / inch_m),
      number({"readings kept per sonar", "S1-d", "", 0}, 10, AtmOptions<AtmVariant::org>{}.history_arcs),
      number({"time for a sweep of all sonars", "S1-d", "s", 2}, 1.0, sweep_s),
      number({"speed", "S1-d", "in/s", 1}, 5.0, scene.drive.speed_m_s / inch_m)};
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace echoarc::studies::choset
