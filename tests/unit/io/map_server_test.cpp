// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/map_server.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/drawn_map.hpp"
#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

using test::contents;
using test::drawing;
using test::drawn;
using Rows = std::vector<std::string>;

TEST(MapServer, WritesTheBytesThatOthersExpect) {
  const test::TempFolder folder;
  const auto grid = drawn({"#.?",  //
                           "..#"},
                          {0.05, {-1.5, 2.0}});
  ASSERT_TRUE(write_map(folder.path(), grid));
  EXPECT_EQ(contents(folder / "map.pgm"), std::string("P5\n3 2\n255\n\x00\xfe\xcd\xfe\xfe\x00", 17));
  EXPECT_EQ(contents(folder / "map.yaml"),
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2, 0.0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapServer, ReadsBackWhatItWrote) {
  const test::TempFolder folder;
  const auto grid = drawn({"#.?",  //
                           "..#"},
                          {0.05, {-1.5, 2.0}});
  ASSERT_TRUE(write_map(folder.path(), grid));
  const auto back = read_map_yaml(folder / "map.yaml");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(drawing(*back), drawing(grid));
  EXPECT_EQ(back->geometry(), grid.geometry());
}

RC_GTEST_PROP(MapServer, AnyMapSurvivesTheRoundTrip, ()) {
  const int width = *rc::gen::inRange(1, 9);
  const int height = *rc::gen::inRange(1, 9);
  const double cell_m = *rc::gen::inRange(1, 200) / 1000.0;
  // Far and tiny origins alike; 1e-9 prints with an exponent.
  const Vec2 origin = {*rc::gen::inRange(-1000000, 1000000) / 7.0, *rc::gen::inRange(-9, 9) * 1e-9};
  DenseGrid<CellState> grid({cell_m, origin}, width, height);
  for (CellState& state : grid.values()) state = static_cast<CellState>(*rc::gen::inRange(0, 3));
  const test::TempFolder folder;
  RC_ASSERT(write_map(folder.path(), grid).has_value());
  const auto back = read_map_yaml(folder / "map.yaml");
  RC_ASSERT(back.has_value());
  RC_ASSERT(back->geometry() == grid.geometry());
  RC_ASSERT(drawing(*back) == drawing(grid));
}

TEST(MapServer, AnEmptyMapIsOneUnknownCell) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_map(folder.path(), DenseGrid<CellState>({0.1, {1.0, 2.0}}, 0, 0)));
  const auto back = read_map_yaml(folder / "map.yaml");
  ASSERT_TRUE(back);
  EXPECT_EQ(drawing(*back), Rows{"?"});
}

constexpr std::string_view yaml = "image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n";

Rows parsed(std::string_view text, std::string_view image) {
  const auto grid = parse_map(text, image, "map.yaml");
  return grid ? drawing(*grid) : Rows{grid.error().message};
}

TEST(MapServer, ReadsPlainPgmWithCommentsAndFewGreys) {
  EXPECT_EQ(parsed(yaml, "P2 # plain\n3 1\n# white is\n100\n0 100 # black, white\n79\n"), Rows{"#.?"});
}

TEST(MapServer, TheUnknownGreyStaysUnknownUnderOurThresholdAndNotUnder025) {
  const std::string grey("P5 1 1 255\n\xcd", 12);
  EXPECT_EQ(parsed(yaml, grey), Rows{"?"});
  EXPECT_EQ(parsed(std::string(yaml) + "free_thresh: 0.25\n", grey), Rows{"."});
}

TEST(MapServer, NegateTurnsBlackIntoFree) {
  EXPECT_EQ(parsed(std::string(yaml) + "negate: 1\n", "P2 2 1 255 0 255"), Rows{".#"});
}

TEST(MapServer, UnderstandsQuotesCommentsAndOrder) {
  const test::TempFolder folder;
  test::put(folder / "a #1.pgm", "P2 1 1 255 0");
  test::put(folder / "map.yaml",
            "---\n# made by hand\norigin: [ -1.0 , +2e-1, 0.0 ] # metres\nresolution: 0.5\r\nimage: 'a #1.pgm'\n");
  const auto grid = read_map_yaml(folder / "map.yaml");
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(grid->geometry(), (GridGeometry{0.5, {-1.0, 0.2}}));
}

struct BadYaml {
  std::string_view text;
  std::string_view message;
  std::string_view where;
};

TEST(MapServer, BadYamlIsAnErrorWithLineAndRemedy) {
  const BadYaml cases[] = {
      {"", "image is missing", "map.yaml"},
      {"image: a\nimage: b\n", "image is given twice", "map.yaml:2"},
      {"image: a\njunk\n", "is no line of a map.yaml", "map.yaml:2"},
      {"image: a\nresolution: 0\n", "resolution is no number from 1e-06 to 1000", "map.yaml:2"},
      {"image: a\nresolution: nan\n", "resolution is no number from 1e-06 to 1000", "map.yaml:2"},
      {"image: a\nresolution: 1e300\n", "resolution is no number from 1e-06 to 1000", "map.yaml:2"},
      {"image: a\nresolution: 0.05 m\n", "resolution is no number from 1e-06 to 1000", "map.yaml:2"},
      {"image: a\nresolution: 0.05\n", "origin is missing", "map.yaml"},
      {"image: a\nresolution: 0.05\norigin: [0, 0]\n", "origin is no list of three numbers in reach", "map.yaml:3"},
      {"image: a\nresolution: 0.05\norigin: [0, 0, 0, 0]\n", "origin is no list of three numbers in reach",
       "map.yaml:3"},
      {"image: a\nresolution: 0.05\norigin: [1e300, 0, 0]\n", "origin is no list of three numbers in reach",
       "map.yaml:3"},
      {"image: a\nresolution: 0.05\norigin: [0, 0, 0.5]\n", "origin has yaw 0.5: turned maps are not supported",
       "map.yaml:3"},
      {"image: ''\nresolution: 0.05\norigin: [0, 0, 0]\n", "image names no file", "map.yaml:1"},
      {"image: a\nresolution: 0.05\norigin: [0, 0, 0]\nmode: raw\n", "mode raw is not supported", "map.yaml:4"},
      {"image: a\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: maybe\n", "negate is neither 0 nor 1", "map.yaml:4"},
      {"image: a\nresolution: 0.05\norigin: [0, 0, 0]\nfree_thresh: 0.9\n", "free_thresh lies above occupied_thresh",
       "map.yaml:4"},
  };
  for (const BadYaml& bad : cases) {
    const auto grid = parse_map(bad.text, "P2 1 1 255 0", "map.yaml");
    ASSERT_FALSE(grid) << bad.text;
    EXPECT_EQ(grid.error().message, bad.message);
    EXPECT_EQ(grid.error().where, bad.where) << bad.text;
    EXPECT_FALSE(grid.error().remedy.empty());
  }
}

TEST(MapServer, BadPicturesAreErrors) {
  EXPECT_EQ(parsed(yaml, ""), Rows{"is no PGM picture"});
  EXPECT_EQ(parsed(yaml, "GIF89a"), Rows{"is no PGM picture"});
  EXPECT_EQ(parsed(yaml, "P5"), Rows{"PGM header is incomplete"});
  EXPECT_EQ(parsed(yaml, "P5 2 -2 255\n"), Rows{"PGM header is incomplete"});
  EXPECT_EQ(parsed(yaml, "P5 0 4 255\n"), Rows{"a picture of 0 x 4 pixels is not supported"});
  EXPECT_EQ(parsed(yaml, "P5 2 2 65535\n12345678"), Rows{"PGM with white = 65535 is not supported"});
  EXPECT_EQ(parsed(yaml, "P5 2 2 255\nabc"), Rows{"picture is truncated: 3 of 4 pixels"});
  EXPECT_EQ(parsed(yaml, "P2 2 2 255\n1 2 x 4"), Rows{"picture is truncated: 2 of 4 pixels"});
  EXPECT_EQ(parsed(yaml, "P5 100000 100000 255\n"), Rows{"a picture of 100000 x 100000 pixels is not supported"});
  EXPECT_EQ(parsed(yaml, "P5 4294967295 4294967295 255\n"),
            Rows{"a picture of 4294967295 x 4294967295 pixels is not supported"});
  EXPECT_EQ(parsed(yaml, "P2 16000 16000 255\n1 2 3"), Rows{"picture is truncated: 3 of 256000000 pixels"});
}

TEST(MapServer, MissingFilesAreNamed) {
  const test::TempFolder folder;
  const auto no_yaml = read_map_yaml(folder / "map.yaml");
  ASSERT_FALSE(no_yaml);
  EXPECT_EQ(no_yaml.error().code, ErrorCode::not_found);
  test::put(folder / "map.yaml", yaml);
  const auto no_picture = read_map_yaml(folder / "map.yaml");
  ASSERT_FALSE(no_picture);
  EXPECT_EQ(no_picture.error().where, (folder / "m.pgm").string());
}

TEST(MapServer, AFolderThatIsNotThereIsAnError) {
  const test::TempFolder folder;
  const auto written = write_map(folder / "absent", drawn({"."}));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::unwritable);
}

}  // namespace
}  // namespace echoarc::io
