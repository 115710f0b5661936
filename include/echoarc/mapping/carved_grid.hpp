// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/mapping/carving_options.hpp"
#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

/// How a grid learns from carved arcs.
enum class CarvedGridMode {
  sensor_profile,  ///< at once, the band spread as the sensor's recent arcs survived carving
  deferred,        ///< when the arc leaves the history, the band on what is left of it
};
constexpr std::array<Choice<CarvedGridMode>, 2> choices(CarvedGridMode /*tag*/) {
  return {{{CarvedGridMode::sensor_profile, "sensor_profile"}, {CarvedGridMode::deferred, "deferred"}}};
}

struct CarvedGridOptions {
  double cell_m = 0.05;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  CarvedGridMode mode = CarvedGridMode::sensor_profile;
  int profile_arcs = 20;
  int profile_least = 5;
  int history = 250;
  double guard_m = 0.0;
  double max_range_m = 3.81;
  bool carve_with_timeouts = false;
  double angular_sigma = 0.5;
  double range_sigma_m = 0.02;
  double occupied_peak = 0.85;
  double free_floor = 0.25;
  double no_echo_weight = 0.5;
  double occupied_threshold = 0.65;
  double free_threshold = 0.35;

  static constexpr auto fields();
};

/// The occupancy grid of `EvidenceGrid` with a distribution of its own for each reading, computed from carved arcs
/// ([Silver04] 4): log-odds that add up, |l| <= 8.
///
/// `sensor_profile` replaces the Gaussian across the beam, for the occupied band, by the share of the sensor's recent
/// arcs that still contain each bearing; it has no delay. `deferred` waits until an arc leaves the history and then
/// inserts its band on what is left alone; arcs that were removed only clear. Silence, and echoes beyond
/// `max_range_m`, are inserted at once in both.
class CarvedGrid {
 public:
  using Options = CarvedGridOptions;
  using Map = TiledGrid<float>;
  static constexpr std::string_view name = "carved_grid";

  explicit CarvedGrid(Options options = {});
  CarvedGrid(CarvedGrid&&) noexcept;
  CarvedGrid& operator=(CarvedGrid&&) noexcept;
  ~CarvedGrid();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  /// In mode `deferred` the map holds the arcs of the history as they now are; they are taken back when more follow.
  void finish(Executor& executor);
  /// Log-odds.
  [[nodiscard]] const Map& map() const;
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// As those of `Carve`.
  [[nodiscard]] std::vector<Tally> tallies() const;
  /// In mode `deferred` as if the reading left the history uncarved.
  [[nodiscard]] Trace trace(const Reading& reading) const;
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<CarvedGrid> restore(std::span<const std::byte> bytes);

 private:
  class State;

  Options options_;
  InsertCounters counters_;
  std::unique_ptr<State> state_;
};

constexpr auto CarvedGridOptions::fields() {
  using O = CarvedGridOptions;
  return std::tuple_cat(
      std::tuple{field("mode", &O::mode,
                       {.doc = "spread a band at once as the sensor's recent arcs survived, or insert each arc when it "
                               "leaves the history, on what is left of it",
                        .source = "[Silver04] 4 leaves it open"}),
                 field("profile_arcs", &O::profile_arcs,
                       {.unit = "arcs",
                        .min = 1,
                        .max = 10'000,
                        .doc = "mode sensor_profile: recent arcs of a sensor that make its profile"}),
                 field("profile_least", &O::profile_least,
                       {.unit = "arcs",
                        .min = 1,
                        .max = 10'000,
                        .doc = "mode sensor_profile: with fewer the band is the gaussian one"})},
      carving_fields<O>(), arc_fields<O>(), grid_fields<O>(),
      std::tuple{
          field("angular_sigma", &O::angular_sigma,
                {.min = 0.05, .max = 10.0, .doc = "standard deviation of the gaussian profile, in half beam widths"}),
          field("range_sigma_m", &O::range_sigma_m,
                {.unit = "m",
                 .min = 0.001,
                 .max = 1.0,
                 .doc = "standard deviation of a range; the band is 4 of them deep"}),
          field(
              "occupied_peak", &O::occupied_peak,
              {.min = 0.501, .max = 0.999, .doc = "p(occupied) that one echo gives a cell at its range, at the most"}),
          field("free_floor", &O::free_floor,
                {.min = 0.001,
                 .max = 0.499,
                 .doc = "p(occupied) that one echo gives a cell on the axis before its range"}),
          field("no_echo_weight", &O::no_echo_weight,
                {.min = 0.0,
                 .max = 1.0,
                 .doc = "weight of silence against that of an echo when it clears, up to the sensor's trusted range"}),
          field("occupied_threshold", &O::occupied_threshold,
                {.min = 0.5, .max = 1.0, .doc = "a cell is occupied when p reaches this"}),
          field("free_threshold", &O::free_threshold,
                {.min = 0.0, .max = 0.5, .doc = "a cell is free when p does not exceed this"})});
}

static_assert(MappingMethod<CarvedGrid>);

}  // namespace echoarc
