// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/frame_encoder.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::server {
namespace {

/// What lies at an offset of a frame, as docs/protocol.md states it.
template <class T>
T at(const SharedFrame& frame, std::size_t offset) {
  T value{};
  if (offset + sizeof value > frame->bytes.size()) {
    ADD_FAILURE() << "the frame ends before " << offset;
    return value;
  }
  std::memcpy(&value, frame->bytes.data() + offset, sizeof value);
  return value;
}

std::string hex(const std::string& bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    text += digits[static_cast<unsigned char>(byte) >> 4U];
    text += digits[static_cast<unsigned char>(byte) & 15U];
  }
  return text;
}

live::JudgedPing echo_at(double range_m) {
  live::JudgedPing ping;
  ping.reading.ping = 77;
  ping.reading.time_s = 1.5;
  ping.reading.tx = 3;
  ping.reading.rx = 4;
  ping.reading.T_world_tx = {{1.0, 2.0}, radians(0.25)};
  ping.reading.T_world_rx = {{1.5, 2.5}, radians(0.5)};
  ping.reading.T_world_robot = {{0.5, 0.75}, radians(-0.25)};
  ping.reading.trusted_range_m = 3.5;
  ping.reading.outcome = Echo{range_m};
  ping.raw_range_m = range_m;
  return ping;
}

MapExport one_point(Vec2 position) {
  MapExport map;
  map.points.add(
      {.position = position, .label = PointLabel::wall, .bound_m = 0.125, .time_s = 2.0, .sensor = 5, .ping = 9});
  return map;
}

TEST(FrameEncoder, PositionsByteByByte) {
  const std::vector<Vec2> positions{{1.0, -2.0}};
  const SharedFrame frame =
      encode_positions({.kind = FrameKind::path, .flags = frame_forgets, .question = 258}, positions);
  EXPECT_TRUE(frame->binary);
  EXPECT_EQ(hex(frame->bytes),
            "05000100"
            "01000000"
            "00000000"
            "02010000"
            "0000803f"
            "000000c0");
}

TEST(FrameEncoder, NoPositionsAreAHeadAlone) {
  EXPECT_EQ(hex(encode_positions({.kind = FrameKind::laser}, {})->bytes),
            "04000000"
            "00000000"
            "00000000"
            "00000000");
}

TEST(FrameEncoder, PingOf64Bytes) {
  live::ReadingLog readings;
  readings.append(echo_at(2.25));
  const SharedFrame frame = encode_pings({.kind = FrameKind::pings}, readings, 0, 1);
  ASSERT_EQ(frame->bytes.size(), 16U + 64U);
  EXPECT_EQ(at<std::uint8_t>(frame, 0), 1);
  EXPECT_EQ(at<std::uint32_t>(frame, 4), 1U);
  EXPECT_EQ(at<double>(frame, 16), 1.5);
  EXPECT_EQ(at<std::uint32_t>(frame, 16 + 8), 77U);
  EXPECT_EQ(at<std::uint16_t>(frame, 16 + 12), 4) << "the receiver comes first";
  EXPECT_EQ(at<std::uint16_t>(frame, 16 + 14), 3);
  EXPECT_EQ(at<float>(frame, 16 + 16), 2.25F);
  EXPECT_EQ(at<float>(frame, 16 + 20), 1.0F);
  EXPECT_EQ(at<float>(frame, 16 + 28), 0.25F);
  EXPECT_EQ(at<float>(frame, 16 + 32), 1.5F);
  EXPECT_EQ(at<float>(frame, 16 + 44), 0.5F);
  EXPECT_EQ(at<float>(frame, 16 + 52), -0.25F);
  EXPECT_EQ(at<float>(frame, 16 + 56), 3.5F);
  EXPECT_EQ(at<std::uint8_t>(frame, 16 + 60), 1);
  EXPECT_EQ(at<std::uint8_t>(frame, 16 + 61), 0);
  EXPECT_EQ(at<std::uint16_t>(frame, 16 + 62), 0);
}

TEST(FrameEncoder, OutcomesOfPings) {
  live::ReadingLog readings;
  live::JudgedPing ping = echo_at(2.0);
  ping.reading.outcome = NoEcho{};
  readings.append(ping);
  ping.reading.outcome = TooClose{};
  readings.append(ping);
  ping.rejected = Rejection::above_max_range;
  ping.raw_range_m = 12.5;
  readings.append(ping);
  ping.raw_range_m = std::numeric_limits<double>::infinity();
  readings.append(ping);
  const SharedFrame frame = encode_pings({.kind = FrameKind::pings}, readings, 0, 4);
  const auto record = [](std::size_t index) { return 16 + 64 * index; };
  EXPECT_EQ(at<std::uint8_t>(frame, record(0) + 60), 0);
  EXPECT_TRUE(std::isnan(at<float>(frame, record(0) + 16)));
  EXPECT_EQ(at<std::uint8_t>(frame, record(1) + 60), 2);
  EXPECT_EQ(at<std::uint8_t>(frame, record(2) + 60), 3);
  EXPECT_EQ(at<std::uint8_t>(frame, record(2) + 61), static_cast<std::uint8_t>(Rejection::above_max_range));
  EXPECT_EQ(at<float>(frame, record(2) + 16), 12.5F) << "what the hardware said";
  EXPECT_TRUE(std::isnan(at<float>(frame, record(3) + 16)));
}

TEST(FrameEncoder, RangeOfPings) {
  live::ReadingLog readings;
  for (int i = 0; i < 5; ++i) readings.append(echo_at(1.0 + i));
  const SharedFrame frame = encode_pings({.kind = FrameKind::pings}, readings, 2, 4);
  ASSERT_EQ(frame->bytes.size(), 16U + 2U * 64U);
  EXPECT_EQ(at<float>(frame, 16 + 16), 3.0F);
  EXPECT_EQ(at<float>(frame, 16 + 64 + 16), 4.0F);
}

TEST(FrameEncoder, PointOf44Bytes) {
  live::MapStore store;
  store.update(one_point({1.0, 2.0}), [](PingId) { return std::optional<Vec2>({0.5, 0.25}); });
  const SharedFrame frame =
      encode_points({.kind = FrameKind::points, .method = 1, .sequence = store.sequence()}, store, 0);
  ASSERT_TRUE(frame);
  ASSERT_EQ(frame->bytes.size(), 16U + 44U);
  EXPECT_EQ(at<std::uint8_t>(frame, 0), 3);
  EXPECT_EQ(at<std::uint8_t>(frame, 1), 1);
  EXPECT_EQ(at<std::uint16_t>(frame, 2), frame_forgets) << "whoever has nothing forgets what it may have";
  EXPECT_EQ(at<std::uint32_t>(frame, 8), store.sequence());
  EXPECT_EQ(at<float>(frame, 16 + 4), 1.0F);
  EXPECT_EQ(at<float>(frame, 16 + 8), 2.0F);
  EXPECT_EQ(at<float>(frame, 16 + 12), 0.125F);
  EXPECT_EQ(at<float>(frame, 16 + 16), 0.5F);
  EXPECT_EQ(at<float>(frame, 16 + 20), 0.25F);
  EXPECT_EQ(at<float>(frame, 16 + 24), 1.0F);
  EXPECT_EQ(at<float>(frame, 16 + 28), 2.0F);
  EXPECT_EQ(at<std::uint32_t>(frame, 16 + 32), 9U);
  EXPECT_EQ(at<std::uint16_t>(frame, 16 + 36), 5);
  EXPECT_EQ(at<std::uint8_t>(frame, 16 + 38), static_cast<std::uint8_t>(PointLabel::wall));
  EXPECT_EQ(at<std::uint8_t>(frame, 16 + 39), 0);
}

TEST(FrameEncoder, PointThatIsGoneIsSaidOnce) {
  const auto no_centre = [](PingId) { return std::optional<Vec2>(); };
  live::MapStore store;
  store.update(one_point({1.0, 2.0}), no_centre);
  const std::uint32_t before = store.sequence();
  EXPECT_FALSE(encode_points({.kind = FrameKind::points}, store, before)) << "nothing changed";
  store.update(MapExport(), no_centre);
  const SharedFrame frame = encode_points({.kind = FrameKind::points}, store, before);
  ASSERT_TRUE(frame);
  EXPECT_EQ(at<std::uint16_t>(frame, 2), 0);
  EXPECT_EQ(at<std::uint32_t>(frame, 4), 1U);
  EXPECT_EQ(at<std::uint8_t>(frame, 16 + 39) & 1, 1);
  EXPECT_FALSE(encode_points({.kind = FrameKind::points}, store, store.sequence()));
}

TEST(FrameEncoder, ResetMakesOldOnesForget) {
  const auto no_centre = [](PingId) { return std::optional<Vec2>(); };
  live::MapStore store;
  store.update(one_point({1.0, 2.0}), no_centre);
  const std::uint32_t before = store.sequence();
  store.reset();
  for (const SharedFrame& frame : {encode_points({.kind = FrameKind::points}, store, before),
                                   encode_tiles({.kind = FrameKind::tiles}, store, before)}) {
    ASSERT_TRUE(frame);
    EXPECT_EQ(at<std::uint16_t>(frame, 2), frame_forgets);
    EXPECT_EQ(at<std::uint32_t>(frame, 4), 0U);
  }
}

TEST(FrameEncoder, TileOf64Rows) {
  live::MapStore store;
  const GridGeometry geometry{0.1, {0.0, 0.0}};
  MapExport map;
  DenseGrid<float> values(geometry, 70, 2);
  values.at({69, 1}) = 0.75F;
  map.states = DenseGrid<CellState>(geometry, 70, 2);
  map.values = std::move(values);
  const live::CellLayer layer{live::CellMeaning::log_odds, "log-odds", geometry};
  store.update(map, [](PingId) { return std::optional<Vec2>(); }, layer);
  const SharedFrame frame = encode_tiles({.kind = FrameKind::tiles, .sequence = store.sequence()}, store, 0);
  ASSERT_TRUE(frame);
  ASSERT_EQ(frame->bytes.size(), 16U + 8U + 64U * 64U) << "a tile in which nothing is known is not sent";
  EXPECT_EQ(at<std::int32_t>(frame, 16), 1);
  EXPECT_EQ(at<std::int32_t>(frame, 20), 0);
  const double p = 1.0 / (1.0 + std::exp(-0.75));
  EXPECT_EQ(at<std::uint8_t>(frame, 24 + 64 + 5), 1 + std::lround(254.0 * p));
  EXPECT_EQ(at<std::uint8_t>(frame, 24 + 5), 0);
}

}  // namespace
}  // namespace echoarc::server
