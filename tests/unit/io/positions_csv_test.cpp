// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/positions_csv.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::io {
namespace {

class PositionsCsvTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text) const {
    std::ofstream(file_) << text;
    return file_;
  }
  /// The error's place without the folder.
  template <class T>
  static std::string place(const Result<T>& result) {
    return result ? "no error" : std::filesystem::path(result.error().where).filename().string();
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::path file_ = folder_ / "some.csv";
};

TEST_F(PositionsCsvTest, WrittenPathReadsBackExactly) {
  const std::vector<Odometry> poses = {{.time_s = 0.1, .T_world_robot = {{1.0 / 3.0, -2e-17}, radians(0.5)}},
                                       {.time_s = 0.2, .T_world_robot = {{1e7, 0.1}, radians(-3.0)}}};
  ASSERT_TRUE(write_path_csv(file_, poses));
  const auto positions = read_positions_csv(file_);
  ASSERT_TRUE(positions) << positions.error().message;
  ASSERT_EQ(positions->size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ((*positions)[k], poses[k].T_world_robot.position);
}

TEST_F(PositionsCsvTest, FindsColumnsByName) {
  const auto positions = read_positions_csv(write("label, y ,x\ncell,2,1\r\n\ncell, 4 ,3"));
  ASSERT_TRUE(positions) << positions.error().message;
  EXPECT_EQ(*positions, (std::vector<Vec2>{{1, 2}, {3, 4}}));
}

TEST_F(PositionsCsvTest, NeighbouringRowsOfOneNumberAreAPolyline) {
  const auto polylines = read_polylines_csv(write("polyline,x,y\n5,0,0\n5,1,0\n2,9,9\n5,1,1\n"));
  ASSERT_TRUE(polylines) << polylines.error().message;
  EXPECT_EQ(*polylines, (std::vector<Polyline>{{{0, 0}, {1, 0}}, {{9, 9}}, {{1, 1}}}));
}

TEST_F(PositionsCsvTest, ErrorsNameTheLine) {
  EXPECT_EQ(place(read_positions_csv(write(""))), "some.csv");
  EXPECT_EQ(place(read_positions_csv(write("a,b\n1,2\n"))), "some.csv:1");
  EXPECT_EQ(place(read_positions_csv(write("x,y\n1,2\n1\n"))), "some.csv:3");
  EXPECT_EQ(place(read_positions_csv(write("x,y\n1,here\n"))), "some.csv:2");
  EXPECT_EQ(place(read_positions_csv(write("x,y\n1,nan\n"))), "some.csv:2");
  EXPECT_EQ(place(read_positions_csv(write("x,y\n1,2m\n"))), "some.csv:2");
  EXPECT_EQ(place(read_polylines_csv(write("x,y\n1,2\n"))), "some.csv:1");
  const auto missing = read_positions_csv(folder_ / "no.csv");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace echoarc::io
