// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/map_picture.hpp"

#include <array>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

Rgb pixel(const Image& image, std::int32_t column, std::int32_t row) {
  const std::size_t at = 3 * (std::size_t(row) * std::size_t(image.width) + std::size_t(column));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

TEST(MapPicture, UpIsUp) {
  MapPicture picture({{0.0, 0.0}, {4.0, 2.0}}, 40);
  EXPECT_EQ(picture.image().width, 40);
  EXPECT_EQ(picture.image().height, 20);
  picture.add_points(std::array{Vec2{0.05, 1.95}}, {1, 2, 3}, 1);
  EXPECT_EQ(pixel(picture.image(), 0, 0), (Rgb{1, 2, 3}));
  EXPECT_EQ(pixel(picture.image(), 1, 0), (Rgb{255, 255, 255}));
}

TEST(MapPicture, CellsSurfacesAndLabels) {
  DenseGrid<CellState> grid({1.0, {0.0, 0.0}}, 2, 2);
  grid.at({1, 0}) = CellState::occupied;
  grid.at({0, 0}) = CellState::free;
  MapPicture picture({{0.0, 0.0}, {2.0, 2.0}}, 20);
  picture.add_cells(grid);
  EXPECT_EQ(pixel(picture.image(), 15, 15), (Rgb{30, 30, 30}));
  EXPECT_EQ(pixel(picture.image(), 5, 15), (Rgb{255, 255, 255}));
  EXPECT_EQ(pixel(picture.image(), 5, 5), (Rgb{222, 222, 222}));
  sim::WorldDescription world;
  world.walls.push_back({{0.0, 1.05}, {2.0, 1.05}});
  world.discs.push_back({{1.5, 0.5}, 0.2});
  picture.add_surfaces(world, {9, 9, 9}, 1);
  EXPECT_EQ(pixel(picture.image(), 10, 9), (Rgb{9, 9, 9}));
  EXPECT_EQ(pixel(picture.image(), 15, 14), (Rgb{9, 9, 9}));
  MapPoint point;
  point.position = {0.55, 0.55};
  point.label = PointLabel::atm;
  picture.add_points(std::array{point}, 1);
  EXPECT_EQ(pixel(picture.image(), 5, 14), color_of(PointLabel::atm));
}

TEST(MapPicture, WhatIsOutsideIsCutOff) {
  MapPicture picture({{0.0, 0.0}, {1.0, 1.0}}, 10);
  const Image before = picture.image();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  picture.add_points(std::array{Vec2{1e300, 0.0}, Vec2{nan, nan}, Vec2{-5.0, 0.5}}, {0, 0, 0});
  picture.add_line(std::array{Vec2{3.0, 3.0}, Vec2{1e12, 3.0}}, {0, 0, 0});
  EXPECT_EQ(picture.image().rgb, before.rgb);
}

}  // namespace
}  // namespace echoarc::studies
