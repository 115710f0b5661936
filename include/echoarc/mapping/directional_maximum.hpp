// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/mapping/directional_maximum_options.hpp"
#include "echoarc/mapping/doi_history.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/mapping/vote_grid.hpp"

namespace echoarc {

/// [Barshan07] 3.3 for one line: which cell survives. \p counts are the counts along the line from the robot outward;
/// the survivor holds the maximum, if that reaches the threshold, and of several maxima it is the median. \p line
/// matters to `TieRule::hash` alone.
[[nodiscard]] std::optional<std::size_t> directional_maximum(std::span<const std::uint16_t> counts, int threshold,
                                                             TieRule tie = TieRule::near, std::uint64_t seed = 0,
                                                             std::uint64_t line = 0);

/// What the method knows: the arc map, and the cells that survive on the lines of interest.
struct DirectionalMaximumMap {
  VoteGrid votes;
  std::vector<Cell> survivors;  ///< row by row, each once
};

/// Directional maximum ([Barshan07] 3.3): counts arcs as `Voting` does, then keeps on every line of interest at most
/// one cell, the one with the largest count at or above the threshold. A cell survives if it survives on any line.
class DirectionalMaximum {
 public:
  using Options = DirectionalMaximumOptions;
  using Map = DirectionalMaximumMap;
  static constexpr std::string_view name = "dm";

  explicit DirectionalMaximum(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  /// Applies the rule to all lines of interest; costs time in proportion to the map.
  void finish(Executor& executor);
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// The counts that would change; whether a cell survives is decided by `finish`.
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's arc crosses the cell at `position`.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<DirectionalMaximum> restore(std::span<const std::byte> bytes);

 private:
  Options options_;
  Map map_;
  DoiHistory history_;
  InsertCounters counters_;
};

static_assert(MappingMethod<DirectionalMaximum>);

}  // namespace echoarc
