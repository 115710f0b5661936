// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/reading.hpp"

namespace echoarc::bench {

/// A system that turns readings into a grid, as the race sees it.
class Contestant {
 public:
  virtual ~Contestant() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// Turns readings into the system's own input; not timed.
  virtual void prepare(std::span<const Reading> readings) = 0;
  /// Puts what was prepared into the grid; timed.
  virtual void insert() = 0;
  /// Mean number of cells one of \p readings touches; uses a grid of its own.
  [[nodiscard]] virtual double cells_per_reading(std::span<const Reading> readings) const = 0;
};

/// What every reading costs at least: a float added to each cell of the sector, dense row-major grid, the spans made by
/// the same raster and added by kernels of the same dispatch as the evidence grid's.
[[nodiscard]] std::unique_ptr<Contestant> make_floor(double cell_m);
/// The evidence grid with one of its profiles ("gaussian", "uniform", "parabolic"), other options default.
[[nodiscard]] std::unique_ptr<Contestant> make_evidence(double cell_m, const std::string& profile);

/// Time of every contestant for every round, in seconds: `times[contestant][round]`.
using RaceTimes = std::vector<std::vector<double>>;
/// Cuts the readings into `rounds` blocks. In each round every contestant inserts the same block, the first to start
/// changing from round to round; block 0 is inserted once before, to warm up.
[[nodiscard]] RaceTimes race(std::span<const std::unique_ptr<Contestant>> contestants,
                             std::span<const Reading> readings, std::size_t rounds);

}  // namespace echoarc::bench
