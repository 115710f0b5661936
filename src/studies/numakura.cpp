// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/numakura.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/mapping/numakura.hpp"
#include "studies/findings.hpp"
#include "studies/grid_scores.hpp"

namespace echoarc::studies {
namespace {

struct Variant {
  std::string_view name;
  std::string_view short_name;
  bool geometry;
  bool consistency;
};

constexpr std::array<Variant, 4> variants{{{"(1) no test", "map (1)", false, false},
                                           {"(2) test 1, geometry", "map (2)", true, false},
                                           {"(3) test 2, consistency", "map (3)", false, true},
                                           {"(4) both tests", "map (4)", true, true}}};

struct Room {
  std::string_view scene;
  std::string_view id;
  std::string_view title;
  std::string_view figure;
};

constexpr std::array<Room, 2> rooms{{{"numakura-a", "a", "Room with rectangular obstacles (Fig. 9)", "Fig. 9"},
                                     {"numakura-b", "b", "Room with concave corners (Fig. 10)", "Fig. 10"}}};

using Maps = std::vector<GridScore>;  // of one seed, in the order of the variants

std::vector<AnyMethod> four_methods() {
  std::vector<AnyMethod> methods;
  for (const Variant& variant : variants) {
    NumakuraOptions options;
    options.no_echo_weight = 0.0;  // the paper maps distances; a sonar that hears nothing has none
    options.geometry_test = variant.geometry;
    options.consistency_test = variant.consistency;
    methods.emplace_back(Numakura(options));
  }
  return methods;
}

std::vector<double> false_area_m2(const std::vector<Maps>& runs, std::size_t variant) {
  return figures(runs, [&](const Maps& maps) {
    return double(maps[variant].cells.false_free()) * maps[variant].cells.cell_area_m2;
  });
}

Claim fewer(const Room& room, const std::vector<Maps>& runs, std::size_t better, std::size_t worse) {
  const std::string id =
      std::string("S4-a-") + std::string(room.id) + "-" + std::to_string(better + 1) + "-" + std::to_string(worse + 1);
  const std::string text = std::string("False free area of ") + std::string(variants[better].short_name) + " < of " +
                           std::string(variants[worse].short_name);
  return claim_less({id, text, "Section 6, " + std::string(room.figure)}, false_area_m2(runs, better),
                    false_area_m2(runs, worse), {.unit = "m²", .decimals = 2});
}

StudyTable table_of(const std::vector<Maps>& runs) {
  StudyTable table;
  table.id = "S4-a";
  table.title = "False free area and what is rightly free";
  table.note =
      "False free: cells of 5 cm that the map calls free though a surface runs through them or they lie behind one. "
      "The paper shows pictures and gives no numbers; its order is none, one test, both.";
  table.layout = TableLayout::matrix;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const std::string name(variants[v].name);
    const auto area = [&](auto count) {
      return figures(runs, [&](const Maps& maps) { return double(count(maps[v].cells)) * maps[v].cells.cell_area_m2; });
    };
    table.rows.push_back(
        row_of({"false free", name, "m²", 2}, no_figure, area([](const FreeCells& c) { return c.false_free(); })));
    table.rows.push_back(
        row_of({"of it behind surfaces", name, "m²", 2}, no_figure, area([](const FreeCells& c) { return c.behind; })));
    table.rows.push_back(
        row_of({"rightly free, share of the room", name, "", 3}, no_figure, figures(runs, [&](const Maps& maps) {
                 const FreeCells& cells = maps[v].cells;
                 return double(cells.true_free) / double(cells.reachable);
               })));
  }
  return table;
}

StudySection section_of(const Room& room, const StudyScene& scene, const std::vector<Maps>& runs) {
  StudySection section;
  section.id = "room-" + std::string(room.id);
  section.title = std::string(room.title);
  for (const auto& [better, worse] : {std::pair{3, 1}, std::pair{3, 2}, std::pair{1, 0}, std::pair{2, 0}})
    section.claims.push_back(fewer(room, runs, std::size_t(better), std::size_t(worse)));
  section.tables.push_back(table_of(runs));
  for (std::size_t v = 0; v < variants.size(); ++v)
    section.pictures.push_back({"map-" + std::string(room.id) + "-" + std::to_string(v + 1),
                                std::string(variants[v].name) + ", seed 1. True surfaces in red.",
                                grid_picture(scene, runs.front()[v].states)});
  return section;
}

}  // namespace

Result<StudyReport> numakura(const StudyHost& host) {
  StudyReport report;
  report.name = "numakura";
  report.title = "Acquisition of an Environmental Map by Sonar Data for an Autonomous Mobile Robot with Web Interface";
  report.source = "Numakura, Shimizu Okatani, Maekawa; Saitama University";
  report.seeds = host.seeds;
  report.summary = {
      "The paper prints neither its rooms nor its parameters: rooms and steps are ours. A sonar that hears nothing "
      "changes no cell, for the paper maps distances and has no word for silence. With the default weight of silence "
      "all four maps are cleared alike behind slanted smooth walls, and their order drowns."};
  StudyProgress progress(host, rooms.size() * std::size_t(host.seeds));
  for (const Room& room : rooms) {
    Result<StudyScene> scene = host.scene(room.scene);
    if (!scene) return scene.error();
    const DenseGrid<CellState> truth = scene_truth(*scene, NumakuraOptions{}.cell_m);
    const auto runs = run_tasks<Maps>(host, std::size_t(host.seeds), progress, [&](std::size_t k) {
      return score_grids(*scene, k + 1, four_methods(), truth, k == 0);
    });
    if (!runs) return runs.error();
    report.sections.push_back(section_of(room, *scene, *runs));
  }
  return report;
}

}  // namespace echoarc::studies
