// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "studies/choset/chapters.hpp"
#include "studies/choset/mouth.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::choset {
namespace {

struct Passing {
  Mouth mouth;
  std::string_view id;
  double distance_m;
};

constexpr std::array<Passing, 2> passings{
    {{{"opening-near", {-2.0, 1.2}, {2.0, 1.2}}, "near", 1.2}, {{"opening-far", {-2.0, 2.5}, {2.0, 2.5}}, "far", 2.5}}};
constexpr Mouth foot{"t-world", {-1.0, 0.0}, {1.0, 0.0}};

using Runs = std::vector<MouthRun>;
using View = MouthView MouthRun::*;
constexpr FigureFormat metres{.unit = "m", .decimals = 2};

std::vector<double> gaps_m(const Runs& runs, View view) {
  return figures(runs, [&](const MouthRun& run) { return (run.*view).gap_m; });
}

void add_rows(StudyTable& table, const Runs& runs, const std::string& where, const std::string& centerline_text) {
  struct Line {
    std::string name;
    View view;
    std::string paper;
  };
  const std::array<Line, 4> lines{{{"centerline", &MouthRun::centerline, centerline_text},
                                   {"ATM, ten arcs per sonar", &MouthRun::atm, "open"},
                                   {"ATM, all arcs of the drive", &MouthRun::atm_all, "open"},
                                   {"ATM, medians and centres of the other arcs", &MouthRun::atm_centerline, ""}}};
  for (const Line& line : lines) {
    const std::string condition = where + line.name;
    table.rows.push_back(row_of({"widest gap in the opening", condition, "m", 2}, line.paper, gaps_m(runs, line.view)));
    table.rows.push_back(row_of({"widest gap in the wall beside", condition, "m", 2}, "",
                                figures(runs, [&](const MouthRun& run) { return (run.*line.view).beside_m; })));
  }
}

void add_pictures(StudySection& section, const StudyScene& scene, const MouthRun& run, const std::string& id,
                  const std::string& where, const std::array<std::string_view, 3>& papers) {
  section.pictures.push_back({id + "-centerline", "Centres of arcs" + where + " (" + std::string(papers[0]) + ")",
                              mouth_picture(scene, run.centerline.points)});
  section.pictures.push_back(
      {id + "-arcs", "All arcs" + where + " (" + std::string(papers[1]) + ")", arcs_picture(scene, run.readings)});
  section.pictures.push_back({id + "-atm", "Medians of all crossings" + where + " (" + std::string(papers[2]) + ")",
                              mouth_picture(scene, run.atm_all.points)});
}

std::vector<double> shown(const Runs& runs, View view, double robot_m) {
  return figures(runs, [&](const MouthRun& run) { return (run.*view).shows_opening(robot_m) ? 1.0 : 0.0; });
}

void add_claims(StudySection& section, const Runs& runs, const std::string& id, const std::string& where,
                const std::string& source, double robot_m) {
  const std::string name = "S1-e-" + id;
  const FigureFormat drives{.unit = "of the drives", .decimals = 2};
  section.claims.push_back(claim_at_least({name + "-atm", "ATM leaves a gap as wide as the robot" + where, source},
                                          gaps_m(runs, &MouthRun::atm), robot_m, metres));
  section.claims.push_back(claim_at_least(
      {name + "-ring", "ATM of ten arcs per sonar: that gap is wider than any in the wall beside" + where, source},
      shown(runs, &MouthRun::atm, robot_m), 0.5, drives));
  section.claims.push_back(
      claim_at_least({name + "-all", "ATM of all arcs: that gap is wider than any in the wall beside" + where, source},
                     shown(runs, &MouthRun::atm_all, robot_m), 0.5, drives));
  section.claims.push_back(
      claim_less({name + "-centerline", "The centerline model shows no way through" + where, source},
                 gaps_m(runs, &MouthRun::centerline), std::vector<double>(runs.size(), robot_m), metres));
}

Result<Runs> runs_of(const StudyHost& host, StudyProgress& progress, const StudyScene& scene, const Mouth& mouth) {
  return run_tasks<MouthRun>(host, std::size_t(host.seeds), progress,
                             [&](std::size_t k) { return look_at_mouth(scene, mouth, k + 1, k == 0); });
}

}  // namespace

Result<StudySection> narrow_opening(const StudyHost& host, StudyProgress& progress) {
  StudySection section;
  section.id = "opening";
  section.title = "Past a narrow opening (Figs. 6, 16, 17)";
  StudyTable table;
  table.id = "S1-e";
  table.title = "How wide the opening of 0.80 m looks";
  table.layout = TableLayout::matrix;
  table.note =
      "A gap is a stretch of the wall's line without a point within 0.20 m of it. The figures beside the centerline "
      "model are those of its geometry (Fig. 4), c = a - 2 D tan(phi / 2).";
  for (const Passing& passing : passings) {
    Result<StudyScene> scene = host.scene(passing.mouth.scene);
    if (!scene) return scene.error();
    const Result<Runs> runs = runs_of(host, progress, *scene, passing.mouth);
    if (!runs) return runs.error();
    const double opening_m = mouth_opening(scene->scene.world, passing.mouth).width_m();
    const double expected_m = centerline_opening_m(opening_m, passing.distance_m, degrees(22.5));
    const std::string where = ", " + figure_text(passing.distance_m, 1, "m") + " away";
    const std::string id(passing.id);
    add_rows(table, *runs, figure_text(passing.distance_m, 1, "m: "),
             figure_text(expected_m, 2, "") + (expected_m < 0.0 ? " (closed)" : ""));
    add_claims(section, *runs, id, where, "Section IV-D, Figs. 6 and 17", 2.0 * scene->scene.robot.radius_m);
    add_pictures(section, *scene, runs->front(), id, where, {"Fig. 6", "Fig. 16", "Fig. 17"});
  }
  section.tables.push_back(std::move(table));
  section.remarks = {
      "A map without points is open everywhere, so a wide gap alone proves little: the walls beside the opening must "
      "be "
      "there, too. Two arcs of 2.5 m cross at 30 degrees only when they were taken 1.29 m apart. Ten sweeps at five "
      "inches a second are 1.27 m: far from the wall the ring of ten arcs holds next to no crossing, and what the "
      "figures "
      "of the paper show needs the arcs of the whole drive.",
      "The gap of the centerline model is wider than its geometry says because a jamb, an edge 15 dB weaker than the "
      "wall, is heard over less than the nominal beam of 22.5 degrees."};
  return section;
}

Result<StudySection> t_world(const StudyHost& host, StudyProgress& progress) {
  StudySection section;
  section.id = "t-world";
  section.title = "A narrow corridor at the foot of a T (Figs. 21, 22): the map";
  section.paragraphs = {
      "In the paper the robot explores: on centres of arcs it misses the narrow corridor, on medians it finds and "
      "enters "
      "it. Here it drives a fixed way, and the maps alone are compared. The figure with exploration (S1-e) is not part "
      "of this run."};
  Result<StudyScene> scene = host.scene(foot.scene);
  if (!scene) return scene.error();
  const Result<Runs> runs = runs_of(host, progress, *scene, foot);
  if (!runs) return runs.error();
  StudyTable table;
  table.id = "S1-e, T world";
  table.title = "How wide the mouth of 0.90 m looks";
  table.layout = TableLayout::matrix;
  add_rows(table, *runs, "", "none");
  section.tables.push_back(std::move(table));
  add_claims(section, *runs, "t", ", T world", "Section V, Figs. 21 and 22", 2.0 * scene->scene.robot.radius_m);
  add_pictures(section, *scene, runs->front(), "t", ", T world", {"Fig. 21", "Fig. 23a", "Fig. 22"});
  return section;
}

}  // namespace echoarc::studies::choset
