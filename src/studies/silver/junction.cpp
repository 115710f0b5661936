// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
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

// The scene's facing wall is x = 0; points this near to it, as wide as both corridors are seen, are counted.
constexpr Strip facing_wall{{0.0, -2.0}, {0.0, 2.0}, 0.15, 0.15};
constexpr double farthest_m = 4.0;
constexpr double look_step_m = 0.25;
constexpr std::size_t appears = 3;  // points: by then somebody would see a wall

struct View {
  std::string_view name;
  std::vector<MapPoint> LocalMaps::* map;
};
constexpr std::array<View, 4> views{{{"ATM", &LocalMaps::atm},
                                     {"centerline", &LocalMaps::centerline},
                                     {"arc carving", &LocalMaps::carved_centerline},
                                     {"arc carving, carved arcs alone", &LocalMaps::carved}}};

struct Look {
  double distance_m = 0.0;
  std::array<std::size_t, views.size()> points{};
};

struct JunctionRun {
  std::vector<Look> looks;
  LocalMaps early;  ///< 2 m away
  double early_distance_m = 0.0;
};

Result<JunctionRun> drive_up(const StudyScene& scene, std::uint64_t seed) {
  Result<SimulatedDrive> drive = simulate_drive(scene.scene, seed, paper_filters());
  if (!drive) return drive.error();
  JunctionRun run;
  LocalMapper mapper;
  look_along(drive->readings, look_step_m, mapper, [&](const Reading& reading) {
    Look look{-reading.T_world_robot.position.x, {}};
    if (look.distance_m > farthest_m) return;
    LocalMaps maps = mapper.maps();
    for (std::size_t v = 0; v < views.size(); ++v)
      look.points[v] = count_points(positions(maps.*views[v].map), facing_wall);
    run.looks.push_back(look);
    if (look.distance_m < 2.0) return;
    run.early = std::move(maps);
    run.early_distance_m = look.distance_m;
  });
  return run;
}

using Runs = std::vector<JunctionRun>;

// From where on the wall stays in the map; 0: never.
std::vector<double> appearance_m(const Runs& runs, std::size_t view) {
  return figures(runs, [&](const JunctionRun& run) {
    double distance_m = 0.0;
    for (auto look = run.looks.rbegin(); look != run.looks.rend() && look->points[view] >= appears; ++look)
      distance_m = look->distance_m;
    return distance_m;
  });
}

std::vector<double> mean_points(const Runs& runs, std::size_t view) {
  return figures(runs, [&](const JunctionRun& run) {
    double sum = 0.0;
    for (const Look& look : run.looks) sum += double(look.points[view]);
    return sum / double(run.looks.size());
  });
}

// Points on the wall over distance, the mean over the seeds within their least and most. All drives look at the same
// distances but for a few millimetres.
Chart chart_of(const Runs& runs) {
  Chart chart;
  chart.title = "Points on the facing wall";
  chart.x.title = "distance to the wall (m)";
  chart.y.title = "points in the local map";
  for (std::size_t v = 0; v < views.size(); ++v) {
    ChartSeries series{.name = std::string(views[v].name)};
    for (std::size_t k = 0; k < runs.front().looks.size(); ++k) {
      std::vector<double> counts;
      for (const JunctionRun& run : runs)
        if (k < run.looks.size()) counts.push_back(double(run.looks[k].points[v]));
      const Spread spread = spread_of(counts);
      series.x.push_back(runs.front().looks[k].distance_m);
      series.y.push_back(spread.mean);
      series.low.push_back(spread.min);
      series.high.push_back(spread.max);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

StudyTable table_of(const Runs& runs) {
  StudyTable table;
  table.title = "When the facing wall appears";
  table.note =
      "Points within 0.15 m of the wall in the local map of the newest 250 arcs, from 4 m to 0.8 m before it. It "
      "appears where it has three points and keeps them; 0: never.";
  table.layout = TableLayout::matrix;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const std::string name(views[v].name);
    const std::string paper = v == 0 ? "late" : v == 1 || v == 2 ? "early" : "";
    table.rows.push_back(row_of({"appears at", name, "m", 2}, paper, appearance_m(runs, v)));
    table.rows.push_back(row_of({"points, mean over the way", name, "", 1}, no_figure, mean_points(runs, v)));
  }
  return table;
}

Image picture_of(const StudyScene& scene, std::span<const MapPoint> map) {
  MapPicture picture({{-6.0, -3.0}, {0.5, 3.0}}, 560);
  picture.add_surfaces(scene.scene.world);
  picture.add_points(map, 5);
  return picture.image();
}

}  // namespace

Result<StudySection> junction(const StudyHost& host, StudyProgress& progress) {
  Result<StudyScene> scene = host.scene("junction");
  if (!scene) return scene.error();
  const auto runs = run_tasks<JunctionRun>(host, std::size_t(host.seeds), progress,
                                           [&](std::size_t k) { return drive_up(*scene, k + 1); });
  if (!runs) return runs.error();
  StudySection section;
  section.id = "junction";
  section.title = "Up to the bar of a T (Fig. 4)";
  const std::string source = "Section 2.D, Fig. 4";
  const FigureFormat metres{.unit = "m", .decimals = 2};
  section.claims = {
      claim_less({"S0-junction-centerline", "The wall appears later in the ATM map than in the centerline map", source},
                 appearance_m(*runs, 0), appearance_m(*runs, 1), metres),
      claim_less({"S0-junction-carving", "The wall appears later in the ATM map than in that of arc carving",
                  "Section 3, Fig. 4"},
                 appearance_m(*runs, 0), appearance_m(*runs, 2), metres)};
  section.tables.push_back(table_of(*runs));
  section.charts.push_back({"junction-points", "Mean over the seeds within least and most", chart_of(*runs)});
  const JunctionRun& first = runs.value().front();
  const std::string when = ", " + figure_text(first.early_distance_m, 1, "m") + " away, seed 1";
  const std::array<std::string_view, 3> figures_of{" (Fig. 4a)", " (Fig. 4b)", ""};
  for (std::size_t v = 0; v < figures_of.size(); ++v)
    section.pictures.push_back({"junction-" + std::to_string(v + 1),
                                std::string(views[v].name) + when + std::string(figures_of[v]),
                                picture_of(*scene, first.early.*views[v].map)});
  section.remarks = {
      "On a straight way towards a wall the arcs of the front sonar never cross: they lie behind each other. Medians "
      "need "
      "arcs of different sonars that hear the same place from the side, which come late or, on this way, not at all."};
  return section;
}

}  // namespace echoarc::studies::silver
