// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/io/method_output.hpp"
#include "io/gray_image.hpp"
#include "io/picture/glyphs.hpp"
#include "io/picture/map_layer.hpp"
#include "io/picture/palette.hpp"
#include "io/picture/stroke_font.hpp"
#include "io/picture/view.hpp"
#include "support/drawn_map.hpp"
#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Darkness of every pixel, 0 to 9, of black drawn on white.
std::vector<std::string> shades(const Canvas& canvas) {
  std::vector<std::string> rows;
  for (int y = 0; y < canvas.height(); ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < canvas.width(); ++x)
      row += static_cast<char>('0' + std::lround((255 - canvas.at(x, y).r) * 9 / 255.0));
  }
  return rows;
}

TEST(Canvas, ALineHasRoundEndsAndSmoothEdges) {
  Canvas canvas(7, 4, palette::free);
  const Vec2 line[] = {{1.5, 2.0}, {4.5, 2.0}};
  canvas.stroke(line, 2.0, Color{});
  EXPECT_EQ(shades(canvas), (std::vector<std::string>{"0000000",  //
                                                      "3999930",  //
                                                      "3999930",  //
                                                      "0000000"}));
}

TEST(Canvas, CrossingItselfALineDoesNotGetDarker) {
  Canvas once(9, 9, palette::free);
  Canvas twice = once;
  const Vec2 there[] = {{1, 1}, {8, 8}};
  const Vec2 there_and_back[] = {{1, 1}, {8, 8}, {1, 1}};
  once.stroke(there, 3.0, Color{}, 0.5);
  twice.stroke(there_and_back, 3.0, Color{}, 0.5);
  EXPECT_EQ(shades(once), shades(twice));
}

TEST(Canvas, WhatLiesOutsideIsClipped) {
  Canvas canvas(3, 3, palette::free);
  const Canvas before = canvas;
  const Vec2 far[] = {{-1e12, -50.0}, {1e12, -50.0}};
  canvas.stroke(far, 3.0, Color{});
  canvas.fill_disc({-100.0, 1e300}, 5.0, Color{});
  canvas.fill_rect(-5, -5, 0, 9, Color{});
  EXPECT_TRUE(std::ranges::equal(canvas.rgb_bytes(), before.rgb_bytes()));
}

TEST(StrokeFont, EveryGlyphStaysInItsBoxAndStandsOnce) {
  for (const Glyph& glyph : glyphs) {
    EXPECT_EQ(std::ranges::count(glyphs, glyph.letter, &Glyph::letter), 1) << glyph.letter;
    Canvas canvas(40, 40, palette::free);
    const TextStyle style = {.cap_height = 10.0, .color = {}};
    draw_text(canvas, std::string(1, glyph.letter), {10.0, 20.0}, style);
    bool drawn = false;
    for (int y = 0; y < canvas.height(); ++y)
      for (int x = 0; x < canvas.width(); ++x) {
        if (canvas.at(x, y) == palette::free) continue;
        drawn = true;
        EXPECT_TRUE(x >= 8 && x < 12 + glyph.width && y >= 7 && y < 25) << glyph.letter << " at " << x << ' ' << y;
      }
    EXPECT_EQ(drawn, glyph.letter != ' ') << glyph.letter;
  }
}

TEST(StrokeFont, WidthIsWhereTheTextEnds) {
  Canvas canvas(300, 40, palette::free);
  const TextStyle style = {.cap_height = 12.0, .color = {}};
  EXPECT_DOUBLE_EQ(draw_text(canvas, "5 m, 30 deg", {10.0, 20.0}, style), 10.0 + text_width("5 m, 30 deg", style));
  EXPECT_EQ(text_width("", style), 0.0);
}

TEST(View, SmallMapsAreEnlargedAndLargeOnesReduced) {
  for (const std::int32_t side : {40, 500, 800, 1700, 5000}) {
    const DenseGrid<CellState> grid({0.1, {}}, side, side / 2 + 1, CellState::free);
    PictureContent content;
    content.states = &grid;
    const auto view = fit_view(content);
    ASSERT_TRUE(view);
    EXPECT_GE(view->width, 700) << side;
    EXPECT_LE(view->width, 1600) << side;
    const Vec2 corner = view->pixel({0.1 * side, 0.0});
    EXPECT_GT(corner.x, 0.9 * view->width) << side;
    EXPECT_LT(corner.x, view->width) << side;
  }
}

TEST(View, NothingAndTooMuchAreErrors) {
  EXPECT_FALSE(fit_view({}));
  const DenseGrid<CellState> unknown({0.1, {}}, 5, 5);
  PictureContent content;
  content.states = &unknown;
  EXPECT_FALSE(fit_view(content));
  const Vec2 path[] = {{0.0, 0.0}, {2e5, 0.0}, {nan, nan}};
  content.path = path;
  const auto too_far = fit_view(content);
  ASSERT_FALSE(too_far);
  EXPECT_EQ(too_far.error().code, ErrorCode::too_large);
}

TEST(View, TheScaleBarIsARoundLengthThatFits) {
  View view;
  view.width = 1000;
  for (const auto& [pixels_per_m, metres] :
       {std::pair{100.0, 2.0}, {199.0, 1.0}, {200.0, 1.0}, {39.0, 5.0}, {1e4, 0.02}}) {
    view.pixels_per_m = pixels_per_m;
    EXPECT_DOUBLE_EQ(scale_bar_m(view, 0.2), metres) << pixels_per_m;
  }
}

TEST(Picture, CellsPathAndPointsLieWhereTheyBelong) {
  const auto grid = test::drawn({"?#?",  //
                                 ".#."},
                                {1.0, {10.0, 20.0}});
  const Vec2 path[] = {{10.5, 20.2}, {12.5, 20.2}};
  const MapPoint points[] = {{.position = {12.5, 21.5}}};
  PictureContent content;
  content.states = &grid;
  content.path = path;
  content.points = points;
  const View view = fit_view(content).value();
  const Canvas map = draw_map(content, view);
  const auto color_at = [&](Vec2 world) {
    const Vec2 pixel = view.pixel(world);
    return map.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  EXPECT_EQ(color_at({10.7, 20.7}), palette::free);
  EXPECT_EQ(color_at({11.5, 20.7}), palette::occupied);
  EXPECT_EQ(color_at({11.5, 21.7}), palette::occupied);
  EXPECT_EQ(color_at({10.5, 21.7}), palette::unknown);
  EXPECT_EQ(color_at({12.5, 21.5}), palette::of(PointLabel::centerline));
  EXPECT_EQ(color_at({12.5, 20.2}), palette::path) << "the end mark";
  EXPECT_EQ(color_at({10.5, 20.2}), palette::free) << "the ring at the start";
  EXPECT_NE(color_at({10.7, 20.2}), palette::free) << "the path";
}

TEST(Picture, LinksLieBelowThePointsTheyJoin) {
  const MapPoint points[] = {{.position = {1.0, 1.0}, .label = PointLabel::wall},
                             {.position = {1.0, 1.0}, .label = PointLabel::link},
                             {.position = {2.0, 2.0}, .label = PointLabel::link}};
  PictureContent content;
  content.points = points;
  const View view = fit_view(content).value();
  const Canvas map = draw_map(content, view);
  const auto color_at = [&](Vec2 world) {
    const Vec2 pixel = view.pixel(world);
    return map.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  EXPECT_EQ(color_at({1.0, 1.0}), palette::of(PointLabel::wall));
  EXPECT_EQ(color_at({2.0, 2.0}), palette::of(PointLabel::link));
}

TEST(Picture, ASingleWallCellSurvivesReduction) {
  DenseGrid<CellState> grid({0.01, {}}, 5000, 40, CellState::free);
  grid.at({2503, 17}) = CellState::occupied;
  PictureContent content;
  content.states = &grid;
  const View view = fit_view(content).value();
  const Canvas map = draw_map(content, view);
  const Vec2 pixel = view.pixel({25.035, 0.175});
  EXPECT_EQ(map.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y)), palette::occupied);
}

TEST(Picture, ProbabilityShadesKnownCells) {
  const auto grid = test::drawn({".#?"}, {1.0, {}});
  DenseGrid<float> probability({1.0, {}}, 3, 1, 0.5F);
  PictureContent content;
  content.states = &grid;
  content.probability = &probability;
  const View view = fit_view(content).value();
  const Canvas map = draw_map(content, view);
  const auto color_at = [&](double x) {
    const Vec2 pixel = view.pixel({x, 0.7});
    return map.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  EXPECT_EQ(color_at(0.7), mix(palette::free, palette::occupied, 0.5));
  EXPECT_EQ(color_at(2.03), palette::unknown);
}

TEST(Picture, TheSameContentGivesTheSameBytes) {
  const test::TempFolder folder;
  const auto grid = test::drawn({"?#?", ".#."});
  PictureContent content;
  content.title =
      "A title that is by far too long for a picture of this size, so that it has to be cut off somewhere, "
      "lest it run over the edge of the page; which nobody wants to see \xc3\xa4";
  content.states = &grid;
  ASSERT_TRUE(write_picture(folder / "a.png", content));
  ASSERT_TRUE(write_picture(folder / "b.png", content));
  const std::string bytes = test::contents(folder / "a.png");
  EXPECT_EQ(bytes, test::contents(folder / "b.png"));
  const auto image = decode_png(bytes, "a.png");
  ASSERT_TRUE(image);
  EXPECT_GE(std::max(image->width, image->height), 800);
  EXPECT_LE(std::max(image->width, image->height), 1700);
}

TEST(Picture, MapsOfEveryShapeCanBeDrawn) {
  const test::TempFolder folder;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 3000}, {3000, 1}, {2, 700}}) {
    const DenseGrid<CellState> grid({0.01, {-1e4, 1e4}}, width, height, CellState::occupied);
    PictureContent content;
    content.title = "map";
    content.states = &grid;
    EXPECT_TRUE(write_picture(folder / "map.png", content)) << width << " x " << height;
  }
}

MapExport sample_export(const DenseGrid<CellState>& states) {
  MapExport map;
  map.states = states;
  map.points.add({.position = {0.01, 0.01}, .label = PointLabel::cell, .time_s = nan});
  return map;
}

TEST(MethodOutput, WritesEveryFile) {
  const test::TempFolder folder;
  MapExport map = sample_export(test::drawn({"?#", ".."}));
  map.values = DenseGrid<std::uint16_t>({0.05, {}}, 2, 2, 7);
  ASSERT_TRUE(write_method_output(folder / "dm", map, {.title = "dm"}));
  for (const char* name : {"map.yaml", "map.pgm", "map.png", "points.csv", "grid.npy", "grid.json"})
    EXPECT_TRUE(std::filesystem::exists(folder / "dm" / name)) << name;
}

TEST(MethodOutput, AnEmptyMapHasNoPictureAndNoValues) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_method_output(folder / "dm", {}, {.title = "dm"}));
  EXPECT_TRUE(std::filesystem::exists(folder / "dm/map.yaml"));
  EXPECT_TRUE(std::filesystem::exists(folder / "dm/points.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "dm/map.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "dm/grid.npy"));
}

}  // namespace
}  // namespace echoarc::io
