// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <string_view>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/sector_raster.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

/// How the two evidences of a cell, p_E for empty and p_O for occupied, become one value P in [0, 1]. The paper says
/// that values between -1 and 1 are "transformed" and leaves the transform open ([Barshan07] 3.5).
enum class BayesCombination {
  difference,     ///< P = (1 + p_O - p_E) / 2
  moravec_elfes,  ///< P = (1 + v) / 2 with v = p_O where p_O >= p_E, else -p_E
  ratio,          ///< P = p_O / (p_O + p_E); 1/2 where both are 0
};
constexpr std::array<Choice<BayesCombination>, 3> choices(BayesCombination /*tag*/) {
  return {{{BayesCombination::difference, "difference"},
           {BayesCombination::moravec_elfes, "moravec_elfes"},
           {BayesCombination::ratio, "ratio"}}};
}

struct BayesUpdateOptions {
  double cell_m = 0.01;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  double threshold = 0.997;
  double near_field_m = 0.057;
  double range_error_m = 0.02;
  BayesCombination combination = BayesCombination::difference;

  static constexpr auto fields() {
    using O = BayesUpdateOptions;
    return std::tuple_cat(
        grid_fields<O>(), arc_fields<O>(),
        std::tuple{field("threshold", &O::threshold,
                         {.min = 0.0,
                          .max = 1.0,
                          .doc = "a cell is occupied when its value P exceeds this",
                          .source = "[Barshan07] 3.5, 4.2: 0.999 for the curve, 0.997 to 0.999 for rooms"}),
                   field("near_field_m", &O::near_field_m,
                         {.unit = "m",
                          .min = 0.0,
                          .max = 1.0,
                          .doc = "r_min: nothing is said to be empty nearer than this",
                          .source = "[Barshan07] 3.5 eq. 2"}),
                   field("range_error_m", &O::range_error_m,
                         {.unit = "m",
                          .min = 0.001,
                          .max = 1.0,
                          .doc = "r_epsilon: half the depth of the band called occupied",
                          .source = "[Barshan07] 3.5 eq. 5"}),
                   field("combination", &O::combination,
                         {.doc = "how the evidence for empty and for occupied becomes one value",
                          .source = "[Barshan07] 3.5 leaves it open; moravec_elfes: Moravec, Elfes 1985"})});
  }
};

/// The two evidences of a cell. Both start at 0, stay in [0, 1] and never fall.
struct BayesCell {
  double empty = 0.0;     ///< p_E
  double occupied = 0.0;  ///< p_O
  friend constexpr bool operator==(const BayesCell&, const BayesCell&) = default;
};

/// P of a cell; 1/2 where nothing is known.
[[nodiscard]] double bayes_value(const BayesCell& cell, BayesCombination combination);

/// The Bayesian update scheme for occupancy grids as published ([Barshan07] 3.5, after Elfes 1987): parabolic evidence
/// for empty below the arc and for occupied at it, gathered by p <- p + q - p q.
///
/// As published neither evidence can fall. A cell that many echoes have passed has p_E = 1 for good, and however many
/// echoes follow at the cell itself, P stays at 1/2: **what was once free cannot become occupied again**. The paper has
/// no rule for silence, so readings without an echo change nothing.
class BayesUpdate {
 public:
  using Options = BayesUpdateOptions;
  using Map = TiledGrid<BayesCell>;
  static constexpr std::string_view name = "bu";

  explicit BayesUpdate(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& /*executor*/) {}
  [[nodiscard]] const Map& map() const { return cells_; }
  [[nodiscard]] double value(Cell cell) const { return bayes_value(cells_.value(cell), options_.combination); }
  /// Occupied: P > threshold. Free: P < 1/2. Everything else is unknown.
  [[nodiscard]] CellState state(const BayesCell& cell) const;
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// Cells in P before and after; terms: sigma, theta, E_r, E_a, O_r, O_a, p_E, p_O of the reading.
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading adds to p_O of the cell at `position`.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<BayesUpdate> restore(std::span<const std::byte> bytes);

 private:
  [[nodiscard]] bool add(const Arc& arc);

  Options options_;
  Map cells_;
  SectorRaster raster_;
  InsertCounters counters_;
};

static_assert(MappingMethod<BayesUpdate>);

}  // namespace echoarc
