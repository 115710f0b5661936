// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/sector_raster.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

// V8.1: 198 cell centres in 30 rows.
TEST(SectorRaster, WorkedNumbers) {
  SectorRaster raster({.cell_m = 0.01, .origin = {-0.5, 0.0}});
  const auto spans = raster.spans(Arc::circular({0.005, 0.005}, degrees(90.0), 0.302, degrees(25.0)));
  std::map<int, std::pair<int, int>> columns;
  int total = 0;
  for (const RowSpan& s : spans) {
    columns[s.j] = {s.i_begin, s.i_end - 1};
    total += s.i_end - s.i_begin;
  }
  EXPECT_EQ(total, 198);
  ASSERT_EQ(columns.size(), 30U);
  EXPECT_EQ(columns.begin()->first, 1);
  const std::map<int, std::pair<int, int>> expected{{1, {50, 50}},  {7, {49, 51}},  {13, {48, 52}}, {19, {46, 54}},
                                                    {25, {45, 55}}, {29, {44, 56}}, {30, {47, 53}}};
  for (const auto& [j, range] : expected) EXPECT_EQ(columns.at(j), range) << "row " << j;
}

TEST(SectorRaster, ApexRowOfALevelBeam) {
  SectorRaster raster({.cell_m = 1.0});
  const auto spans = raster.spans(Arc::circular({0.5, 0.5}, degrees(0.0), 3.2, degrees(20.0)));
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0], (RowSpan{0, 1, 4})) << "the cell centred on the apex is left out";
}

/// The obvious way: every centre of the bounding box against the definition.
std::set<Cell> slow_sector(const GridGeometry& grid, const Arc& rim) {
  const double reach = rim.range_m();
  const CellBox box = grid.cells_of({rim.centre() - Vec2{reach, reach}, rim.centre() + Vec2{reach, reach}});
  std::set<Cell> cells;
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j)
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const Vec2 d = grid.centre({i, j}) - rim.centre();
      if (norm(d) > 0.0 && rim.half_path_m(grid.centre({i, j})) <= reach &&
          abs(wrap(bearing(d) - rim.axis())) <= rim.half_width())
        cells.insert({i, j});
    }
  return cells;
}

RC_GTEST_PROP(SectorRasterProperty, EqualsTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  const GridGeometry grid{.cell_m = rng.uniform(0.02, 0.1), .origin = {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  const Pose2 tx{{rng.uniform(-5, 5), rng.uniform(-5, 5)}, degrees(rng.uniform(-180, 180))};
  const double range_m = rng.uniform(0.1, 4.0);
  const Angle beam = degrees(rng.uniform(2.0, 179.0));
  const Pose2 rx{tx.position + 0.5 * range_m * Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)}, tx.heading};
  const Arc rim = rng.below(2) == 0 ? Arc::circular(tx.position, tx.heading, range_m, beam)
                                    : *Arc::elliptical(tx, rx, range_m, beam);
  SectorRaster raster(grid);
  std::set<Cell> cells;
  std::int32_t last_row = std::numeric_limits<std::int32_t>::min();
  for (const RowSpan& s : raster.spans(rim)) {
    RC_ASSERT(s.j > last_row);
    RC_ASSERT(s.i_begin < s.i_end);
    last_row = s.j;
    for (std::int32_t i = s.i_begin; i < s.i_end; ++i) cells.insert({i, s.j});
  }
  RC_ASSERT(cells == slow_sector(grid, rim));
}

}  // namespace
}  // namespace echoarc
