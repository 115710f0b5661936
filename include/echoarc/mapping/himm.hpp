// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>
#include <vector>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/ray_raster.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

struct HimmOptions {
  double cell_m = 0.10;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  int increment = 3;
  int decrement = 1;
  int threshold = 6;
  bool growth_rate = false;

  static constexpr auto fields() {
    using O = HimmOptions;
    return std::tuple_cat(
        grid_fields<O>(),
        std::tuple{
            field("increment", &O::increment,
                  {.min = 1, .max = 15, .doc = "certainty an echo adds to its cell", .source = "[Borenstein91]"}),
            field("decrement", &O::decrement,
                  {.min = 0,
                   .max = 15,
                   .doc = "certainty an echo takes from the cells between the sensor and its own",
                   .source = "[Borenstein91]"}),
            field("threshold", &O::threshold,
                  {.min = 1, .max = 15, .doc = "a cell is occupied from this certainty on"}),
            field("growth_rate", &O::growth_rate,
                  {.doc = "an echo also adds half the certainties of the eight neighbours to its cell, so that "
                          "clusters grow faster than lone cells",
                   .source = "[Borenstein91], growth rate operator"})});
  }
};

/// A cell: its certainty of being occupied, and whether any reading has reached it.
struct HimmCell {
  static constexpr int max_certainty = 15;
  std::uint8_t certainty = 0;  ///< 0 to 15
  std::uint8_t visited = 0;    ///< 0 or 1
  friend constexpr bool operator==(HimmCell, HimmCell) = default;
};

/// Histogramic in-motion mapping ([Borenstein91], [Choset03] II-A): an echo raises the cell on the acoustic axis at the
/// measured range and lowers those before it; nothing else of the arc is touched. Fast, and as good as the robot's
/// motion makes it. Silence lowers the cells up to the trusted range. Bistatic readings have no axis and are left out.
class Himm {
 public:
  using Options = HimmOptions;
  using Map = TiledGrid<HimmCell>;
  static constexpr std::string_view name = "himm";

  explicit Himm(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& /*executor*/) {}
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// "bistatic": readings left out because transmitter and receiver have no common axis.
  [[nodiscard]] std::vector<Tally> tallies() const { return {{"bistatic", bistatic_}}; }
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's echo raises the cell at `position`.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Himm> restore(std::span<const std::byte> bytes);

 private:
  /// What a reading says along its axis: up to `length_m` from the sensor there is nothing, and where `hits`, something
  /// at `end`.
  struct Beam {
    Vec2 origin;
    Vec2 direction;
    double length_m = 0.0;
    bool hits = false;
    Cell end;
  };
  [[nodiscard]] std::optional<Beam> beam_of(const Reading& reading) const;
  [[nodiscard]] std::vector<Cell> passed_cells(const Beam& beam) const;
  [[nodiscard]] bool apply(const Beam& beam);
  [[nodiscard]] int raised(Cell cell) const;
  [[nodiscard]] int lowered(Cell cell) const;

  Options options_;
  Map map_;
  InsertCounters counters_;
  std::uint64_t bistatic_ = 0;
};

static_assert(MappingMethod<Himm> && Tallying<Himm>);

}  // namespace echoarc
