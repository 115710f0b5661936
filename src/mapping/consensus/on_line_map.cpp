// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/on_line_map.hpp"

#include <algorithm>
#include <unordered_map>

#include "mapping/consensus/layers.hpp"

namespace echoarc::consensus {
namespace {

/// The newest arc behind a point or a segment, among those from `first` on.
class NewestArc {
 public:
  NewestArc(const ArcTable& arcs, std::size_t first) {
    arcs_.reserve(arcs.size() - first);
    for (std::size_t i = first; i < arcs.size(); ++i) arcs_[key(arcs[i].source.ping, arcs[i].source.sensor)] = i;
  }
  /// `none` for those of older arcs.
  [[nodiscard]] std::size_t of(const auto& thing) const {
    const auto found = arcs_.find(key(thing.ping, thing.sensor));
    return found == arcs_.end() ? none : found->second;
  }
  static constexpr std::size_t none = std::size_t(-1);

 private:
  static std::uint64_t key(PingId ping, SensorId sensor) {
    return ping * 0x9e3779b97f4a7c15ULL + std::uint64_t(sensor);
  }
  std::unordered_map<std::uint64_t, std::size_t> arcs_;
};

/// Adds what of `from` has a newest arc that is wanted.
template <class Wanted>
void add_wanted(const PointMap& from, const NewestArc& newest, Wanted wanted, PointMap& to) {
  for (std::size_t k = 0; k < from.size(); ++k)
    if (const MapPoint& point = from.points()[k]; wanted(newest.of(point)))
      to.add(point, from.support(point), from.beliefs()[k]);
  for (const MapSegment& segment : from.segments())
    if (wanted(newest.of(segment))) to.add(segment);
}

constexpr std::size_t beside_new_arcs = 16;  // arcs before the new ones that vote on their points: two rings of sensors

/// Zones fill what is left open when all else is shown: too early among a few new arcs.
ConsensusOptions without_zones(ConsensusOptions options) {
  options.zone = 0.0;
  return options;
}

}  // namespace

PointMap map_of(const History& history, const ConsensusOptions& options, std::size_t from) {
  const ArcTable arcs = history.arcs.since(from);
  const auto estimates = std::span(history.estimates).subspan(from);
  const Layers layers = build_layers(arcs, options, estimates, history.path_since(from), history.looks.since(from));
  return point_map_of(arcs, options, estimates, layers);
}

MapSize size_of(const PointMap& map) {
  return {map.size(), map.segments().size()};
}

void truncate(PointMap& map, const MapSize& size) {
  map.truncate(size.points);
  map.truncate_segments(size.segments);
}

void add_points(const PointMap& from, const ArcTable& arcs, std::size_t first, std::size_t end, PointMap& to) {
  add_wanted(from, NewestArc(arcs, first), [&](std::size_t arc) { return arc < end; }, to);
}

MapSize move_back(PointMap& map, const ArcTable& arcs, std::size_t first) {
  const NewestArc newest(arcs, first);
  PointMap sorted;
  add_wanted(map, newest, [](std::size_t arc) { return arc == NewestArc::none; }, sorted);
  const MapSize before = size_of(sorted);
  add_wanted(map, newest, [](std::size_t arc) { return arc != NewestArc::none; }, sorted);
  map = std::move(sorted);
  return before;
}

void OnLineMap::start(const History& history, SweptRows swept, std::size_t final_arcs) {
  known_ = renewed_ = history.arcs.size();
  weighed_ = known_ - std::min(known_, following());
  // What is weighed again looks a history back.
  if (swept.first > 0) weighed_ = std::max(weighed_, std::min(known_, swept.first + std::size_t(options_.history)));
  posteriors_.start(history.arcs, std::move(swept));
  kept_arcs_ = std::max(final_arcs, std::min(weighed_, voted_out(known_)));
  sorted_ = false;
}

void OnLineMap::update(History& history, Executor& executor, PointMap& map) {
  const std::size_t count = history.arcs.size();
  if (count == known_) return;
  history.estimates.resize(count);
  posteriors_.weigh_new(history.arcs, known_, [&](std::size_t i, const Posterior& posterior) {
    history.estimates[i] = read_out(history.arcs[i], history.arcs.bins(i), options_, posterior);
  });
  if (count - renewed_ >= std::min(std::size_t(options_.renew_arcs), count / 4)) {
    renew(history, executor, map);
  } else {
    const PointMap fresh = map_of(history, without_zones(options_), known_ - std::min(known_, beside_new_arcs));
    add_points(fresh, history.arcs, known_, count, map);
  }
  known_ = count;
}

void OnLineMap::renew(History& history, Executor& executor, PointMap& map) {
  const std::size_t count = history.arcs.size();
  const std::size_t weighed = std::max(weighed_, count - std::min(count, following()));
  posteriors_.weigh_again(history.arcs, weighed_, weighed, executor, [&](std::size_t i, const Posterior& posterior) {
    history.estimates[i] = read_out(history.arcs[i], history.arcs.bins(i), options_, posterior);
  });
  if (!sorted_) kept_ = move_back(map, history.arcs, kept_arcs_);
  sorted_ = true;
  truncate(map, kept_);
  const PointMap fresh = map_of(history, options_, kept_arcs_ - std::min(kept_arcs_, following()));
  const std::size_t kept = std::max(kept_arcs_, std::min(weighed_, voted_out(count)));
  add_points(fresh, history.arcs, kept_arcs_, kept, map);
  kept_ = size_of(map);
  add_points(fresh, history.arcs, kept, count, map);
  kept_arcs_ = kept;
  weighed_ = weighed;
  renewed_ = count;
}

void OnLineMap::forget(std::size_t count, std::size_t final_arcs) {
  posteriors_.forget(count);
  for (std::size_t* arcs : {&known_, &renewed_, &weighed_, &kept_arcs_}) *arcs -= std::min(*arcs, count);
  kept_arcs_ = std::max(kept_arcs_, final_arcs);
  sorted_ = false;
}

}  // namespace echoarc::consensus
