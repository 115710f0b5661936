// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "echoarc/mapping/atm_options.hpp"
#include "echoarc/mapping/carving_options.hpp"
#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc {

/// What becomes of an arc's carved point when the arc has a median, too.
enum class Combine {
  both,        ///< the map holds both
  prefer_atm,  ///< the median alone
};
constexpr std::array<Choice<Combine>, 2> choices(Combine /*tag*/) {
  return {{{Combine::both, "both"}, {Combine::prefer_atm, "prefer_atm"}}};
}
constexpr std::array<Choice<AtmVariant>, 3> choices(AtmVariant /*tag*/) {
  return {{{AtmVariant::org, "org"}, {AtmVariant::mod, "mod"}, {AtmVariant::silver, "silver"}}};
}

struct CombinedOptions {
  double cell_m = 0.01;  ///< of the exported picture; the points themselves are exact
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  Combine combine = Combine::both;
  AtmVariant variant = AtmVariant::silver;
  TransversalAngle angle = TransversalAngle::given;
  Angle theta_t = degrees(30.0);
  double gain = 10.0;
  HistogramStatistic statistic = HistogramStatistic::median;
  double range_quantum_m = inch_m;
  bool small_d_center = false;
  int history = 250;
  double guard_m = 0.0;
  double max_range_m = 3.81;
  bool carve_with_timeouts = false;
  bool error_threshold = false;
  double max_error_m = 0.10;
  bool archive = true;
  int min_neighbours = 0;
  double neighbour_radius_m = 0.2;

  static constexpr auto fields();
};

/// Arc carving and the arc-transversal median side by side on one ring of arcs ([Silver04] 4, 5.A): the median works on
/// the arcs as they were measured, whatever carving has made of them, and the points of both make one map.
///
/// An arc gives its median, labelled `atm`, if its variant's table has one; what is left of it, labelled `carved`, if
/// carving has shortened but not removed it; and its middle, labelled `centerline`, if it has neither and was not
/// removed. An arc that carving removed keeps its place in the ring, and its median.
class Combined {
 public:
  using Options = CombinedOptions;
  using Map = PointMap;
  static constexpr std::string_view name = "combined";

  explicit Combined(Options options = {});
  Combined(Combined&&) noexcept;
  Combined& operator=(Combined&&) noexcept;
  ~Combined();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor);
  /// Points in the order of their echoes. `bound_m` is w(theta_t)/2 of a median, E_s of the others; the first
  /// supporting ping is the echo's.
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// Those of `Carve`; `unprocessed`: arcs that left the ring with neither a median nor carved ([Silver04] 5.B);
  /// `pairs_left_out`: as in `Atm`.
  [[nodiscard]] std::vector<Tally> tallies() const;
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether `position` lies on the reading's arc (within `eps_length_m`), as any point made of it does.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Combined> restore(std::span<const std::byte> bytes);

  // See `ArcKeeping`.
  void visit_arcs(const ArcVisitor& visitor) const;
  [[nodiscard]] bool history_full() const;
  void watch_leaving(ArcVisitor visitor) { watcher_ = std::move(visitor); }

 private:
  class State;

  void take_echo(const Reading& reading);
  [[nodiscard]] ArcState state_of(std::uint32_t slot) const;
  void let_go(std::uint32_t slot);
  void add_points(std::uint32_t slot);

  Options options_;
  PointMap map_;  // archived points, then those of the ring, as of the last `finish`
  std::size_t archived_ = 0;
  InsertCounters counters_;
  ArcVisitor watcher_;
  std::unique_ptr<State> state_;
};

constexpr auto CombinedOptions::fields() {
  using O = CombinedOptions;
  return std::tuple_cat(
      std::tuple{field("combine", &O::combine,
                       {.doc = "arcs with a median: show their carved point as well, or the median alone",
                        .source = "[Silver04] 5.A"}),
                 field("variant", &O::variant,
                       {.doc = "which paper's table says when an arc has a median",
                        .source = "[Choset03] III; [Barshan07] 3.6; [Silver04] 2.D"})},
      transversal_fields<O>(), carving_fields<O>(), carved_point_fields<O>(), neighbour_fields<O>(), arc_fields<O>(),
      grid_fields<O>());
}

static_assert(MappingMethod<Combined> && ArcKeeping<Combined>);

}  // namespace echoarc
