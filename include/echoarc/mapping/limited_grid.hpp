// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/mapping/evidence_grid.hpp"

namespace echoarc {

/// The evidence grid on laser-limited sonar ([Yamauchi97]): it asks its host for readings that were shortened to what a
/// laser saw nearer (`takes_laser_limited`), and is the evidence grid in everything else. Given plain readings it is
/// the evidence grid.
class LimitedGrid {
 public:
  using Options = EvidenceGridOptions;
  using Map = EvidenceGrid::Map;
  static constexpr std::string_view name = "limited";
  static constexpr bool takes_laser_limited = true;

  explicit LimitedGrid(const Options& options = {}) : grid_(options) {}

  [[nodiscard]] const Options& options() const { return grid_.options(); }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor) { grid_.finish(executor); }
  [[nodiscard]] const Map& map() const { return grid_.map(); }
  [[nodiscard]] double cell_log_odds(Cell cell) const { return grid_.cell_log_odds(cell); }
  [[nodiscard]] Result<MapExport> export_map() const { return grid_.export_map(); }
  [[nodiscard]] const InsertCounters& counters() const { return grid_.counters(); }
  /// How many readings came with a range that a laser had shortened.
  [[nodiscard]] std::vector<Tally> tallies() const { return {{"laser_limited", limited_}}; }
  /// Of a reading as this method gets it: laser-limited.
  [[nodiscard]] Trace trace(const Reading& reading) const { return grid_.trace(reading); }
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const { return grid_.supports(reading, position); }
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<LimitedGrid> restore(std::span<const std::byte> bytes);

 private:
  EvidenceGrid grid_;
  std::uint64_t limited_ = 0;
};

static_assert(MappingMethod<LimitedGrid>);

}  // namespace echoarc
