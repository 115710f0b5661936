// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/io/npy.hpp"
#include "echoarc/io/points_csv.hpp"
#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

using test::contents;

std::string header(std::string_view dictionary) {
  std::string bytes("\x93NUMPY\x01\x00\x76\x00", 10);
  bytes += dictionary;
  bytes.append(127 - bytes.size(), ' ');
  return bytes + '\n';
}

TEST(Npy, FloatsAreLittleEndianRowZeroFirst) {
  const test::TempFolder folder;
  DenseGrid<float> grid({0.1, {}}, 3, 2);
  grid.at({0, 0}) = 1.0F;
  grid.at({2, 1}) = -2.5F;
  ASSERT_TRUE(write_npy(folder / "grid.npy", grid));
  const std::string zeros(4, '\0');
  const std::string one("\x00\x00\x80\x3f", 4);
  const std::string minus_two_and_a_half("\x00\x00\x20\xc0", 4);
  EXPECT_EQ(contents(folder / "grid.npy"), header("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }") + one +
                                               zeros + zeros + zeros + zeros + minus_two_and_a_half);
}

TEST(Npy, SixteenBitNumbersKeepTheirOrder) {
  const test::TempFolder folder;
  DenseGrid<std::uint16_t> grid({0.1, {}}, 1, 2);
  grid.at({0, 0}) = 0x0102;
  grid.at({0, 1}) = 0xfffe;
  ASSERT_TRUE(write_npy(folder / "grid.npy", grid));
  EXPECT_EQ(contents(folder / "grid.npy"),
            header("{'descr': '<u2', 'fortran_order': False, 'shape': (2, 1), }") + std::string("\x02\x01\xfe\xff", 4));
}

TEST(Npy, GeometryStandsBesideTheValues) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_grid_json(folder / "grid.json", {0.05, {-1.25, 3.0}}, 40, 20));
  EXPECT_EQ(
      contents(folder / "grid.json"),
      "{\n  \"cell_m\": 0.05,\n  \"origin\": [\n    -1.25,\n    3.0\n  ],\n  \"width\": 40,\n  \"height\": 20\n}\n");
}

TEST(PointsCsv, OneLineAPoint) {
  PointMap points;
  const PingId support[] = {7, 8, 12};
  points.add({.position = {1.5, -0.25}, .bound_m = 0.1, .time_s = 3.04, .sensor = 5, .ping = 12}, support);
  points.add({.position = {1e-9, 1234567.125},
              .label = PointLabel::cell,
              .bound_m = 0.035,
              .time_s = std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(points_csv(points),
            "x,y,label,bound,t,sensor,ping,support\n"
            "1.5,-0.25,centerline,0.1,3.04,5,12,7;8;12\n"
            "1e-09,1234567.125,cell,0.035,,,,\n");
}

TEST(PointsCsv, BeliefsAreFourMoreColumns) {
  PointMap points;
  const PingId support[] = {3};
  points.add({.position = {1.0, 2.0}, .label = PointLabel::wall, .bound_m = 0.05, .time_s = 1.0, .ping = 3}, support,
             {{0.0, -1.0}, 0.75, true});
  points.add({.position = {1.0, 3.0}, .label = PointLabel::link, .bound_m = 0.1, .time_s = 2.0, .ping = 4}, {},
             {{-1.0, 0.0}, 0.9, false});
  EXPECT_EQ(points_csv(points),
            "x,y,label,bound,t,sensor,ping,support,nx,ny,p,provisional\n"
            "1,2,wall,0.05,1,0,3,3,0,-1,0.75,1\n"
            "1,3,link,0.1,2,0,4,,-1,0,0.9,0\n");
}

TEST(PointsCsv, AnEmptyMapHasAHeader) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_points_csv(folder / "points.csv", PointMap{}));
  EXPECT_EQ(contents(folder / "points.csv"), "x,y,label,bound,t,sensor,ping,support\n");
}

}  // namespace
}  // namespace echoarc::io
