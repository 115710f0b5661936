// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

struct NumakuraOptions {
  double cell_m = 0.05;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  double free_step = 1.0;
  double obstacle_step = 3.0;
  double reliable_range_m = 3.0;
  double outlier_weight = 0.1;
  double no_echo_weight = 0.5;
  bool geometry_test = true;
  double min_baseline_m = 0.0254;
  bool consistency_test = true;
  double jump_m = 0.3;
  int beginning_scans = 10;
  double occupied_threshold = 1.0;
  double free_threshold = 1.0;

  static constexpr auto fields() {
    using O = NumakuraOptions;
    return std::tuple_cat(
        grid_fields<O>(),
        std::tuple{
            field("free_step", &O::free_step,
                  {.min = 0.0,
                   .max = 100.0,
                   .doc = "p: what a reading adds to the cells inside its sector",
                   .source = "[Numakura] eq. 1, without a number"}),
            field("obstacle_step", &O::obstacle_step,
                  {.min = 0.0,
                   .max = 100.0,
                   .doc = "q: what a reading takes from the cells of its arc",
                   .source = "[Numakura] eq. 2, without a number"}),
            field("reliable_range_m", &O::reliable_range_m,
                  {.unit = "m",
                   .min = 0.01,
                   .max = 1000.0,
                   .doc = "D_H: beyond it a reading of range d counts D_H / d",
                   .source = "[Numakura] 4.1, without a number"}),
            field("outlier_weight", &O::outlier_weight,
                  {.min = 0.0, .max = 1.0, .doc = "epsilon: weight of an outlier", .source = "[Numakura] eq. 3"}),
            field(
                "no_echo_weight", &O::no_echo_weight,
                {.min = 0.0,
                 .max = 1.0,
                 .doc = "weight of silence when it clears, up to the sensor's trusted range; 0: silence says nothing"}),
            field("geometry_test", &O::geometry_test,
                  {.doc = "test 1: an outlier is a reading whose beam meets the surface at a slant",
                   .source = "[Numakura] 5.1"}),
            field("min_baseline_m", &O::min_baseline_m,
                  {.unit = "m",
                   .min = 0.0,
                   .max = 10.0,
                   .doc = "test 1 needs successive surface points at least this far apart"}),
            field("consistency_test", &O::consistency_test,
                  {.doc = "test 2: an outlier is a reading that jumps and passes through a mapped obstacle",
                   .source = "[Numakura] 5.2"}),
            field("jump_m", &O::jump_m,
                  {.unit = "m",
                   .min = 0.0,
                   .max = 1000.0,
                   .doc = "test 2 looks at readings that differ by more from the one before"}),
            field("beginning_scans", &O::beginning_scans,
                  {.unit = "scans", .min = 0, .max = 1000000, .doc = "test 2 is not used before that many scans"}),
            field("occupied_threshold", &O::occupied_threshold,
                  {.min = 1e-3, .max = 1000.0, .doc = "a cell is occupied when its value does not exceed minus this"}),
            field("free_threshold", &O::free_threshold,
                  {.min = 1e-3, .max = 1000.0, .doc = "a cell is free when its value reaches this"})});
  }
};

/// Values of cells in fixed point: one unit is 2^-20. Sums then depend neither on their order nor on rounding, up to
/// the clamp at +-1000.
inline constexpr double numakura_unit = 1.0 / (1 << 20);
inline constexpr double numakura_clamp = 1000.0;

/// How many readings each test called outliers; one that both did is in both.
struct OutlierCounters {
  std::uint64_t geometry = 0;
  std::uint64_t consistency = 0;
  friend bool operator==(const OutlierCounters&, const OutlierCounters&) = default;
};

/// Free and obstacle evidence accumulated with outlier detection ([Numakura] 4, 5). **Free is positive, obstacles are
/// negative**, 0 is unknown: a reading of range d adds C_f = I u(d) p to the cells inside its sector and takes
/// C_o = I u(d) q from the cells on its arc, with u(d) = min(1, D_H / d) and I = epsilon for an outlier, else 1.
///
/// The readings of one scan (`Reading::scan`) are all judged against the map before that scan. They are added to the
/// map when the scan ends; `finish` shows them early without changing how later readings of the scan are judged. A scan
/// of more than 1024 readings, or one that touches a quarter of the memory limit, is cut in two. Bistatic readings use
/// their ellipse, half the path as range, and bearings from the midpoint of the sensors; silence clears.
class Numakura {
 public:
  using Options = NumakuraOptions;
  using Map = TiledGrid<std::int32_t>;
  static constexpr std::string_view name = "numakura";

  explicit Numakura(Options options = {});
  Numakura(Numakura&&) noexcept;
  Numakura& operator=(Numakura&&) noexcept;
  ~Numakura();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor);
  /// In units of `numakura_unit`.
  [[nodiscard]] const Map& map() const { return grid_; }
  [[nodiscard]] double cell_value(Cell cell) const { return grid_.value(cell) * numakura_unit; }
  [[nodiscard]] const OutlierCounters& outliers() const;
  [[nodiscard]] std::vector<Tally> tallies() const {
    return {{"outliers_geometry", outliers().geometry}, {"outliers_consistency", outliers().consistency}};
  }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's arc crosses the cell at `position`.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Numakura> restore(std::span<const std::byte> bytes);

 private:
  class Judge;     // the outlier tests and what they remember of the scan before
  class OpenScan;  // the readings of the present scan, not yet in the map

  void insert_one(const Reading& reading);

  Options options_;
  Map grid_;
  InsertCounters counters_;
  std::unique_ptr<Judge> judge_;
  std::unique_ptr<OpenScan> open_;
};

static_assert(MappingMethod<Numakura>);

}  // namespace echoarc
