// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "echoarc/mapping/consensus_evidence_options.hpp"
#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {

/// What the vote of the rays (step D) says of an arc.
enum class Verdict : std::uint8_t {
  unsure,       ///< its estimate is too weak to have a say
  kept,         ///< it took part, and stayed
  outlier,      ///< it took part, and lost
  crowded_out,  ///< it stayed, but the grid has no room for its beam, which turned out wider than stated
};
inline constexpr std::size_t verdict_count = 4;

/// An arc beside its geometry: what the grid needs of its reading, and what is known of its bearing.
struct WaitingArc {
  double near_m = 0.0;  ///< nearer the sensor reports nothing
  Vec2 robot;           ///< where the robot was
  EchoEstimate estimate;
  std::vector<float> posterior;  ///< W by bin
  Verdict verdict = Verdict::unsure;
};

/// The newest arcs, waiting until what is known of them can change no more.
///
/// From old to new: arcs that others still look back at; arcs whose posterior is final and whose vote is not; arcs
/// whose posterior a new one may still change. Blocks of arcs advance together, at counts of arcs that nothing else
/// influences.
class EvidenceWindow {
 public:
  /// A window for `bytes` of memory at most.
  EvidenceWindow(const ConsensusEvidenceOptions& options, std::size_t bytes);

  using Leave = std::function<void(const EchoArc&, const BeamBins&, const WaitingArc&)>;

  [[nodiscard]] const ArcTable& arcs() const { return arcs_; }
  void add(const EchoArc& echo, double near_m, Vec2 robot);
  /// Calls `leave` for arcs that are settled by now, oldest first.
  void advance(Executor& executor, const Leave& leave);
  /// Calls `show` for the arcs that have not left, as things stand, oldest first.
  void visit_open(Executor& executor, const Leave& show);

  void save(ByteWriter& out) const;
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  void weigh(std::size_t end, Executor& executor);
  void vote(std::size_t end);
  void forget();

  ConsensusEvidenceOptions options_;
  std::size_t block_;   // arcs that are settled together
  std::size_t ahead_;   // arcs after one that its posterior needs
  std::size_t beside_;  // arcs after one that its vote needs
  ArcTable arcs_;
  std::vector<WaitingArc> waiting_;  // by arc
  std::size_t left_ = 0;             // arcs that have left
  std::size_t known_ = 0;            // arcs whose posterior is final
};

}  // namespace echoarc::consensus
