// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/barshan2007.hpp"

#include <array>
#include <utility>

#include "studies/barshan/parameter_study.hpp"
#include "studies/barshan/sections.hpp"

namespace echoarc::studies {
namespace {

using namespace barshan;

constexpr std::array places{Place::curve, Place::room_a, Place::room_c};
constexpr std::array<std::string_view, 3> corner_scenes{"corner-90", "corner-60", "corner-30"};

std::size_t task_count(const StudyHost& host) {
  return std::size_t(host.seeds) * (places.size() + corner_scenes.size()) + parameter_tasks(host);
}

/// Set-ups one after another; the seeds of each share the executor.
Result<std::vector<PlaceStudy>> run_all(const StudyHost& host, StudyProgress& progress) {
  std::vector<PlaceStudy> studies;
  for (const Place place : places) {
    Result<PlaceStudy> study = run_place(host, progress, place, scene_name(place), true);
    if (!study) return study.error();
    studies.push_back(std::move(*study));
  }
  for (const std::string_view scene : corner_scenes) {
    Result<PlaceStudy> study = run_place(host, progress, Place::corner, scene, false);
    if (!study) return study.error();
    studies.push_back(std::move(*study));
  }
  return studies;
}

/// What stands behind the differences; from looking at maps and figures, not from fitting them.
StudySection differences() {
  StudySection section;
  section.id = "differences";
  section.title = "What does not agree, and why";
  section.paragraphs.emplace_back(
      "The set-ups are known in part. The paper prints neither the profile of the cardboard nor the lengths of the "
      "room, nor where on its way around the room the robot read and turned, nor which pairs of sensors made arcs. "
      "Ours were laid out to give its counts of directions; the count of arcs was the one number the detection "
      "threshold of the simulated sonar was set by, on the curve.");
  section.paragraphs.emplace_back(
      "Rooms: methods that keep single points (PM, ATM, TBF) err two to five times less than in the paper. Its robot "
      "had odometry and its reference was measured by the same robot with structured light; ours knows its poses, and "
      "the reference is the true wall.");
  section.paragraphs.emplace_back(
      "Rooms: there are more arcs than in the paper, because the robot also reads while it turns in the corners of its "
      "way, every 6 degrees, in which its sensors move 2.5 cm. Without these readings the walls near the corners stay "
      "unseen and CDR_F of VT falls to 0.64. With them the maximum along lines across the walls has little to choose "
      "from in the corners, and the MAE of DM lies above that of VT.");
  section.paragraphs.emplace_back(
      "Curve: our CDR_E stays below the paper's at the printed thresholds. Ghosts beside the ends of the surface fill "
      "directions that ought to be empty; the paper's cardboard bends away there, ours ends.");
  section.paragraphs.emplace_back(
      "BU: a cell that echoes have once passed cannot become occupied again as the update is printed, so every echo at "
      "random takes a piece of the surface away for good. On the curve without such outliers BU reaches CDR_F 0.64, "
      "with the 2 % of the profile 0.30, printed are 0.76.");
  section.paragraphs.emplace_back(
      "TBF: our triangulations are more accurate than the printed ones. The paper does not print the gate by which "
      "triangulations belong together; ours is 0.25 m, and circular arcs alone take part.");
  section.paragraphs.emplace_back(
      "Times: a present machine and grids in tiles, hashes and row spans take between a tenth (PM, TBF, BU) and an "
      "eightieth (VT, ATM) of the printed times. ATM gains so much because arcs are found by place, not in all pairs; "
      "BU is then the slowest.");
  return section;
}

}  // namespace

Result<StudyReport> barshan2007(const StudyHost& host) {
  StudyProgress progress(host, task_count(host));
  Result<std::vector<PlaceStudy>> studies = run_all(host, progress);
  if (!studies) return studies.error();
  Result<StudySection> parameters = parameter_section(host, progress);
  if (!parameters) return parameters.error();
  std::vector<PlaceStudy> corners;
  for (std::size_t k = places.size(); k < studies->size(); ++k) corners.push_back(std::move((*studies)[k]));
  studies->resize(places.size());
  std::vector<const PlaceStudy*> shown;
  for (const PlaceStudy& study : *studies) shown.push_back(&study);

  StudyReport report;
  report.name = "barshan2007";
  report.title = "Directional Processing of Ultrasonic Arc Maps and its Comparison with Existing Techniques";
  report.source = "Barshan; International Journal of Robotics Research 26(8), 2007";
  report.seeds = host.seeds;
  report.summary = {
      "A curved surface, two rooms and three corners, mapped by seven techniques, each with the parameter the paper "
      "printed and with the one its own rule takes on our data. Figures are held against the paper's tables; what does "
      "not agree, and what in the set-ups is unknown, stands at the end."};
  report.sections.push_back(ranking_section(shown));
  for (const PlaceStudy* study : shown) report.sections.push_back(comparison_section(*study));
  report.sections.push_back(rule_section(shown));
  report.sections.push_back(sweep_section(shown));
  report.sections.push_back(angle_section(shown));
  report.sections.push_back(corner_section(corners));
  report.sections.push_back(std::move(*parameters));
  if (host.thread_cpu_s) report.sections.push_back(time_section(shown));
  report.sections.push_back(differences());
  return report;
}

}  // namespace echoarc::studies
