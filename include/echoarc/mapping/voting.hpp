// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/mapping/vote_grid.hpp"

namespace echoarc {

/// Field of `int threshold` for the methods that count arcs.
template <class Options>
[[nodiscard]] constexpr auto vote_fields() {
  return std::tuple{field("threshold", &Options::threshold,
                          {.unit = "arcs",
                           .min = 1,
                           .max = 65535,
                           .doc = "a cell is occupied when at least this many arcs cross it",
                           .source = "[Barshan07] 3.2, 4.2: 4 for the curve, 4 or 5 for rooms, 25 for corners"}),
                    field("sampling", &Options::sampling,
                          {.doc = "cells of an arc: by steps of half a cell, or every cell it crosses",
                           .source = "[Barshan07] 3.2"})};
}

struct VotingOptions {
  double cell_m = 0.01;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  int threshold = 4;
  ArcSampling sampling = ArcSampling::exact;

  static constexpr auto fields() {
    return std::tuple_cat(grid_fields<VotingOptions>(), arc_fields<VotingOptions>(), vote_fields<VotingOptions>());
  }
};

/// Voting and thresholding ([Barshan07] 3.2): every cell counts the arcs that cross it, and cells with fewer than
/// `threshold` are dropped. Knows occupied and unknown cells, no free ones; silence says nothing to it.
class Voting {
 public:
  using Options = VotingOptions;
  using Map = VoteGrid::Counts;
  static constexpr std::string_view name = "vt";

  explicit Voting(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& /*executor*/) {}
  /// Arcs per cell, before the threshold.
  [[nodiscard]] const Map& map() const { return votes_.counts(); }
  [[nodiscard]] bool occupied(Cell cell) const { return map().value(cell) >= options_.threshold; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's arc crosses the cell at `position`.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Voting> restore(std::span<const std::byte> bytes);

 private:
  Options options_;
  VoteGrid votes_;
  InsertCounters counters_;
};

static_assert(MappingMethod<Voting>);

}  // namespace echoarc
