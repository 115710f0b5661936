// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/io/map_server.hpp"
#include "echoarc/io/png_file.hpp"
#include "io/gray_image.hpp"
#include "io/map_yaml.hpp"
#include "support/drawn_map.hpp"

namespace echoarc::io {
namespace {

constexpr std::string_view yaml = "image: m.png\nresolution: 0.1\norigin: [0, 0, 0]\n";

std::string gray_png(std::int32_t width, std::int32_t height, const std::vector<std::uint8_t>& gray) {
  std::vector<std::uint8_t> rgb;
  for (const std::uint8_t g : gray) rgb.insert(rgb.end(), {g, g, g});
  return encode_png(width, height, rgb).value();
}

TEST(PngMap, IsReadLikeAPgm) {
  const auto grid = parse_map(yaml, gray_png(3, 2, {0, 254, 205, 254, 254, 0}), "map.yaml");
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(test::drawing(*grid), (std::vector<std::string>{"#.?", "..#"}));
}

TEST(PngMap, EveryGreySurvivesCodingAndDecoding) {
  std::vector<std::uint8_t> greys(256);
  for (std::size_t k = 0; k < greys.size(); ++k) greys[k] = static_cast<std::uint8_t>(k);
  const auto image = decode_png(gray_png(16, 16, greys), "m.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->gray, greys);
}

TEST(PngMap, EveryTruncationIsAnError) {
  const std::string png = gray_png(3, 2, {0, 254, 205, 254, 254, 0});
  // Without the last 12 bytes (the end marker, IEND) all pixels are there.
  for (std::size_t size = 0; size + 12 < png.size(); ++size)
    EXPECT_FALSE(decode_gray_image(std::string_view(png).substr(0, size), "m.png")) << size << " of " << png.size();
}

TEST(PngMap, TransparentPixelsAreUnknown) {
  const GrayImage image{3, 1, {0, 254, 0}, {255, 255, 0}};
  EXPECT_EQ(test::drawing(states_of(image, MapYaml{.resolution_m = 0.1})), std::vector<std::string>{"#.?"});
}

}  // namespace
}  // namespace echoarc::io
