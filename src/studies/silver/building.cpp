// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/core/range_quantum.hpp"
#include "echoarc/studies/map_picture.hpp"
#include "studies/findings.hpp"
#include "studies/silver/building_charts.hpp"
#include "studies/silver/building_run.hpp"
#include "studies/silver/chapters.hpp"

namespace echoarc::studies::silver {
namespace {

using Runs = std::vector<BuildingRun>;
constexpr FigureFormat percent{.unit = "%", .decimals = 1, .factor = 100.0};

std::vector<double> unprocessed(const Runs& runs, Stamping BuildingRun::* stamping, Watched method) {
  return figures(runs, [&](const BuildingRun& run) {
    return (run.*stamping).arcs[static_cast<std::size_t>(method)].latency.unprocessed_share;
  });
}

std::vector<double> in_percent(std::vector<double> shares) {
  for (double& share : shares) share *= 100.0;
  return shares;
}

// Share of the arcs with radii in [low, high) that were unprocessed, over all looks.
std::vector<double> unprocessed_between(const Runs& runs, Watched method, double low_m, double high_m) {
  const RadiusBins bins;
  return figures(runs, [&](const BuildingRun& run) {
    const Latency& latency = run.study(method).latency;
    double arcs = 0.0;
    double waiting = 0.0;
    for (std::size_t b = 0; b < bins.count(); ++b) {
      if (bins.middle_m(b) < low_m || bins.middle_m(b) >= high_m || latency.arcs_by_radius[b] == 0) continue;
      arcs += double(latency.arcs_by_radius[b]);
      waiting += double(latency.arcs_by_radius[b]) * latency.share_by_radius[b];
    }
    return arcs > 0.0 ? waiting / arcs : no_figure;
  });
}

// Mean of a figure of the carved arcs with radii in [low, high), over arcs.
template <class Figure>
std::vector<double> carved_between(const Runs& runs, double low_m, double high_m, const Figure& figure) {
  const RadiusBins bins;
  return figures(runs, [&](const BuildingRun& run) {
    double arcs = 0.0;
    double sum = 0.0;
    const std::vector<AzimuthClass>& classes = run.study(Watched::carve).azimuth;
    for (std::size_t b = 0; b < classes.size(); ++b) {
      if (bins.middle_m(b) < low_m || bins.middle_m(b) >= high_m || classes[b].carved == 0) continue;
      arcs += double(classes[b].carved);
      sum += double(classes[b].carved) * figure(classes[b], bins.middle_m(b));
    }
    return arcs > 0.0 ? sum / arcs : no_figure;
  });
}

constexpr double everywhere_m = 10.0;

StudyTable table_one(const Runs& runs) {
  StudyTable table;
  table.id = "S0-T1";
  table.title = "Share of the history that is unprocessed (Table I)";
  table.note =
      "Looked at after every sweep once the history of 250 arcs is full. Polled: the same firings, told from registers "
      "that are read 30 times a second (Appendix A). Guard of one inch: a reading does not carve the last inch before "
      "its echo.";
  table.layout = TableLayout::matrix;
  struct Line {
    std::string name;
    Watched method;
    double paper;
  };
  const std::array<Line, 6> lines{{{"ATM", Watched::atm, 31.75},
                                   {"arc carving", Watched::carve, 55.59},
                                   {"arc carving and ATM", Watched::combined, 7.68},
                                   {"centerline", Watched::centerline, 0.0},
                                   {"arc carving, guard of one inch", Watched::carve_guarded, no_figure},
                                   {"arc carving and ATM, guard of one inch", Watched::combined_guarded, no_figure}}};
  for (const Line& line : lines) {
    table.rows.push_back(row_of({"stamped", line.name, "%", 2}, line.paper,
                                in_percent(unprocessed(runs, &BuildingRun::stamped, line.method))));
    table.rows.push_back(row_of({"polled", line.name, "%", 2}, no_figure,
                                in_percent(unprocessed(runs, &BuildingRun::polled, line.method))));
  }
  return table;
}

StudyTable tour_table(const Runs& runs, double floor_m2) {
  const auto each = [&](auto figure) { return figures(runs, figure); };
  const auto full = [&](Watched method) {
    return in_percent(each([&](const BuildingRun& run) { return run.study(method).fully_carved_share; }));
  };
  StudyTable table;
  table.title = "The tour";
  table.rows = {
      row_of({"arcs with better azimuth (S0-a)", "carved or crossed", "%", 1}, "> 92",
             in_percent(each(
                 [](const BuildingRun& run) { return 1.0 - run.study(Watched::combined).latency.unprocessed_share; }))),
      row_of({"arcs carved away (S0-b)", "no guard", "%", 1}, "> 20", full(Watched::carve)),
      row_of({"arcs carved away (S0-b)", "guard of one inch", "%", 1}, "> 20", full(Watched::carve_guarded)),
      row_of({"history (S0-c)", "", "arcs", 0}, 250, each([](const BuildingRun&) { return 250; })),
      row_of({"floor (S0-d)", "all of it", "m²", 0}, "> 5000", each([&](const BuildingRun&) { return floor_m2; })),
      row_of({"free space that readings covered", "corridors and a fifth of the rooms", "m²", 0}, no_figure,
             each([](const BuildingRun& run) { return run.mapped_m2; })),
      row_of({"length of the tour", "", "m", 0}, no_figure, each([](const BuildingRun& run) { return run.path_m; })),
      row_of({"pings", "", "", 0}, no_figure, each([](const BuildingRun& run) { return run.pings; }))};
  return table;
}

StudyTable accuracy_table(const Runs& runs) {
  StudyTable table;
  table.title = "Points of the final maps against the true surfaces (Figs. 13, 14)";
  table.layout = TableLayout::matrix;
  table.note =
      "The paper shows maps. Its words: arc carving and ATM end equally accurate; polling alone cleans the centerline "
      "map.";
  const auto add = [&](const std::string& name, auto accuracy) {
    table.rows.push_back(row_of({"median distance", name, "cm", 2}, no_figure,
                                figures(runs, [&](const BuildingRun& run) { return 100.0 * accuracy(run).median_m; })));
    table.rows.push_back(row_of({"within 10 cm", name, "%", 1}, no_figure, figures(runs, [&](const BuildingRun& run) {
                                  return 100.0 * accuracy(run).within_10cm;
                                })));
    table.rows.push_back(row_of({"points", name, "", 0}, no_figure,
                                figures(runs, [&](const BuildingRun& run) { return accuracy(run).points; })));
  };
  add("ATM, medians (Fig. 13a)", [](const BuildingRun& run) { return run.atm; });
  add("arc carving, error at most 10 cm (Fig. 13b)", [](const BuildingRun& run) { return run.carved; });
  add("centerline, polls dated as they are read (Fig. 14a)", [](const BuildingRun& run) { return run.naive_centers; });
  add("centerline, sonar polling (Fig. 14b)", [](const BuildingRun& run) { return run.polled.centers; });
  add("centerline, every ping stamped", [](const BuildingRun& run) { return run.stamped.centers; });
  return table;
}

std::vector<Claim> claims_of(const Runs& runs) {
  const auto share = [&](Watched method) { return unprocessed(runs, &BuildingRun::stamped, method); };
  const auto between = [&](Watched method, double low_m, double high_m) {
    return unprocessed_between(runs, method, low_m, high_m);
  };
  std::vector<double> improved = share(Watched::combined);
  for (double& value : improved) value = 1.0 - value;
  const auto length_deg = [](const AzimuthClass& c, double) { return radians(c.mean_length_rad).deg(); };
  const auto error_m = [](const AzimuthClass& c, double) { return c.mean_error_m; };
  const auto center_error_m = [](const AzimuthClass&, double radius_m) {
    return centerline_error_m(radius_m, degrees(22.5));
  };
  const std::string latency = "Section 5.B, Fig. 10";
  return {
      claim_less({"S0-T1-atm", "Unprocessed: combined < ATM", "Table I"}, share(Watched::combined), share(Watched::atm),
                 percent),
      claim_less({"S0-T1-carving", "Unprocessed: combined < arc carving", "Table I"}, share(Watched::combined),
                 share(Watched::carve), percent),
      claim_less({"S0-T1-order", "Unprocessed over all radii: ATM < arc carving", "Table I"}, share(Watched::atm),
                 share(Watched::carve), percent),
      claim_at_least({"S0-a", "More than 92 % of the arcs improved by either method", "Section 5.B"}, improved, 0.92,
                     percent),
      claim_at_least({"S0-b", "More than 20 % of the arcs carved away", "Section 5.C"},
                     figures(runs, [](const BuildingRun& run) { return run.study(Watched::carve).fully_carved_share; }),
                     0.20, percent),
      claim_less({"S0-e-atm", "ATM waits longer for far arcs: unprocessed below 1 m < beyond 2 m", latency},
                 between(Watched::atm, 0.0, 1.0), between(Watched::atm, 2.0, everywhere_m), percent),
      claim_less({"S0-e-carving", "Beyond 2 m: arc carving < ATM", latency}, between(Watched::carve, 2.0, everywhere_m),
                 between(Watched::atm, 2.0, everywhere_m), percent),
      claim_less({"S0-e-small", "Arc carving waits longest for the smallest arcs: beyond 2 m < below 0.5 m", latency},
                 between(Watched::carve, 2.0, everywhere_m), between(Watched::carve, 0.0, 0.5), percent),
      claim_less({"S0-e-length", "Carved arcs are narrower far away: mean length beyond 2 m < below 1 m",
                  "Section 5.C, Fig. 11"},
                 carved_between(runs, 2.0, everywhere_m, length_deg), carved_between(runs, 0.0, 1.0, length_deg),
                 {.unit = "deg", .decimals = 1}),
      claim_less({"S0-e-error", "Largest error of carved arcs < of their centres uncarved", "Section 5.C, Fig. 12"},
                 carved_between(runs, 0.0, everywhere_m, error_m),
                 carved_between(runs, 0.0, everywhere_m, center_error_m),
                 {.unit = "cm", .decimals = 1, .factor = 100.0})};
}

Image map_image(const StudyScene& scene, const Box& region, std::span<const Vec2> points, Rgb color,
                std::span<const Vec2> path, std::int32_t dot_px) {
  MapPicture picture(region, 900);
  picture.add_surfaces(scene.scene.world, {170, 170, 170}, 1);
  picture.add_line(path, {213, 94, 0}, 1);
  picture.add_points(points, color, dot_px);
  return picture.image();
}

void add_pictures(StudySection& section, const StudyScene& scene, const BuildingRun& run) {
  const Box whole = scene.scoring.region;
  const Box corner{scene.scene.drive.start.position - Vec2{3.0, 8.0},
                   scene.scene.drive.start.position + Vec2{21.0, 8.0}};
  const Rgb blue{0, 114, 178};
  const Rgb green{0, 158, 115};
  const Rgb black{20, 20, 20};
  section.pictures.push_back({"building", "The whole floor: final medians of ATM, and the tour in red (Fig. 7)",
                              map_image(scene, whole, run.atm_points, blue, run.path, 1)});
  section.pictures.push_back({"final-atm", "Final medians of ATM where the tour begins (Fig. 13a)",
                              map_image(scene, corner, run.atm_points, blue, {}, 3)});
  section.pictures.push_back({"final-carved", "Carved arcs with an error of at most 10 cm, same place (Fig. 13b)",
                              map_image(scene, corner, run.carved_points, green, {}, 3)});
  section.pictures.push_back({"naive", "Centres of arcs, polls dated as they are read (Fig. 14, without sonar polling)",
                              map_image(scene, corner, run.naive_points, black, {}, 3)});
  section.pictures.push_back({"polled", "Centres of arcs, firings told from the polls (Fig. 14, with sonar polling)",
                              map_image(scene, corner, run.polled_points, black, {}, 3)});
}

double floor_area_m2(const sim::WorldDescription& world) {
  if (world.walls.empty()) return 0.0;
  Box box{world.walls.front().a, world.walls.front().a};
  for (const sim::Wall& wall : world.walls)
    for (const Vec2 end : {wall.a, wall.b}) {
      box.low = {std::min(box.low.x, end.x), std::min(box.low.y, end.y)};
      box.high = {std::max(box.high.x, end.x), std::max(box.high.y, end.y)};
    }
  return (box.high.x - box.low.x) * (box.high.y - box.low.y);
}

std::vector<std::string> remarks() {
  return {
      "In the paper arc carving leaves more arcs unprocessed than ATM over all radii, because most of its arcs are "
      "very short: a robot that follows the generalized Voronoi graph close to things. Our tour keeps to the middle of "
      "corridors of 2 m, where few arcs are short. By radius the picture is the paper's: ATM waits longer the farther "
      "the echo, arc carving hardly depends on it.",
      "How much is carved depends on the guard. Without one, the error of the ranges makes a reading carve arcs of the "
      "very surface it has just measured; a guard of one range step prevents that and leaves more arcs untouched.",
      "Firings that sonar polling tells from the registers are dated so well that their maps equal those of stamped "
      "pings; polls dated as they are read misplace points."};
}

}  // namespace

Result<StudySection> building(const StudyHost& host, StudyProgress& progress) {
  Result<StudyScene> scene = host.scene("office");
  if (!scene) return scene.error();
  const Result<BuildingTruth> truth = building_truth(*scene);
  if (!truth) return truth.error();
  const NearestPoints surfaces(truth.value().surfaces);
  const int seeds = std::min(host.seeds, building_seeds);
  const auto runs = run_tasks<BuildingRun>(host, std::size_t(seeds), progress, [&](std::size_t k) {
    return tour_building(*scene, truth.value(), surfaces, k + 1, k == 0);
  });
  if (!runs) return runs.error();
  StudySection section;
  section.id = "building";
  section.title = "A building (Table I, Figs. 7, 10 to 14)";
  section.paragraphs = {
      "The robot drives a scripted tour of a procedural office floor at 0.127 m/s, one sweep of its 16 sonars a "
      "second. "
      "Every drive gives some 10^5 pings, so " +
      std::to_string(seeds) + " seeds are enough for the means below."};
  section.claims = claims_of(*runs);
  section.tables = {table_one(*runs), tour_table(*runs, floor_area_m2(scene->scene.world)), accuracy_table(*runs)};
  section.charts = {{"latency", "Unprocessed arcs by radius (Fig. 10)", latency_chart(*runs)},
                    {"length", "Angular length of carved arcs by radius (Fig. 11)", length_chart(*runs)},
                    {"error", "Largest error by radius (Fig. 12)", error_chart(*runs)}};
  section.remarks = remarks();
  add_pictures(section, *scene, runs.value().front());
  return section;
}

}  // namespace echoarc::studies::silver
