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
#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

struct EvidenceGridOptions {
  double cell_m = 0.05;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamProfile profile = BeamProfile::gaussian;
  double angular_sigma = 0.5;
  double range_sigma_m = 0.02;
  double occupied_peak = 0.85;
  double free_floor = 0.25;
  double no_echo_weight = 0.5;
  bool range_confidence = false;
  double occupied_threshold = 0.65;
  double free_threshold = 0.35;

  static constexpr auto fields() {
    using O = EvidenceGridOptions;
    return std::tuple_cat(
        grid_fields<O>(),
        std::tuple{
            field("profile", &O::profile,
                  {.doc = "how certainty falls from the beam's axis to its edge",
                   .source = "[Choset03] II-B: gaussian; [Barshan07] eqs. 3, 6: parabolic"}),
            field("angular_sigma", &O::angular_sigma,
                  {.min = 0.05, .max = 10.0, .doc = "standard deviation of the gaussian profile, in half beam widths"}),
            field("range_sigma_m", &O::range_sigma_m,
                  {.unit = "m",
                   .min = 0.001,
                   .max = 1.0,
                   .doc = "standard deviation of a range; the band is 4 of them deep"}),
            field(
                "occupied_peak", &O::occupied_peak,
                {.min = 0.501, .max = 0.999, .doc = "p(occupied) that one echo gives a cell on the axis at its range"}),
            field("free_floor", &O::free_floor,
                  {.min = 0.001,
                   .max = 0.499,
                   .doc = "p(occupied) that one echo gives a cell on the axis before its range"}),
            field(
                "no_echo_weight", &O::no_echo_weight,
                {.min = 0.0,
                 .max = 1.0,
                 .doc = "weight of silence against that of an echo when it clears, up to the sensor's trusted range"}),
            field("range_confidence", &O::range_confidence,
                  {.doc = "let certainty fall linearly with range, to 0 at the sensor's maximum range"}),
            field("occupied_threshold", &O::occupied_threshold,
                  {.min = 0.5, .max = 1.0, .doc = "a cell is occupied when p reaches this"}),
            field("free_threshold", &O::free_threshold,
                  {.min = 0.0, .max = 0.5, .doc = "a cell is free when p does not exceed this"})});
  }
};

/// Log-odds of a cell in fixed point: the range of 16 bits is the clamp |l| <= 8 of the method, so that saturating
/// arithmetic clamps at no cost. One unit is 2^-12.
inline constexpr double log_odds_clamp = 8.0;
inline constexpr double log_odds_unit = log_odds_clamp / 32768.0;

/// The occupancy grid with a Gaussian sonar model, in clamped log-odds: l <- l + ln(p / (1 - p)), |l| <= 8.
///
/// Independent readings add up as Bayes' rule has it, and the clamp keeps every cell within reach of change: what was
/// free a thousand times is occupied again after a few echoes. Silence clears too, with `no_echo_weight`, but only to
/// the sensor's trusted range, for a slanted wall is as silent as an empty room. Bistatic readings use half the path
/// length as distance and the bearing from the midpoint of the sensors.
///
/// A reading changes each cell by the model's log-odds rounded to the unit; the fast form approximates the model by
/// polynomials and differs from the rounded exact value by one unit at most.
class EvidenceGrid {
 public:
  using Options = EvidenceGridOptions;
  using Map = TiledGrid<std::int16_t>;
  static constexpr std::string_view name = "evidence";

  explicit EvidenceGrid(Options options = {});
  EvidenceGrid(EvidenceGrid&&) noexcept;
  EvidenceGrid& operator=(EvidenceGrid&&) noexcept;
  ~EvidenceGrid();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& /*executor*/) {}  // every reading is in the grid as soon as it is inserted
  /// Log-odds in units of `log_odds_unit`.
  [[nodiscard]] const Map& map() const { return grid_; }
  [[nodiscard]] double cell_log_odds(Cell cell) const { return grid_.value(cell) * log_odds_unit; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] Trace trace(const Reading& reading) const;
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<EvidenceGrid> restore(std::span<const std::byte> bytes);

 private:
  class Planner;

  void apply_plan(Executor& executor);

  Options options_;
  Map grid_;
  InsertCounters counters_;
  std::unique_ptr<Planner> planner_;
};

static_assert(MappingMethod<EvidenceGrid>);

}  // namespace echoarc
