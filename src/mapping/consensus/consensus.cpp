// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/consensus.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mapping/consensus/heard_beams.hpp"
#include "mapping/consensus/intake.hpp"
#include "mapping/consensus/on_line_map.hpp"
#include "mapping/consensus/saved_history.hpp"
#include "mapping/point_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {

using consensus::ArcTable;
using consensus::echo_of;
using consensus::EchoArc;
using consensus::EchoEstimate;

class Consensus::State {
 public:
  explicit State(const Options& options) : history(options), on_line(options) {}

  consensus::History history;
  consensus::OnLineMap on_line;
  std::size_t finished = 0;      // arcs at the last `finish`
  std::size_t weighed = 0;       // arcs when all were weighed in one, while the beams were judged
  bool beams_known = false;      // for good
  std::size_t places = 0;        // of the robot's way, then
  std::size_t looks = 0;         // then
  bool fresh = false;            // readings came since
  bool whole = false;            // the map is that of all arcs weighed in one
  std::size_t context = 0;       // the first arcs, whose points are final
  consensus::MapSize final_map;  // those are the first of the map
};

namespace {

// An arc with its estimate, and the three points it makes on a drive, each with six pings.
constexpr std::size_t point_bytes = sizeof(MapPoint) + sizeof(PointBelief) + 6 * sizeof(PingId);
constexpr std::size_t arc_bytes =
    sizeof(EchoArc) + 2 * sizeof(Vec2) + 2 * sizeof(double) + sizeof(EchoEstimate) + 3 * point_bytes;
constexpr std::size_t look_bytes = sizeof(consensus::Look) + sizeof(std::uint32_t);
constexpr std::size_t place_bytes = sizeof(Vec2) + sizeof(std::uint32_t);

/// Arcs whose estimates a new one may change.
std::size_t horizon(const ConsensusOptions& options) {
  return std::size_t(options.sweeps) * std::size_t(options.history);
}

/// Arcs whose votes and links can still change; they are kept until there are twice as many.
std::size_t window(const ConsensusOptions& options) {
  return std::max(std::size_t(options.window_arcs), 2 * horizon(options));
}

constexpr std::size_t settled_at_once = 4096;  // arcs: bounds what a sweep holds

}  // namespace

Consensus::Consensus(Options options) : options_(options), state_(std::make_unique<State>(options)) {}
Consensus::Consensus(Consensus&&) noexcept = default;
Consensus& Consensus::operator=(Consensus&&) noexcept = default;
Consensus::~Consensus() = default;

std::size_t Consensus::memory_bytes() const {
  const consensus::History& history = state_->history;
  return history.arcs.size() * arc_bytes + history.path.size() * place_bytes + history.looks.size() * look_bytes +
         state_->final_map.points * point_bytes;
}

void Consensus::take(const Reading& reading) {
  if (memory_bytes() + look_bytes <= memory_limit_bytes(options_))
    state_->history.looks.add(reading, options_, state_->history.arcs.size());
  const auto echo = consensus::echo_of(reading, options_, counters_);
  if (!echo) return;
  if (memory_bytes() + arc_bytes + place_bytes > memory_limit_bytes(options_)) {
    ++counters_.memory_limit;
    return;
  }
  consensus::History& history = state_->history;
  history.visit(reading.T_world_robot.position);
  if (history.arcs.repeats(echo->arc, reading.tx, reading.rx)) {
    ++counters_.passed_over;
    return;
  }
  history.arcs.add(*echo);
  ++counters_.used;
}

/// Steps B and C in one for the arcs below `end` that are not settled yet; what they told the last sweep. Arcs settle
/// when there are more than those by which the beams are judged, so that what is assumed of them stays as it was.
consensus::SweptRows Consensus::settle(std::size_t end, Executor& executor) {
  consensus::History& history = state_->history;
  if (!state_->beams_known) history.arcs.assume(heard_beams(history.arcs, options_));
  state_->beams_known = state_->beams_known || history.arcs.size() > horizon(options_);
  history.estimates.resize(std::max(history.estimates.size(), end));
  consensus::SweptRows swept = consensus::find_posteriors(
      history.arcs, options_, history.settled, end, executor,
      [&](std::size_t i, const consensus::Posterior& posterior) {
        history.estimates[i] = read_out(history.arcs[i], history.arcs.bins(i), options_, posterior);
      });
  const std::size_t open = std::min(horizon(options_), history.arcs.size());
  history.settled = std::max(history.settled, std::min(end, history.arcs.size() - open));
  return swept;
}

/// The same in pieces, for all that can be settled.
void Consensus::settle_full_pieces(Executor& executor) {
  const consensus::History& history = state_->history;
  while (history.arcs.size() >= history.settled + settled_at_once + horizon(options_))
    settle(history.settled + settled_at_once, executor);
}

void Consensus::insert(std::span<const Reading> readings, Executor& executor) {
  State& state = *state_;
  state.fresh = state.fresh || !readings.empty();
  for (const Reading& reading : readings) {
    take(reading);
    const consensus::ArcTable& arcs = state.history.arcs;
    if (arcs.size() >= 2 * window(options_)) forget_oldest(executor);
    if (arcs.size() >= state.finished + settled_at_once + horizon(options_)) settle_full_pieces(executor);
  }
}

void Consensus::finish(Executor& executor) {
  State& state = *state_;
  const std::size_t count = state.history.arcs.size();
  const std::size_t added = count - state.finished;
  const bool mostly_new = 2 * added > count || 2 * added >= window(options_);
  // What is assumed of the beams goes by the first arcs: all are weighed again while they double, and when they are
  // full.
  const bool new_beams = !state.beams_known && (count >= 2 * state.weighed || count > horizon(options_));
  if (mostly_new || new_beams || !state.fresh) {
    if (!state.whole || added > 0) weigh_all(executor);
  } else {
    state.on_line.update(state.history, executor, map_);
    state.whole = state.whole && added == 0 && state.history.path.size() == state.places &&
                  state.history.looks.size() == state.looks;
  }
  state.finished = count;
  state.places = state.history.path.size();
  state.looks = state.history.looks.size();
  state.fresh = false;
}

/// The whole map but for what is final.
void Consensus::weigh_all(Executor& executor) {
  State& state = *state_;
  const consensus::History& history = state.history;
  settle_full_pieces(executor);
  state.on_line.start(history, settle(history.arcs.size(), executor), state.context);
  const PointMap found = consensus::map_of(history, options_, 0);
  truncate(map_, state.final_map);
  consensus::add_points(found, history.arcs, state.context, history.arcs.size(), map_);
  state.whole = true;
  state.weighed = history.arcs.size();
}

/// Makes the points of all but the newest arcs final; of those arcs only the last stay, to speak for their neighbours.
void Consensus::forget_oldest(Executor& executor) {
  finish(executor);
  State& state = *state_;
  const std::size_t old = state.history.arcs.size() - window(options_);
  state.final_map = consensus::move_back(map_, state.history.arcs, old);
  state.context = horizon(options_);
  const std::size_t count = old - state.context;
  state.history.forget(count);
  state.on_line.forget(count, state.context);
  state.finished -= count;
  state.fresh = true;
}

Result<MapExport> Consensus::export_map() const {
  return export_points(map_, options_, name);
}

std::vector<Tally> Consensus::tallies() const {
  constexpr std::array labels{PointLabel::wall, PointLabel::point, PointLabel::link, PointLabel::zone,
                              PointLabel::weak};
  std::vector<Tally> tallies{
      {"points_wall", 0}, {"points_point", 0}, {"points_link", 0}, {"points_zone", 0}, {"points_weak", 0}};
  for (const MapPoint& point : map_.points())
    ++tallies[std::size_t(std::ranges::find(labels, point.label) - labels.begin())].count;
  const auto provisional = std::ranges::count_if(map_.beliefs(), &PointBelief::provisional);
  tallies.push_back({"points_provisional", std::uint64_t(provisional)});
  const double times = state_->history.arcs.prior().sigma_beams / options_.sigma_beams;
  tallies.push_back({"times_the_stated_beam", std::uint64_t(std::lround(times))});
  return tallies;
}

Trace Consensus::trace(const Reading& reading) const {
  Trace trace;
  InsertCounters ignored;
  const auto echo = echo_of(reading, options_, ignored);
  if (!echo) return trace;
  trace.arc = echo->arc;
  const ArcTable& arcs = state_->history.arcs;
  ArcTable recent = arcs.since(arcs.size() - std::min(arcs.size(), std::size_t(options_.history)));
  recent.add(*echo);
  const std::size_t own = recent.size() - 1;
  const consensus::WeightRows rows = consensus::prior_rows(recent, options_);
  consensus::PosteriorEstimator estimator(recent, options_);
  consensus::Neighbours neighbours;
  find_neighbours(recent, options_, own, own, neighbours);
  const EchoEstimate estimate =
      read_out(recent[own], recent.bins(own), options_, estimator.estimate(own, neighbours, {&rows, 0, true}));
  if (is_believed(recent[own], options_, estimate))
    trace.points.push_back(element_of(recent, own, estimate.t).position);
  return trace;
}

bool Consensus::supports(const Reading& reading, Vec2 position) const {
  InsertCounters ignored;
  const auto echo = echo_of(reading, options_, ignored);
  if (!echo || std::abs(echo->arc.half_path_m(position) - echo->arc.range_m()) > eps_length_m) return false;
  const Angle off_axis = wrap(bearing(consensus::normal_through(echo->arc, position)) - echo->arc.axis());
  return abs(off_axis) <=
         std::min(state_->history.arcs.prior().search_beams * echo->beam_width, consensus::widest_search) +
             options_.step;
}

std::vector<std::byte> Consensus::save() const {
  ByteWriter out;
  save_head<Consensus>(out, options_, counters_);
  save_history(out, state_->history, state_->context);
  out.put<std::uint64_t>(state_->context);
  consensus::save_final_map(out, map_, state_->final_map);
  return std::move(out).take();
}

Result<Consensus> Consensus::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Consensus>(in, options, counters)) return damaged_state(name);
  Consensus method(options);
  State& state = *method.state_;
  method.counters_ = counters;
  if (!restore_history(in, state.history)) return damaged_state(name);
  state.context = in.get<std::uint64_t>();
  if (state.context > state.history.arcs.size() || !consensus::restore_final_map(in, method.map_) || !in.done())
    return damaged_state(name);
  state.final_map = consensus::size_of(method.map_);
  state.beams_known = state.context > 0;
  InlineExecutor here;
  method.finish(here);
  return method;
}

}  // namespace echoarc
