// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/reference.hpp"

#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace echoarc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(PolylineReference, SamplesBothEndsAndNoGapBeyondTheSpacing) {
  const std::vector<Polyline> corner = {{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.0311}}};
  const auto reference = polyline_reference(corner, "corner");
  ASSERT_TRUE(reference) << reference.error().message;
  const auto points = reference->points.points();
  ASSERT_EQ(points.size(), 1U + 250U + 16U);
  EXPECT_EQ(points.front(), (Vec2{0.0, 0.0}));
  EXPECT_EQ(points[250], (Vec2{0.5, 0.0}));
  EXPECT_EQ(points.back(), (Vec2{0.5, 0.0311}));
  EXPECT_EQ(reference->spacing_m, 0.002);
  EXPECT_EQ(reference->provenance, "corner");
}

RC_GTEST_PROP(PolylineReference, NeighboursAreWithinTheSpacing, ()) {
  const auto millimetre = rc::gen::inRange(-3000, 3000);
  const auto vertices = *rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(millimetre, millimetre));
  RC_PRE(!vertices.empty());
  const double spacing_m = 0.001 * *rc::gen::inRange(1, 700);
  std::vector<Polyline> surface(1);
  for (const auto& [x, y] : vertices) surface[0].push_back({0.001 * x, 0.001 * y});
  const auto reference = polyline_reference(surface, "", spacing_m);
  RC_ASSERT(reference.has_value());
  const auto points = reference->points.points();
  RC_ASSERT(points.front() == surface[0].front());
  RC_ASSERT(points.back() == surface[0].back());
  for (std::size_t k = 1; k < points.size(); ++k) RC_ASSERT(norm(points[k] - points[k - 1]) <= spacing_m + 1e-12);
}

TEST(PolylineReference, OneVertexIsAPole) {
  const auto reference = polyline_reference(std::vector<Polyline>{{}, {{1.0, 2.0}}}, "pole");
  ASSERT_TRUE(reference);
  EXPECT_EQ(reference->points.size(), 1U);
}

TEST(PolylineReference, RefusesWhatIsNoReference) {
  const std::vector<Polyline> wall = {{{0.0, 0.0}, {1.0, 0.0}}};
  EXPECT_FALSE(polyline_reference({}, "nothing"));
  EXPECT_FALSE(polyline_reference(std::vector<Polyline>{{}}, "no vertex"));
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(polyline_reference(wall, "spacing", bad)) << bad;
  EXPECT_FALSE(polyline_reference(std::vector<Polyline>{{{0.0, 0.0}, {nan, 0.0}}}, "NaN"));
  const auto huge = polyline_reference(std::vector<Polyline>{{{0.0, 0.0}, {1e6, 0.0}}}, "millimetres");
  ASSERT_FALSE(huge) << "500 million points";
  EXPECT_FALSE(huge.error().remedy.empty());
  EXPECT_FALSE(polyline_reference(wall, "fine", 1e-300));
}

TEST(MapReference, IsTheOccupiedCells) {
  DenseGrid<CellState> grid({0.05, {0.0, 0.0}}, 4, 4, CellState::free);
  const auto empty = map_reference(grid, "map.yaml");
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().where, "map.yaml");
  grid.at({3, 1}) = CellState::occupied;
  const auto reference = map_reference(grid, "map.yaml");
  ASSERT_TRUE(reference);
  ASSERT_EQ(reference->points.size(), 1U);
  EXPECT_NEAR(reference->points.points()[0].x, 0.175, 1e-12);
  EXPECT_EQ(reference->spacing_m, 0.05);
}

}  // namespace
}  // namespace echoarc
