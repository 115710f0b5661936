// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc {

struct CenterlineOptions {
  double cell_m = 0.01;  ///< of the exported picture; the points themselves are exact
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  int min_neighbours = 0;
  double neighbour_radius_m = 0.2;

  static constexpr auto fields() {
    return std::tuple_cat(grid_fields<CenterlineOptions>(), arc_fields<CenterlineOptions>(),
                          neighbour_fields<CenterlineOptions>());
  }
};

/// Point marking: one point per echo, in the middle of its arc - for a monostatic reading on the line of sight at the
/// measured range ([Barshan07] 3.1; the centerline model of [Silver04] 2.A). Nothing is ever rejected, so outliers stay
/// in the map. Silence says nothing to this method.
class Centerline {
 public:
  using Options = CenterlineOptions;
  using Map = PointMap;
  static constexpr std::string_view name = "centerline";

  explicit Centerline(Options options = {}) : options_(options) {}

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& /*executor*/) {}
  /// Points in the order of insertion, each supported by its ping; `bound_m` reaches to the farther end of the arc.
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's point lies at `position` (within `eps_length_m`).
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Centerline> restore(std::span<const std::byte> bytes);

 private:
  Options options_;
  PointMap map_;
  InsertCounters counters_;
};

static_assert(MappingMethod<Centerline>);

}  // namespace echoarc
