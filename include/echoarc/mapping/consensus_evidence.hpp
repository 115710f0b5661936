// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/mapping/consensus_evidence_options.hpp"
#include "echoarc/mapping/evidence_grid.hpp"

namespace echoarc {

/// The grid form of tangent consensus (docs/methods/consensus.md): an evidence grid in clamped log-odds that is fed
/// with what the neighbours of an arc know of the bearing of its echo, instead of a beam profile that is always the
/// same.
///
/// Along its arc an echo makes a cell the likelier occupied the more of the arc's posterior lies there, and before the
/// arc it makes free what the sound went through. An echo that the vote of the rays finds to be an outlier says
/// nothing. Silence clears as in `EvidenceGrid`, at once.
///
/// An arc is fed into the grid for good when no later reading can change its posterior; `finish` adds the arcs that are
/// still open to a copy, so that the map is the same however often it is called. Memory is bounded by the window and
/// the area: where the limit leaves no room for the whole window, arcs settle earlier.
class ConsensusEvidence {
 public:
  using Options = ConsensusEvidenceOptions;
  using Map = TiledGrid<std::int16_t>;
  static constexpr std::string_view name = "consensus_evidence";

  explicit ConsensusEvidence(Options options = {});
  ConsensusEvidence(ConsensusEvidence&&) noexcept;
  ConsensusEvidence& operator=(ConsensusEvidence&&) noexcept;
  ~ConsensusEvidence();

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor);
  /// Log-odds in units of `log_odds_unit`.
  [[nodiscard]] const Map& map() const;
  [[nodiscard]] double cell_log_odds(Cell cell) const { return map().value(cell) * log_odds_unit; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// What became of the arcs, as of the last `finish`: believed, voted out, or never sure enough to vote.
  [[nodiscard]] std::vector<Tally> tallies() const;
  /// With the posterior that the arcs before the reading make of it in one sweep.
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading may raise the cell of the position: its arc passes through.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<ConsensusEvidence> restore(std::span<const std::byte> bytes);

 private:
  class State;

  Options options_;
  InsertCounters counters_;
  std::unique_ptr<State> state_;
};

static_assert(MappingMethod<ConsensusEvidence>);

}  // namespace echoarc
