// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/maps/point_map.hpp"
#include "mapping/consensus/history.hpp"
#include "mapping/consensus/on_line_posteriors.hpp"

namespace echoarc::consensus {

/// Steps C to F over the arcs from `from` on, as if there were no others.
[[nodiscard]] PointMap map_of(const History& history, const ConsensusOptions& options, std::size_t from);
/// How much of a map, from its beginning.
struct MapSize {
  std::size_t points = 0;
  std::size_t segments = 0;
};
[[nodiscard]] MapSize size_of(const PointMap& map);
void truncate(PointMap& map, const MapSize& size);
/// Adds the points and segments of `from` whose newest arc is one of first <= i < end; of arcs before `first` nothing
/// is known.
void add_points(const PointMap& from, const ArcTable& arcs, std::size_t first, std::size_t end, PointMap& to);
/// Sorts points and segments of arcs from `first` on behind all others, which keep their order; how many those are.
[[nodiscard]] MapSize move_back(PointMap& map, const ArcTable& arcs, std::size_t first);

/// Keeps a whole map up to date with new arcs, at a cost that does not grow with the map.
///
/// New arcs put their points at the end of the map. Every `renew_arcs` arcs (sooner while there are few) the map is
/// renewed: arcs with half as many behind them are weighed again, steps D to F run over the newest `vote_arcs` and
/// those that came since, and the points of older arcs are kept as they then are.
class OnLineMap {
 public:
  explicit OnLineMap(const ConsensusOptions& options) : options_(options), posteriors_(options) {}

  /// Goes on from a map of all arcs, the first of which have final points.
  void start(const History& history, SweptRows swept, std::size_t final_arcs);
  /// Brings the map up to date.
  void update(History& history, Executor& executor, PointMap& map);
  /// The first `count` arcs are forgotten; of the rest the first have final points.
  void forget(std::size_t count, std::size_t final_arcs);

 private:
  void renew(History& history, Executor& executor, PointMap& map);
  [[nodiscard]] std::size_t following() const { return std::size_t(options_.renew_arcs) / 2; }
  /// Of `count` arcs those too old for votes.
  [[nodiscard]] std::size_t voted_out(std::size_t count) const {
    return count - std::min(count, std::size_t(options_.vote_arcs));
  }

  ConsensusOptions options_;
  OnLinePosteriors posteriors_;
  std::size_t known_ = 0;      // arcs that have points
  std::size_t renewed_ = 0;    // arcs at the last renewal
  std::size_t weighed_ = 0;    // arcs weighed again
  std::size_t kept_arcs_ = 0;  // arcs whose points are kept
  MapSize kept_;               // their points are the first of the map, once they are sorted
  bool sorted_ = false;
};

}  // namespace echoarc::consensus
