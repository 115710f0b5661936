// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "echoarc/mapping/carving_options.hpp"
#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc {

class CarvedRing;

struct CarveOptions {
  double cell_m = 0.01;  ///< of the exported picture; the points themselves are exact
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  int history = 250;
  double guard_m = 0.0;
  double max_range_m = 3.81;
  bool carve_with_timeouts = false;
  bool error_threshold = false;
  double max_error_m = 0.10;
  bool archive = true;
  int min_neighbours = 0;
  double neighbour_radius_m = 0.2;

  static constexpr auto fields() {
    return std::tuple_cat(carving_fields<CarveOptions>(), carved_point_fields<CarveOptions>(),
                          neighbour_fields<CarveOptions>(), arc_fields<CarveOptions>(), grid_fields<CarveOptions>());
  }
};

/// Arc carving ([Silver04] 3, 5.A): every arc of a ring of recent ones loses what lies in the free space of a newer
/// reading, and gives one point, the middle of what is left. An arc of which nothing is left, or more than one piece,
/// gives none.
///
/// Incremental: a reading acts on all older arcs of the ring the moment it comes, with its whole beam. Points of arcs
/// that have left the ring are archived as they last were.
class Carve {
 public:
  using Options = CarveOptions;
  using Map = PointMap;
  static constexpr std::string_view name = "carve";

  explicit Carve(Options options = {});
  Carve(Carve&&) noexcept;
  Carve& operator=(Carve&&) noexcept;
  ~Carve();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor);
  /// Points in the order of their echoes, labelled `centerline` or `carved`; `bound_m` is E_s. The first supporting
  /// ping is the echo's, behind it come the pings that set the ends of what is left.
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// `carved`: arcs that lost something and lived; `removed_full`, `removed_split`: arcs that were removed;
  /// `left_history`: arcs that lived to leave the ring. ([Silver04] 5.C compares removed_full with removed + left.)
  [[nodiscard]] std::vector<Tally> tallies() const;
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether `position` lies on the reading's arc (within `eps_length_m`), as any point made of it does.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Carve> restore(std::span<const std::byte> bytes);

  // See `ArcKeeping`.
  void visit_arcs(const ArcVisitor& visitor) const;
  [[nodiscard]] bool history_full() const;
  void watch_leaving(ArcVisitor visitor) { watcher_ = std::move(visitor); }

 private:
  void take_echo(const Reading& reading);
  [[nodiscard]] ArcState state_of(std::uint32_t slot) const;
  /// The arc leaves the ring; its point stays, if the map is a global one.
  void let_go(std::uint32_t slot);

  Options options_;
  PointMap map_;  // archived points, then those of the ring, as of the last `finish`
  std::size_t archived_ = 0;
  InsertCounters counters_;
  ArcVisitor watcher_;
  std::unique_ptr<CarvedRing> ring_;
};

static_assert(MappingMethod<Carve> && ArcKeeping<Carve>);

}  // namespace echoarc
