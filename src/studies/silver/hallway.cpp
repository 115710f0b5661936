// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/eval/passability.hpp"
#include "echoarc/studies/local_maps.hpp"
#include "echoarc/studies/map_picture.hpp"
#include "studies/findings.hpp"
#include "studies/silver/chapters.hpp"
#include "studies/simulated_drive.hpp"

namespace echoarc::studies::silver {
namespace {

// The scene's hallway runs along x between these; the map is asked for a lane of this width, this far ahead.
constexpr double half_width_m = 0.7;
constexpr double lane_m = 0.5;
constexpr double ahead_m = 2.0;
constexpr double first_look_m = -1.0;  // along x: by then the history is full
constexpr double look_step_m = 0.25;

struct View {
  std::string_view name;
  std::vector<MapPoint> LocalMaps::* map;
};
constexpr std::array<View, 5> views{{{"ATM and centres of arcs", &LocalMaps::atm_centerline},
                                     {"ATM and arc carving", &LocalMaps::atm_carved},
                                     {"ATM, arc carving and centres of the rest", &LocalMaps::combined},
                                     {"arc carving alone", &LocalMaps::carved_centerline},
                                     {"centres of arcs alone", &LocalMaps::centerline}}};

struct Passage {
  double lane_m = 0.0;  ///< the widest straight lane free of points
  double disc_m = 0.0;  ///< the largest disc that gets through on any way
};

Passage passage_ahead(std::span<const MapPoint> map, double front_x_m) {
  const std::vector<Vec2> points = positions(map);
  const Strip across{{front_x_m, -half_width_m}, {front_x_m, half_width_m}, 0.0, ahead_m};
  const Strip along{{front_x_m, 0.0}, {front_x_m + ahead_m, 0.0}, half_width_m, half_width_m};
  return {widest_gap(points, across).width_m(), passage_width_m(points, along)};
}

struct Look {
  double x_m = 0.0;
  std::array<Passage, views.size()> passages;
};

struct HallwayRun {
  std::vector<Look> looks;
  LocalMaps last;
  Vec2 robot;
};

Result<HallwayRun> drive_down(const StudyScene& scene, std::uint64_t seed) {
  Result<SimulatedDrive> drive = simulate_drive(scene.scene, seed, paper_filters());
  if (!drive) return drive.error();
  HallwayRun run;
  LocalMapper mapper;
  look_along(drive->readings, look_step_m, mapper, [&](const Reading& reading) {
    run.robot = reading.T_world_robot.position;
    if (run.robot.x < first_look_m) return;
    run.last = mapper.maps();
    Look look{run.robot.x, {}};
    for (std::size_t v = 0; v < views.size(); ++v)
      look.passages[v] = passage_ahead(run.last.*views[v].map, run.robot.x + scene.scene.robot.radius_m);
    run.looks.push_back(look);
  });
  return run;
}

using Runs = std::vector<HallwayRun>;

// The moment of Fig. 9: the robot is just before the opening.
std::vector<double> last_lanes_m(const Runs& runs, std::size_t view) {
  return figures(runs, [&](const HallwayRun& run) {
    return run.looks.empty() ? no_figure : run.looks.back().passages[view].lane_m;
  });
}

template <class Figure>
std::vector<double> means(const Runs& runs, const Figure& figure) {
  return figures(runs, [&](const HallwayRun& run) {
    double sum = 0.0;
    for (const Look& look : run.looks) sum += figure(look);
    return sum / double(run.looks.size());
  });
}

StudyTable table_of(const Runs& runs) {
  StudyTable table;
  table.title = "Is there a way ahead?";
  table.note =
      "Over the next 2 m of the hallway, 1.40 m wide. Lane: the widest straight strip free of points; the robot passes "
      "if it is 0.50 m. Disc: the largest that gets through on any way between the points. Local maps of the newest "
      "250 "
      "arcs after the test for company of Appendix B.";
  table.layout = TableLayout::matrix;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const std::string name(views[v].name);
    const std::string paper = v == 0 ? "blocked" : v == 1 ? "passable" : "";
    table.rows.push_back(row_of({"lane before the opening", name, "m", 2}, paper, last_lanes_m(runs, v)));
    table.rows.push_back(row_of({"lane, mean over the drive", name, "m", 2}, no_figure,
                                means(runs, [&](const Look& look) { return look.passages[v].lane_m; })));
    table.rows.push_back(row_of({"disc, mean over the drive", name, "m", 2}, no_figure,
                                means(runs, [&](const Look& look) { return look.passages[v].disc_m; })));
    table.rows.push_back(row_of({"looks with a lane", name, "", 2}, no_figure, means(runs, [&](const Look& look) {
                                  return look.passages[v].lane_m >= lane_m ? 1.0 : 0.0;
                                })));
  }
  return table;
}

Image picture_of(const StudyScene& scene, const HallwayRun& run, std::span<const MapPoint> map) {
  MapPicture picture({{run.robot.x - 2.0, -1.2}, {run.robot.x + 4.5, 1.2}}, 800);
  picture.add_surfaces(scene.scene.world);
  std::vector<Vec2> rim;
  for (int k = 0; k <= 36; ++k) rim.push_back(run.robot + scene.scene.robot.radius_m * unit(degrees(10.0 * k)));
  picture.add_line(rim, {0, 0, 0}, 2);
  picture.add_points(map, 6);
  return picture.image();
}

}  // namespace

Result<StudySection> hallway(const StudyHost& host, StudyProgress& progress) {
  Result<StudyScene> scene = host.scene("hallway");
  if (!scene) return scene.error();
  const auto runs = run_tasks<HallwayRun>(host, std::size_t(host.seeds), progress,
                                          [&](std::size_t k) { return drive_down(*scene, k + 1); });
  if (!runs) return runs.error();
  StudySection section;
  section.id = "hallway";
  section.title = "A narrow hallway (Fig. 9)";
  const FigureFormat metres{.unit = "m", .decimals = 2};
  const std::string source = "Section 5.A, Fig. 9";
  section.claims = {
      claim_at_least({"S0-hall-passable", "Passable with ATM and arc carving: a lane of 0.50 m", source},
                     last_lanes_m(*runs, 1), lane_m, metres),
      claim_less({"S0-hall-blocked", "Blocked with ATM and centres of arcs: no lane of 0.50 m", source},
                 last_lanes_m(*runs, 0), std::vector<double>(runs.value().size(), lane_m), metres),
      claim_less(
          {"S0-hall-wider", "The lane of ATM and centres of arcs is narrower than that of ATM and arc carving", source},
          last_lanes_m(*runs, 0), last_lanes_m(*runs, 1), metres)};
  section.tables.push_back(table_of(*runs));
  const HallwayRun& first = runs.value().front();
  for (std::size_t v = 0; v < 3; ++v)
    section.pictures.push_back({"hallway-" + std::to_string(v + 1),
                                std::string(views[v].name) + ", seed 1" +
                                    (v == 0   ? " (Fig. 9a)"
                                     : v == 1 ? " (Fig. 9b)"
                                              : "") +
                                    ". Blue: medians, green: carved, yellow: centres of arcs.",
                                picture_of(*scene, first, first.last.*views[v].map)});
  section.remarks = {
      "Centres of arcs narrow the hallway, as in the paper, and arc carving opens it again. They do not close it here: "
      "how far centres reach into the way grows with the range at which a rough wall or a jamb is heard off the axis, "
      "and "
      "with the width of the hallway, which the paper does not print."};
  return section;
}

}  // namespace echoarc::studies::silver
