// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/consensus_evidence.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mapping/consensus/evidence_beam.hpp"
#include "mapping/consensus/evidence_window.hpp"
#include "mapping/consensus/intake.hpp"
#include "mapping/consensus/neighbours.hpp"
#include "mapping/consensus/posterior.hpp"
#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {

using consensus::EchoArc;
using consensus::EvidenceBeam;
using consensus::Verdict;
using consensus::WaitingArc;

class ConsensusEvidence::State {
 public:
  // The window may take a quarter; two grids share the rest.
  explicit State(const Options& o)
      : options(o),
        window(o, memory_limit_bytes(o) / 4),
        raster(geometry_of(o)),
        grid(geometry_of(o), memory_limit_bytes(o) / 8 * 3),
        shown(geometry_of(o), memory_limit_bytes(o) / 8 * 3) {}

  /// Makes the tiles under a rim exist; false if that cannot be.
  [[nodiscard]] static bool make_room(const Arc& rim, Map& grid) {
    if (!within_reach(rim, grid.geometry(), grid.memory_limit_bytes())) return false;
    Box box = rim.bounds();
    const Vec2 apex = rim.centre();
    box.low = {std::min(box.low.x, apex.x), std::min(box.low.y, apex.y)};
    box.high = {std::max(box.high.x, apex.x), std::max(box.high.y, apex.y)};
    return grid.ensure_cells(grid.geometry().cells_of(box));
  }
  [[nodiscard]] bool make_room(const Arc& rim) { return make_room(rim, grid); }

  void take_echo(const EchoArc& echo, const Reading& reading, InsertCounters& counters);
  void take_silence(const Reading& reading, InsertCounters& counters);
  /// Feeds an arc into a grid: one that took part in the vote and was not found to be an outlier. What became of it.
  Verdict feed(const EchoArc& echo, const consensus::BeamBins& bins, const WaitingArc& waiting, Map& into) {
    if (waiting.verdict != Verdict::kept) return waiting.verdict;
    const EvidenceBeam beam = echo_beam(echo, bins, waiting.posterior, waiting.near_m, options);
    if (!make_room(beam.rim, into)) return Verdict::crowded_out;
    consensus::apply(beam, raster, into);
    return Verdict::kept;
  }
  /// What a reading would say if it came next; none if nothing.
  [[nodiscard]] std::optional<EvidenceBeam> beam_of(const Reading& reading) const;
  void advance(Executor& executor) {
    window.advance(executor, [&](const EchoArc& echo, const consensus::BeamBins& bins, const WaitingArc& waiting) {
      ++verdicts[std::size_t(feed(echo, bins, waiting, grid))];
    });
  }
  void show(Executor& executor) {
    shown = grid;
    shown_verdicts = verdicts;
    window.visit_open(executor, [&](const EchoArc& echo, const consensus::BeamBins& bins, const WaitingArc& waiting) {
      ++shown_verdicts[std::size_t(feed(echo, bins, waiting, shown))];
    });
  }

  Options options;
  consensus::EvidenceWindow window;
  SectorRaster raster;
  Map grid;   // silence, and the arcs that have left the window
  Map shown;  // with those that have not
  std::array<std::uint64_t, consensus::verdict_count> verdicts{};
  std::array<std::uint64_t, consensus::verdict_count> shown_verdicts{};
};

void ConsensusEvidence::State::take_echo(const EchoArc& echo, const Reading& reading, InsertCounters& counters) {
  const consensus::ArcTable& arcs = window.arcs();
  if (arcs.repeats(echo.arc, reading.tx, reading.rx)) {
    ++counters.passed_over;
    return;
  }
  const auto rim = rim_of(echo, consensus::make_bins(options, arcs.prior(), echo.beam_width), options);
  if (!rim) {
    ++counters.no_arc;
    return;
  }
  if (!make_room(*rim)) {
    ++counters.memory_limit;
    return;
  }
  window.add(echo, reading.range_min_m, reading.T_world_robot.position);
  ++counters.used;
}

void ConsensusEvidence::State::take_silence(const Reading& reading, InsertCounters& counters) {
  const auto beam = consensus::silence_beam(reading, options);
  if (!beam) {
    ++counters.no_information;
  } else if (!make_room(beam->rim)) {
    ++counters.memory_limit;
  } else {
    consensus::apply(*beam, raster, grid);
    ++counters.used;
  }
}

ConsensusEvidence::ConsensusEvidence(Options options) : options_(options), state_(std::make_unique<State>(options)) {}
ConsensusEvidence::ConsensusEvidence(ConsensusEvidence&&) noexcept = default;
ConsensusEvidence& ConsensusEvidence::operator=(ConsensusEvidence&&) noexcept = default;
ConsensusEvidence::~ConsensusEvidence() = default;

void ConsensusEvidence::insert(std::span<const Reading> readings, Executor& executor) {
  for (const Reading& reading : readings) {
    if (!echo_range_m(reading.outcome)) {
      state_->take_silence(reading, counters_);
    } else if (const auto echo = consensus::echo_of(reading, options_, counters_)) {
      state_->take_echo(*echo, reading, counters_);
      state_->advance(executor);
    }
  }
}

void ConsensusEvidence::finish(Executor& executor) {
  state_->show(executor);
}

const ConsensusEvidence::Map& ConsensusEvidence::map() const {
  return state_->shown;
}

Result<MapExport> ConsensusEvidence::export_map() const {
  const auto state_of = [&](Cell /*cell*/, std::int16_t value) {
    const double p = probability(value * log_odds_unit);
    if (p >= options_.occupied_threshold) return CellState::occupied;
    return p <= options_.free_threshold ? CellState::free : CellState::unknown;
  };
  return export_grid<float>(state_->shown, name, state_of,
                            [](std::int16_t value) { return static_cast<float>(value * log_odds_unit); });
}

std::vector<Tally> ConsensusEvidence::tallies() const {
  const auto count = [&](Verdict verdict) { return state_->shown_verdicts[std::size_t(verdict)]; };
  return {{"arcs_believed", count(Verdict::kept)},
          {"arcs_unsure", count(Verdict::unsure)},
          {"arcs_voted_out", count(Verdict::outlier)},
          {"arcs_without_memory", count(Verdict::crowded_out)}};
}

/// With the newest arcs as its past, as if the reading came next.
std::optional<EvidenceBeam> ConsensusEvidence::State::beam_of(const Reading& reading) const {
  InsertCounters ignored;
  if (!echo_range_m(reading.outcome)) return consensus::silence_beam(reading, options);
  const auto echo = consensus::echo_of(reading, options, ignored);
  const consensus::ArcTable& arcs = window.arcs();
  if (!echo || !rim_of(*echo, consensus::make_bins(options, arcs.prior(), echo->beam_width), options))
    return std::nullopt;
  consensus::ArcTable recent = arcs.since(arcs.size() - std::min(arcs.size(), std::size_t(options.history)));
  recent.add(*echo);
  const std::size_t own = recent.size() - 1;
  const consensus::WeightRows rows = consensus::prior_rows(recent, options);
  consensus::PosteriorEstimator estimator(recent, options);
  consensus::Neighbours neighbours;
  find_neighbours(recent, options, own, own, neighbours);
  const std::vector<float> posterior = mixture(estimator.estimate(own, neighbours, {&rows, 0, true}));
  return echo_beam(*echo, recent.bins(own), posterior, reading.range_min_m, options);
}

Trace ConsensusEvidence::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  const auto beam = state_->beam_of(reading);
  const GridGeometry& geometry = state_->grid.geometry();
  if (!beam || !within_reach(beam->rim, geometry, state_->grid.memory_limit_bytes())) return trace;
  SectorRaster raster(geometry);
  for (const RowSpan& row : raster.spans(beam->rim))
    for (Cell cell{row.i_begin, row.j}; cell.i < row.i_end; ++cell.i) {
      const Vec2 centre = geometry.centre(cell);
      const int change = increment(*beam, centre);
      if (change == 0) continue;
      const std::int16_t before = state_->shown.value(cell);
      const Angle theta = wrap(bearing(centre - beam->rim.centre()) - beam->rim.axis());
      trace.cells.push_back({cell,
                             centre,
                             before * log_odds_unit,
                             consensus::saturated(before + change) * log_odds_unit,
                             {{"sigma", beam->rim.half_path_m(centre), "m"},
                              {"theta", theta.deg(), "deg"},
                              {"p", probability(change * log_odds_unit)},
                              {"log_odds_added", change * log_odds_unit}}});
    }
  return trace;
}

bool ConsensusEvidence::supports(const Reading& reading, Vec2 position) const {
  InsertCounters ignored;
  const auto echo = consensus::echo_of(reading, options_, ignored);
  if (!echo) return false;
  const consensus::BeamBins bins = consensus::make_bins(options_, state_->window.arcs().prior(), echo->beam_width);
  const auto rim = rim_of(*echo, bins, options_);
  if (!rim) return false;
  const GridGeometry& geometry = state_->grid.geometry();
  const std::vector<float> anywhere(std::size_t(bins.count()), 1.0F);
  return increment(echo_beam(*echo, bins, anywhere, reading.range_min_m, options_),
                   geometry.centre(geometry.cell_of(position))) > 0;
}

std::vector<std::byte> ConsensusEvidence::save() const {
  ByteWriter out;
  save_head<ConsensusEvidence>(out, options_, counters_);
  state_->window.save(out);
  for (const std::uint64_t count : state_->verdicts) out.put(count);
  state_->grid.save(out);
  return std::move(out).take();
}

Result<ConsensusEvidence> ConsensusEvidence::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<ConsensusEvidence>(in, options, counters)) return damaged_state(name);
  ConsensusEvidence method(options);
  method.counters_ = counters;
  State& state = *method.state_;
  if (!state.window.restore(in)) return damaged_state(name);
  for (std::uint64_t& count : state.verdicts) count = in.get<std::uint64_t>();
  if (!restore_grid(in, state.grid) || !in.done()) return damaged_state(name);
  const consensus::ArcTable& arcs = state.window.arcs();
  // Tiles under open arcs were made when they came; damaged bytes may lack them.
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto rim = rim_of(arcs[i], arcs.bins(i), options);
    if (!rim || !state.make_room(*rim)) return damaged_state(name);
  }
  InlineExecutor here;
  method.finish(here);
  return method;
}

}  // namespace echoarc
