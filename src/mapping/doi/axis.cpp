// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "mapping/doi/providers.hpp"
#include "mapping/doi/sort_by_key.hpp"

namespace echoarc::doi {
namespace {

struct Placed {
  std::int64_t line = 0;
  double along = 0.0;
  LineCell cell;
};

}  // namespace

void axis_lines(std::span<const LineCell> cells, Vec2 origin_cells, Vec2 outward, const LineVisitor& visit) {
  const Vec2 across = -perpendicular(outward);
  std::vector<Placed> placed;
  placed.reserve(cells.size());
  for (const LineCell& c : cells) {
    const Vec2 offset = Vec2{c.cell.i + 0.5, c.cell.j + 0.5} - origin_cells;
    placed.push_back({static_cast<std::int64_t>(std::floor(dot(offset, across) + 0.5)), dot(offset, outward), c});
  }
  sort_by_key(
      placed, [](const Placed& p) { return p.line; },
      [](const Placed& a, const Placed& b) { return a.along < b.along; });
  std::vector<LineCell> line;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    line.push_back(placed[k].cell);
    if (k + 1 < placed.size() && placed[k + 1].line == placed[k].line) continue;
    visit(static_cast<std::uint64_t>(placed[k].line), line);
    line.clear();
  }
}

}  // namespace echoarc::doi
