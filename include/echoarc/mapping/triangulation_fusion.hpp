// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/mapping/triangulation_window.hpp"

namespace echoarc {

/// Which triangulated points are shown ([Barshan07] 3.7, Tables 5 and 6).
enum class TriangulationShow { all, edges };
/// Where a point lies among its triangulations.
enum class TriangulationPosition { mean, median };

constexpr std::array<Choice<TriangulationShow>, 2> choices(TriangulationShow /*tag*/) {
  return {{{TriangulationShow::all, "all"}, {TriangulationShow::edges, "edges"}}};
}
constexpr std::array<Choice<TriangulationPosition>, 2> choices(TriangulationPosition /*tag*/) {
  return {{{TriangulationPosition::mean, "mean"}, {TriangulationPosition::median, "median"}}};
}

struct TriangulationOptions {
  double cell_m = 0.01;  ///< of the exported picture; the points themselves are exact
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  int threshold = 2;
  TriangulationShow show = TriangulationShow::all;
  int rows = 1024;
  int columns = 10;
  double column_m = 0.05;
  Angle column_turn = degrees(5.0);
  double range_max_m = 5.0;
  double baseline_min_m = 0.02;
  double gate_m = 0.25;
  double edge_m = 0.05;
  TriangulationPosition position = TriangulationPosition::mean;
  bool refine = false;
  double refine_sigma_m = 0.015;
  int min_neighbours = 0;
  double neighbour_radius_m = 0.2;

  static constexpr auto fields() {
    using O = TriangulationOptions;
    return std::tuple_cat(
        grid_fields<O>(),
        std::tuple{
            field("threshold", &O::threshold,
                  {.unit = "arcs",
                   .min = 1,
                   .max = 1000000,
                   .doc = "a point is kept when its reading meets at least this many older arcs there (n_t)",
                   .source = "[Barshan07] 4.2: 4 for the curve, 2 for rooms, 3 for corners"}),
            field("show", &O::show,
                  {.doc = "keep every triangulated point, or those alone that look like an edge",
                   .source = "[Barshan07] 3.7, Tables 5 and 6"}),
            field("rows", &O::rows,
                  {.unit = "arcs",
                   .min = 1,
                   .max = 1024,
                   .doc = "most sonars in a column of the window; those that report later are passed over",
                   .source = "[Barshan07] 3.7: as many as sonars"}),
            field("columns", &O::columns,
                  {.min = 1,
                   .max = 1000,
                   .doc = "columns of the window, the newest one included",
                   .source = "[Barshan07] 3.7: 10 in the original, 20 there"}),
            field("column_m", &O::column_m,
                  {.unit = "m",
                   .min = 0.0,
                   .max = 10.0,
                   .doc = "a column ends when the robot has moved so far",
                   .source = "[Barshan07] 3.7: 0.05 m in the original, 0.025 m there"}),
            field("column_turn_deg", &O::column_turn,
                  {.unit = "deg", .min = 0.0, .max = 180.0, .doc = "or when it has turned so far"}),
            field("range_max_m", &O::range_max_m,
                  {.unit = "m",
                   .min = 0.0,
                   .max = 1000.0,
                   .doc = "farther echoes are passed over",
                   .source = "[Barshan07] 3.7: less than 5 m"}),
            field("baseline_min_m", &O::baseline_min_m,
                  {.unit = "m", .min = 0.0, .max = 10.0, .doc = "sensor positions closer than this make no triangle"}),
            field("gate_m", &O::gate_m,
                  {.unit = "m",
                   .min = 0.0,
                   .max = 10.0,
                   .doc = "a triangulation this close to the mean of others belongs to them"}),
            field("edge_m", &O::edge_m,
                  {.unit = "m",
                   .min = 0.0,
                   .max = 10.0,
                   .doc = "a point is edge-like when none of its triangulations is farther from their mean",
                   .source = "[Barshan07] 3.7: a preset threshold"}),
            field("position", &O::position,
                  {.doc = "a point is the mean of its triangulations, or their median along and across the beam"}),
            field("refine", &O::refine,
                  {.doc = "move every point to where its arcs agree most on a local grid",
                   .source = "[Barshan07] 3.7: an optional refinement using a local grid map"}),
            field("refine_sigma_m", &O::refine_sigma_m,
                  {.unit = "m", .min = 0.001, .max = 1.0, .doc = "refine: standard deviation of a range"})},
        neighbour_fields<O>());
  }
};

/// One reading's triangulations that agree with one another ([Barshan07] 3.7).
struct Triangulation {
  Vec2 position;
  int successes = 0;             ///< n_t
  double max_deviation_m = 0.0;  ///< d_max, from the mean of the triangulations to the farthest
  bool edge = false;             ///< d_max does not exceed `edge_m`
  std::vector<Vec2> meetings;    ///< where the arc meets the older ones, newest of them first
  std::vector<PingId> support;   ///< the older pings, in the same order
};

/// Triangulation-based fusion ([Barshan07] 3.7, after Wijk and Christensen): in a sliding window of recent arcs every
/// reading of the newest column is intersected with all older ones; where many of them meet within a gate there is a
/// point, and where they meet sharply an edge or a pole. Takes circular arcs alone: bistatic readings are counted out.
/// Silence says nothing to it.
class TriangulationFusion {
 public:
  using Options = TriangulationOptions;
  using Map = PointMap;
  static constexpr std::string_view name = "tbf";
  static constexpr std::size_t max_hypotheses = 3;

  explicit TriangulationFusion(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& /*executor*/) {}
  /// Points in the order of their readings, labelled `edge` or `triangulated` and supported by the reading's own ping,
  /// then the older ones; `bound_m` reaches to the farther end of the reading's arc.
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  /// `used`: entered the window. `passed_over`: too far, or its sonar already stands in the column. `bistatic`.
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the arc of a reading passes within `gate_m` of a position.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<TriangulationFusion> restore(std::span<const std::byte> bytes);

  /// What the present window makes of a reading, whatever the threshold; no value when no older arc meets its own.
  [[nodiscard]] std::optional<Triangulation> triangulate(const Reading& reading) const;

 private:
  [[nodiscard]] std::optional<Triangulation> triangulate(const WindowArc& arc, TriangulationWindow::Place place) const;
  [[nodiscard]] bool shown(const Triangulation& found) const;
  [[nodiscard]] bool remember(const Reading& reading, const WindowArc& arc, const Triangulation& found);

  Options options_;
  TriangulationWindow window_;
  PointMap map_;
  std::size_t map_bytes_ = 0;
  InsertCounters counters_;
};

static_assert(MappingMethod<TriangulationFusion>);

}  // namespace echoarc
