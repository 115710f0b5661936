// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/mapping/consensus_options.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc {

namespace consensus {
struct SweptRows;
}

/// Tangent consensus: every arc asks its neighbours where on it the echo came from (docs/methods/consensus.md).
///
/// A wall that reflects an echo is tangent to the echo's arc, and to the arcs of its other echoes; a corner, an edge or
/// a pole lies on all of its arcs. Each bearing of an arc collects what its neighbours say for either hypothesis,
/// weighted by what they know of themselves, and against it, where they looked through it. The likeliest bearings
/// become points; rays that pass through well supported surfaces are outliers, surfaces that many rays pass through are
/// removed, gaps between neighbours are linked, and certain points reach as far as their first Fresnel zone.
///
/// An arc is compared with `history` arcs before and after it, so a new reading speaks to the newest `sweeps * history`
/// arcs, and no longer to older ones. `finish` has two forms:
///
/// - **whole**, if at least half of the arcs are new, if no reading came since the last `finish`, or whenever the first
///   `sweeps * history` arcs, by which the beams are judged, have doubled or are complete: all arcs are weighed as in
///   one batch, and the map is that of a batch to the last bit, whatever `finish` did before.
/// - **on line**, otherwise: the cost is that of the new arcs and does not grow with the map. A new arc is weighed
///   against those before it, and once more some time later; votes and links are renewed every `renew_arcs` arcs, over
///   the newest `vote_arcs`. Points of older arcs stay as they are until a whole `finish`.
///
/// So `finish` twice after the last reading gives what one `finish` after all readings gives. Twice `window_arcs` arcs
/// are kept at most; then the points of the older half become final, and of those arcs nothing else is kept.
/// Silence makes no point; it keeps gaps open. A sensor that neither moves nor turns says one thing, once; without
/// neighbours an arc gives no point.
class Consensus {
 public:
  using Options = ConsensusOptions;
  using Map = PointMap;
  static constexpr std::string_view name = "consensus";

  explicit Consensus(Options options = {});
  Consensus(Consensus&&) noexcept;
  Consensus& operator=(Consensus&&) noexcept;
  ~Consensus();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor);
  /// Walls and points, then links, the most certain first; then zones and weak points. Each has a belief. `bound_m`
  /// holds with 90 %. Walls, points: supported by the echo's ping, then by up to 15 of those beside it; links by their
  /// ends; zones as their points.
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// Points of each label, and of them the provisional ones.
  [[nodiscard]] std::vector<Tally> tallies() const;
  /// What the first sweep makes of the reading, with the arcs before it.
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the position lies on what is searched of the reading's arc (within `eps_length_m`).
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Consensus> restore(std::span<const std::byte> bytes);

  /// Bytes that count against the memory limit.
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  class State;

  void take(const Reading& reading);
  consensus::SweptRows settle(std::size_t end, Executor& executor);
  void settle_full_pieces(Executor& executor);
  void weigh_all(Executor& executor);
  void forget_oldest(Executor& executor);

  Options options_;
  InsertCounters counters_;
  PointMap map_;  // as of the last `finish`
  std::unique_ptr<State> state_;
};

static_assert(MappingMethod<Consensus>);

}  // namespace echoarc
