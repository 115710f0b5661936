// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/studies/map_picture.hpp"
#include "studies/choset/chapters.hpp"
#include "studies/choset/region_place.hpp"
#include "studies/findings.hpp"
#include "studies/simulated_drive.hpp"

namespace echoarc::studies::choset {
namespace {

constexpr Vec2 step{2.0, 2.62};  // of the two sheets of the top wall
constexpr double step_m = 0.15;

struct Sweep {
  std::size_t readings = 0;
  std::size_t echoes = 0;
  std::array<std::size_t, 3> regions{};  // by place
  bool sees_step = false;
  std::vector<DepthReturn> returns;
  std::vector<DepthRegion> found;

  [[nodiscard]] std::size_t at(RegionPlace place) const { return regions[static_cast<std::size_t>(place)]; }
};

Result<Sweep> turn_on_the_spot(const StudyScene& scene, const sim::World& world, std::uint64_t seed) {
  Result<SimulatedDrive> drive = simulate_drive(scene.scene, seed);
  if (!drive) return drive.error();
  Sweep sweep;
  sweep.readings = drive->readings.size();
  sweep.returns = depth_returns(drive->readings);
  for (const DepthReturn& heard : sweep.returns) sweep.echoes += std::isfinite(heard.depth_m) ? 1 : 0;
  sweep.found = depth_regions(scene.scene.drive.start.position, sweep.returns);
  for (const DepthRegion& region : sweep.found) {
    ++sweep.regions[static_cast<std::size_t>(place_of(region, world))];
    if (norm(region.echo_point() - step) <= step_m) sweep.sees_step = true;
  }
  return sweep;
}

StudyTable table_of(const std::vector<Sweep>& sweeps) {
  const auto count = [&](auto figure) { return figures(sweeps, figure); };
  StudyTable table;
  table.title = "Regions of constant depth in one turn on the spot";
  table.note =
      "A region: at least four neighbouring readings over 10 degrees or more within 3 cm of their mean. The paper "
      "draws "
      "its regions without counting them.";
  table.rows = {
      row_of({"readings", "16 sonars, 9 stops", "", 0}, 144, count([](const Sweep& s) { return s.readings; })),
      row_of({"echoes", "", "", 0}, no_figure, count([](const Sweep& s) { return s.echoes; })),
      row_of({"regions", "", "", 1}, no_figure, count([](const Sweep& s) { return s.found.size(); })),
      row_of({"regions on a surface", "within 0.10 m", "", 1}, no_figure,
             count([](const Sweep& s) { return s.at(RegionPlace::on_surface); })),
      row_of({"regions beyond a wall", "several reflections", "", 1}, "1",
             count([](const Sweep& s) { return s.at(RegionPlace::beyond); })),
      row_of({"regions in free space", "", "", 1}, "0",
             count([](const Sweep& s) { return s.at(RegionPlace::before); })),
      row_of({"sweeps with a region at the step of the sheets", "", "", 2}, "1",
             count([](const Sweep& s) { return s.sees_step ? 1.0 : 0.0; }))};
  return table;
}

// Fig. 11: every range over its bearing, those of regions marked.
Chart depth_chart(const Sweep& sweep) {
  ChartSeries all{.name = "readings", .mark = ChartMark::scatter};
  for (const DepthReturn& heard : sweep.returns) {
    all.x.push_back(wrap(heard.bearing).deg());
    all.y.push_back(heard.depth_m);
  }
  ChartSeries regions{.name = "regions of constant depth", .mark = ChartMark::scatter};
  for (const DepthRegion& region : sweep.found)
    for (const DepthReturn& heard : sweep.returns)
      if (std::ranges::find(region.pings, heard.ping) != region.pings.end()) {
        regions.x.push_back(wrap(heard.bearing).deg());
        regions.y.push_back(region.depth_m);
      }
  Chart chart;
  chart.title = "Ranges of one turn on the spot";
  chart.x.title = "bearing (degrees)";
  chart.y.title = "distance (m)";
  chart.series = {std::move(all), std::move(regions)};
  return chart;
}

// Fig. 12: readings as dots, regions as arcs, the walls, a cross where the robot is.
Image region_picture(const StudyScene& scene, const Sweep& sweep) {
  const Vec2 robot = scene.scene.drive.start.position;
  MapPicture picture(scene.scoring.region);
  picture.add_surfaces(scene.scene.world);
  for (const DepthReturn& heard : sweep.returns)
    if (std::isfinite(heard.depth_m))
      picture.add_points(std::array{robot + heard.depth_m * unit(heard.bearing)}, {0, 114, 178}, 4);
  for (const DepthRegion& region : sweep.found) {
    constexpr int pieces = 16;
    std::vector<Vec2> arc;
    for (int k = 0; k <= pieces; ++k)
      arc.push_back(robot + region.depth_m * unit(region.bearing + region.extent * (double(k) / pieces - 0.5)));
    picture.add_line(arc, {213, 94, 0}, 3);
  }
  constexpr double arm_m = 0.06;
  picture.add_line(std::array{robot - Vec2{arm_m, 0.0}, robot + Vec2{arm_m, 0.0}}, {0, 0, 0}, 2);
  picture.add_line(std::array{robot - Vec2{0.0, arm_m}, robot + Vec2{0.0, arm_m}}, {0, 0, 0}, 2);
  return picture.image();
}

}  // namespace

Result<StudySection> constant_depth(const StudyHost& host, StudyProgress& progress) {
  Result<StudyScene> scene = host.scene("rcd");
  if (!scene) return scene.error();
  const Result<sim::World> world = sim::World::make(scene->scene.world);
  if (!world) return world.error();
  const auto sweeps = run_tasks<Sweep>(host, std::size_t(host.seeds), progress,
                                       [&](std::size_t k) { return turn_on_the_spot(*scene, *world, k + 1); });
  if (!sweeps) return sweeps.error();
  StudySection section;
  section.id = "rcd";
  section.title = "Regions of constant depth (Figs. 11, 12)";
  const std::string source = "Section II-C, Fig. 12";
  section.claims = {claim_at_least({"S1-rcd-step", "The step of the two sheets gives a region of its own", source},
                                   figures(*sweeps, [](const Sweep& s) { return s.sees_step ? 1.0 : 0.0; }), 0.5,
                                   {.unit = "of the sweeps"}),
                    claim_at_least({"S1-rcd-beyond", "A region lies beyond a wall, from several reflections", source},
                                   figures(*sweeps, [](const Sweep& s) { return s.at(RegionPlace::beyond); }), 1.0,
                                   {.unit = "regions"})};
  section.tables.push_back(table_of(*sweeps));
  section.charts.push_back(
      {"rcd-ranges", "Ranges over bearings, seed 1 (Fig. 11)", depth_chart(sweeps.value().front())});
  section.pictures.push_back({"rcd-room", "Readings and regions in the room, seed 1 (Fig. 12)",
                              region_picture(*scene, sweeps.value().front())});
  section.remarks = {
      "Where no region lies beyond a wall, the room is to blame: between walls at right angles sound comes back to its "
      "own sonar only from straight ahead or out of a corner, and both look like surfaces. The paper does not print "
      "the "
      "plan of its room of cardboard sheets; sheets that lean against each other would make such ghosts."};
  return section;
}

}  // namespace echoarc::studies::choset
