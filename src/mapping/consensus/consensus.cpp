// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/consensus.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mapping/consensus/intake.hpp"
#include "mapping/consensus/layers.hpp"
#include "mapping/point_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {

using consensus::ArcTable;
using consensus::echo_of;
using consensus::EchoArc;
using consensus::EchoEstimate;

class Consensus::State {
 public:
  explicit State(const Options& options) : arcs(options) {}

  /// The robot was here; what it did not leave by a millimetre is one place.
  void visit(Vec2 position) {
    constexpr double least_move_m = 0.001;
    if (path.empty() || norm(position - path.back()) >= least_move_m) path.push_back(position);
  }

  ArcTable arcs;
  std::vector<Vec2> path;               // of the robot
  std::vector<EchoEstimate> estimates;  // by arc, as of the last `settle`
  std::size_t settled = 0;              // arcs whose estimates no reading can change any more
};

namespace {

// An arc with its estimate, and the three points it makes on a drive, each with six pings.
constexpr std::size_t point_bytes = sizeof(MapPoint) + sizeof(PointBelief) + 6 * sizeof(PingId);
constexpr std::size_t arc_bytes =
    sizeof(EchoArc) + sizeof(Vec2) + sizeof(double) + sizeof(EchoEstimate) + 3 * point_bytes;

/// Arcs whose estimates a new one may change.
std::size_t horizon(const ConsensusOptions& options) {
  return std::size_t(options.sweeps) * std::size_t(options.history);
}

}  // namespace

Consensus::Consensus(Options options) : options_(options), state_(std::make_unique<State>(options)) {}
Consensus::Consensus(Consensus&&) noexcept = default;
Consensus& Consensus::operator=(Consensus&&) noexcept = default;
Consensus::~Consensus() = default;

std::size_t Consensus::memory_bytes() const {
  return state_->arcs.size() * arc_bytes + state_->path.size() * sizeof(Vec2);
}

void Consensus::take(const Reading& reading) {
  const auto echo = echo_of(reading, options_, counters_);
  if (!echo) return;
  if (memory_bytes() + arc_bytes + sizeof(Vec2) > memory_limit_bytes(options_)) {
    ++counters_.memory_limit;
    return;
  }
  state_->visit(reading.T_world_robot.position);
  if (state_->arcs.repeats(echo->arc, reading.tx, reading.rx)) {
    ++counters_.passed_over;
    return;
  }
  state_->arcs.add(*echo);
  ++counters_.used;
}

/// Steps B and C for the arcs below `end` that are not settled yet.
void Consensus::settle(std::size_t end, Executor& executor) {
  State& state = *state_;
  state.estimates.resize(end);
  consensus::find_posteriors(state.arcs, options_, state.settled, end, executor,
                             [&](std::size_t i, const consensus::Posterior& posterior) {
                               state.estimates[i] = read_out(state.arcs[i], state.arcs.bins(i), options_, posterior);
                             });
  const std::size_t open = std::min(horizon(options_), state.arcs.size());
  state.settled = std::max(state.settled, std::min(end, state.arcs.size() - open));
}

void Consensus::insert(std::span<const Reading> readings, Executor& executor) {
  constexpr std::size_t batch = 4096;  // bounds what a sweep holds at once
  for (const Reading& reading : readings) {
    take(reading);
    if (state_->arcs.size() >= state_->settled + batch + horizon(options_))
      settle(state_->arcs.size() - horizon(options_), executor);
  }
}

void Consensus::finish(Executor& executor) {
  State& state = *state_;
  settle(state.arcs.size(), executor);
  const consensus::Layers layers = build_layers(state.arcs, options_, state.estimates, state.path);
  map_ = point_map_of(state.arcs, options_, state.estimates, layers);
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
  return tallies;
}

Trace Consensus::trace(const Reading& reading) const {
  Trace trace;
  InsertCounters ignored;
  const auto echo = echo_of(reading, options_, ignored);
  if (!echo) return trace;
  trace.arc = echo->arc;
  const ArcTable& arcs = state_->arcs;
  ArcTable recent(options_);
  for (std::size_t k = arcs.size() - std::min(arcs.size(), std::size_t(options_.history)); k < arcs.size(); ++k)
    recent.add(arcs[k]);
  recent.add(*echo);
  const std::size_t own = recent.size() - 1;
  const consensus::WeightRows rows = consensus::prior_rows(recent, options_);
  consensus::PosteriorEstimator estimator(recent, options_);
  consensus::Neighbours neighbours;
  find_neighbours(recent, options_, own, neighbours);
  const EchoEstimate estimate =
      read_out(recent[own], recent.bins(own), options_, estimator.estimate(own, neighbours, {&rows, 0, true}));
  const double least_p = options_.mode == ConsensusMode::strict ? options_.strict_p : options_.accept_p;
  const bool shown = echo->arc.range_m() < options_.map_range_m && estimate.p > least_p;
  if (shown && estimate.evidence > options_.evidence)
    trace.points.push_back(element_of(recent, own, estimate.t).position);
  return trace;
}

bool Consensus::supports(const Reading& reading, Vec2 position) const {
  InsertCounters ignored;
  const auto echo = echo_of(reading, options_, ignored);
  if (!echo || std::abs(echo->arc.half_path_m(position) - echo->arc.range_m()) > eps_length_m) return false;
  const Angle off_axis = wrap(bearing(consensus::normal_through(echo->arc, position)) - echo->arc.axis());
  return abs(off_axis) <= std::min(options_.search_beams * echo->beam_width, consensus::widest_search) + options_.step;
}

std::vector<std::byte> Consensus::save() const {
  ByteWriter out;
  save_head<Consensus>(out, options_, counters_);
  state_->arcs.save(out);
  out.put_vector(state_->path);
  return std::move(out).take();
}

Result<Consensus> Consensus::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Consensus>(in, options, counters)) return damaged_state(name);
  Consensus method(options);
  method.counters_ = counters;
  if (!method.state_->arcs.restore(in)) return damaged_state(name);
  method.state_->path = in.get_vector<Vec2>();
  if (!in.done() || !std::ranges::all_of(method.state_->path, [](Vec2 p) { return is_finite(p); }))
    return damaged_state(name);
  InlineExecutor here;
  method.finish(here);
  return method;
}

}  // namespace echoarc
