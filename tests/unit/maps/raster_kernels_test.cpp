// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "maps/raster_kernels.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc::kernels {
namespace {

std::vector<const RasterKernels*> all_kernels() {
  std::vector<const RasterKernels*> list(8);
  list.resize(available_raster_kernels(list.data(), list.size()));
  return list;
}

struct Columns {
  std::vector<std::int32_t> begin;
  std::vector<std::int32_t> end;
  friend bool operator==(const Columns&, const Columns&) = default;
};

Columns columns(const RasterKernels& kernels, const SectorShape& shape, std::int32_t j_first, std::size_t count) {
  Columns c{std::vector<std::int32_t>(count), std::vector<std::int32_t>(count)};
  kernels.sector_rows(shape, j_first, count, c.begin.data(), c.end.data());
  return c;
}

/// A circle of `radius` cells about (apex_i, apex_j) between two edges dx >= low_slope dy and dx <= high_slope dy.
SectorShape circle(double apex_i, double apex_j, double radius, double low_slope, double high_slope) {
  SectorShape s{};
  s.apex_j = apex_j;
  s.half_squared = radius * radius;
  s.narrowing = 1.0;
  s.outside = std::ceil(radius) + 1.0;
  s.low_slope[0] = low_slope;
  s.low_offset[1] = -s.outside;
  s.high_slope[1] = high_slope;
  s.high_offset[0] = s.outside;
  s.i_below = std::int32_t(std::floor(apex_i) - s.outside) - 2;
  s.i_above = std::int32_t(std::ceil(apex_i) + s.outside) + 2;
  s.apex_from_below = apex_i - s.i_below;
  s.apex_from_above = s.i_above - apex_i;
  return s;
}

TEST(SectorRows, DrawnSector) {
  //          i = -1 . . . 3
  //  j=3      . x x x .       radius 3.2 about (1, 0), opening upwards between dx >= -dy and dx <= dy
  //  j=2      x x x x x
  //  j=1      . x x x .
  //  j=0      . . x . .
  const SectorShape shape = circle(1.0, 0.0, 3.2, -1.0, 1.0);
  const Columns expected{{1, 0, -1, 0}, {2, 3, 4, 3}};
  for (const auto* kernels : all_kernels()) {
    EXPECT_EQ(columns(*kernels, shape, 0, 4), expected) << kernels->instruction_set;
    const Columns around = columns(*kernels, shape, -1, 6);
    EXPECT_GE(around.begin.front(), around.end.front()) << kernels->instruction_set;
    EXPECT_GE(around.begin.back(), around.end.back()) << kernels->instruction_set;
  }
}

TEST(SectorRows, AlmostLevelEdgeStaysInRange) {
  const SectorShape shape = circle(0.5, 0.25, 100.0, -1e300, 1e300);
  for (const auto* kernels : all_kernels())
    for (const std::int32_t i : columns(*kernels, shape, -100, 201).begin) EXPECT_LE(std::abs(i), 110);
}

TEST(SectorRows, SameColumnsFromEveryInstructionSet) {
  const auto list = all_kernels();
  ASSERT_GE(list.size(), 1U);
  Rng rng(5);
  for (int k = 0; k < 2000; ++k) {
    const double radius = rng.uniform(1.0, 600.0);
    const double slope = rng.normal(0.0, 3.0);
    SectorShape shape = circle(rng.uniform(-1e6, 1e6), rng.uniform(-1e3, 1e3), radius, slope, slope + rng.uniform());
    shape.shear = rng.uniform(-0.2, 0.2);
    shape.narrowing = rng.uniform(0.5, 1.5);
    const auto j_first = std::int32_t(shape.apex_j - radius);
    const Columns first = columns(*list.front(), shape, j_first, std::size_t(2 * radius));
    for (const auto* kernels : list)
      ASSERT_EQ(columns(*kernels, shape, j_first, std::size_t(2 * radius)), first) << kernels->instruction_set;
  }
}

struct Samples {
  std::vector<std::uint64_t> cells;
  std::vector<std::uint64_t> changes;
  friend bool operator==(const Samples&, const Samples&) = default;
};

Samples samples(const RasterKernels& kernels, const ArcShape& shape, std::size_t count) {
  Samples s{std::vector<std::uint64_t>(count + 1), std::vector<std::uint64_t>(count / 64 + 1)};
  kernels.arc_samples(shape, count, s.cells.data(), s.changes.data());
  return s;
}

/// Samples `step` apart from the bearing `first` on.
ArcShape ellipse(double first, double step, double semi_major, double semi_minor, double focal) {
  ArcShape s{};
  s.first_x = std::cos(first);
  s.first_y = std::sin(first);
  for (std::size_t l = 0; l < arc_lanes; ++l) {
    s.lane_x[l] = std::cos(double(l) * step);
    s.lane_y[l] = std::sin(double(l) * step);
  }
  s.turn_x = std::cos(double(arc_lanes) * step);
  s.turn_y = std::sin(double(arc_lanes) * step);
  s.centre_x = s.centre_y = semi_major + 2.25;
  s.semi_major = semi_major;
  s.semi_minor = semi_minor;
  s.focal_x = std::cos(focal);
  s.focal_y = std::sin(focal);
  s.i_base = -7;
  s.j_base = 11;
  s.circular = semi_major == semi_minor;
  return s;
}

TEST(ArcSamples, QuarterTurns) {
  const double quarter = std::acos(0.0);
  const ArcShape shape = ellipse(0.0, quarter, 5.5, 5.5, 0.0);  // about (7.75, 7.75) from cell (-7, 11)
  const std::vector<std::pair<int, int>> turn{{6, 18}, {0, 24}, {-5, 18}, {0, 13}};
  for (const auto* kernels : all_kernels()) {
    const Samples result = samples(*kernels, shape, 8);
    for (std::size_t k = 0; k < 8; ++k) {
      const std::uint64_t cell = result.cells[k + 1];
      EXPECT_EQ(std::pair(int(cell & 0xffffffffU), int(cell >> 32)), turn[k % 4]) << kernels->instruction_set;
    }
    EXPECT_EQ(result.changes[0], 0xffU) << kernels->instruction_set;
  }
}

TEST(ArcSamples, ChangesTellWhereTheCellIsAnother) {
  const std::size_t count = 136;  // two words and a bit
  for (const auto* kernels : all_kernels()) {
    const Samples s = samples(*kernels, ellipse(0.3, 0.5 / 40.0, 40.0, 40.0, 0.0), count);
    std::size_t changed = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const bool bit = (s.changes[k / 64] >> (k % 64) & 1U) != 0;
      EXPECT_EQ(bit, k == 0 || s.cells[k + 1] != s.cells[k]) << kernels->instruction_set << ", sample " << k;
      changed += bit ? 1 : 0;
    }
    EXPECT_GT(changed, count / 2);
    EXPECT_LT(changed, count);
  }
}

TEST(ArcSamples, SameCellsFromEveryInstructionSet) {
  const auto list = all_kernels();
  Rng rng(7);
  for (int k = 0; k < 2000; ++k) {
    const double semi_major = rng.uniform(2.0, 800.0);
    const double semi_minor = k % 2 == 0 ? semi_major : rng.uniform(0.2, 1.0) * semi_major;
    const ArcShape shape =
        ellipse(rng.uniform(-3.0, 3.0), 0.5 / semi_major, semi_major, semi_minor, rng.uniform(-3.0, 3.0));
    const std::size_t count = arc_lanes * (1 + rng.below(40));
    const Samples first = samples(*list.front(), shape, count);
    for (const auto* kernels : list) ASSERT_EQ(samples(*kernels, shape, count), first) << kernels->instruction_set;
  }
}

struct Rows {
  std::vector<std::int32_t> crossing;
  Columns columns;
  friend bool operator==(const Rows&, const Rows&) = default;
};

Rows rows(const RasterKernels& kernels, const ArcRowShape& shape, std::size_t count) {
  const std::size_t room = (count + arc_lanes) / arc_lanes * arc_lanes + arc_lanes;
  Rows r{std::vector<std::int32_t>(room), {std::vector<std::int32_t>(room), std::vector<std::int32_t>(room)}};
  kernels.arc_rows(shape, count, r.crossing.data(), r.columns.begin.data(), r.columns.end.data());
  r.crossing.resize(count + 1);
  r.columns.begin.resize(count);
  r.columns.end.resize(count);
  return r;
}

TEST(ArcRows, RightSideOfACircle) {
  // Radius 5 about (20.5, 0): from (25, 2.2) the edges of rows 3, 4 and 5 meet it at x = 24.5, 23.5 and 20.5.
  ArcRowShape shape{.centre_x = 0.5 + 10.0, .first_dy = 3.0, .half_squared = 25.0, .narrowing = 1.0, .side = 1.0};
  shape.i_base = 10;
  shape.i_last = 25;
  shape.i_low = 24;
  shape.i_high = 20;
  const Rows expected{{24, 24, 23, 20}, {{24, 23, 20}, {25, 25, 24}}};
  for (const auto* kernels : all_kernels()) EXPECT_EQ(rows(*kernels, shape, 3), expected) << kernels->instruction_set;
}

TEST(ArcRows, SameColumnsFromEveryInstructionSet) {
  const auto list = all_kernels();
  Rng rng(8);
  for (int k = 0; k < 2000; ++k) {
    const double radius = rng.uniform(8.0, 900.0);
    ArcRowShape shape{.centre_x = radius + rng.uniform(1.0, 2.0),
                      .first_dy = -radius * rng.uniform(),
                      .shear = rng.uniform(-0.2, 0.2),
                      .half_squared = radius * radius,
                      .narrowing = rng.uniform(0.5, 1.5),
                      .side = k % 2 == 0 ? 1.0 : -1.0};
    shape.i_base = std::int32_t(rng.below(2000)) - 1000;
    shape.i_last = shape.i_base + std::int32_t(2.0 * radius);
    const std::size_t count = 1 + rng.below(std::uint64_t(radius));
    const Rows first = rows(*list.front(), shape, count);
    for (const auto* kernels : list) ASSERT_EQ(rows(*kernels, shape, count), first) << kernels->instruction_set;
  }
}

}  // namespace
}  // namespace echoarc::kernels
