// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_set>
#include <vector>

#include "echoarc/mapping/directional_maximum_options.hpp"
#include "echoarc/mapping/vote_grid.hpp"
#include "echoarc/maps/ray_raster.hpp"

/// Lines of interest: what a provider of directions yields and the rule of the method consumes.
namespace echoarc::doi {

/// A cell of a line whose count reaches the threshold. Cells below it are left out: the rule would drop them anyway.
struct LineCell {
  Cell cell;
  std::uint16_t count = 0;
};

/// Takes one line, its cells ordered from the robot outward. Line numbers are unique within one provider.
using LineVisitor = std::function<void(std::uint64_t line, std::span<const LineCell> cells)>;

struct CellHash {
  std::size_t operator()(Cell c) const {
    const std::uint64_t key = (std::uint64_t(std::uint32_t(c.i)) << 32) | std::uint32_t(c.j);
    return std::size_t((key * 0x9e3779b97f4a7c15ULL) >> 16);
  }
};
using CellSet = std::unordered_set<Cell, CellHash>;

/// All cells at or above the threshold, tile by tile.
[[nodiscard]] std::vector<LineCell> cells_at_threshold(const VoteGrid::Counts& counts, int threshold);

/// Gathers the cells at or above the threshold along rays.
class RayLines {
 public:
  RayLines(const VoteGrid::Counts& counts, int threshold);
  /// Of \p wanted alone, all of them at or above the threshold. Others may be left out.
  RayLines(const VoteGrid::Counts& counts, int threshold, std::span<const LineCell> wanted);
  /// The span is valid until the next call.
  [[nodiscard]] std::span<const LineCell> along(Vec2 origin, Vec2 direction, double length_m);

 private:
  const VoteGrid::Counts& counts_;
  int threshold_;
  CellBox within_;
  BlockMask blocks_;
  RayRaster raster_;
  std::vector<LineCell> line_;
};

/// Applies the rule of [Barshan07] 3.3 to line after line.
class LineProcessor {
 public:
  explicit LineProcessor(const DirectionalMaximumOptions& options) : options_(options) {}

  void process(std::uint64_t line, std::span<const LineCell> cells);
  [[nodiscard]] LineVisitor visitor() {
    return [this](std::uint64_t line, std::span<const LineCell> cells) { process(line, cells); };
  }
  /// The survivors since the last call, row by row, each once.
  [[nodiscard]] std::vector<Cell> take();
  /// Whether any line held the cell; known only with `UnvisitedRule::keep`.
  [[nodiscard]] bool visited(Cell cell) const { return visited_.contains(cell); }

 private:
  DirectionalMaximumOptions options_;
  std::vector<std::uint16_t> counts_;
  std::vector<Cell> survivors_;
  CellSet visited_;
};

/// Sorts cells row by row and drops repetitions.
void make_unique(std::vector<Cell>& cells);

}  // namespace echoarc::doi
