// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "server/frame_encoder.hpp"

namespace echoarc::server::test {

template <class T>
T number_at(const std::string& bytes, std::size_t offset) {
  T value{};
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// What a page holds of the maps, as docs/protocol.md tells it to treat frames.
class PageMaps {
 public:
  struct Map {
    std::map<std::pair<std::int32_t, std::int32_t>, std::string> tiles;
    std::map<std::uint32_t, std::string> points;
    friend bool operator==(const Map&, const Map&) = default;
  };

  /// A `methods` message: maps of methods that no longer run are dropped.
  void take_methods(const std::vector<std::string>& names) {
    methods = names;
    std::map<std::string, Map> kept;
    for (const std::string& name : names) kept[name] = std::move(maps[name]);
    maps = std::move(kept);
  }
  /// A live frame.
  void take(const Frame& frame) {
    const auto kind = static_cast<FrameKind>(number_at<std::uint8_t>(frame.bytes, 0));
    const bool forgets = (number_at<std::uint16_t>(frame.bytes, 2) & frame_forgets) != 0;
    const auto records = number_at<std::uint32_t>(frame.bytes, 4);
    if (kind == FrameKind::tiles || kind == FrameKind::points) {
      const auto index = number_at<std::uint8_t>(frame.bytes, 1);
      ASSERT_LT(index, methods.size()) << "a map of a method that was not told";
      Map& map = maps[methods[index]];
      kind == FrameKind::tiles ? take_tiles(map, frame.bytes, forgets, records)
                               : take_points(map, frame.bytes, forgets, records);
    }
    if (kind == FrameKind::pings) append(pings, frame.bytes, forgets, records, 64);
    if (kind == FrameKind::path) append(path, frame.bytes, forgets, records, 8);
    if (kind == FrameKind::laser) append(laser, frame.bytes, forgets, records, 8);
  }

  std::vector<std::string> methods;
  std::map<std::string, Map> maps;
  std::string pings;  ///< records
  std::string path;
  std::string laser;

 private:
  static void take_tiles(Map& map, const std::string& bytes, bool forgets, std::uint32_t records) {
    constexpr std::size_t tile_bytes = 64 * 64;
    ASSERT_EQ(bytes.size(), frame_head_bytes + records * (8 + tile_bytes));
    if (forgets) map.tiles.clear();
    for (std::size_t at = frame_head_bytes; at < bytes.size(); at += 8 + tile_bytes) {
      const std::pair place{number_at<std::int32_t>(bytes, at), number_at<std::int32_t>(bytes, at + 4)};
      std::string tile = bytes.substr(at + 8, tile_bytes);
      if (tile == std::string(tile_bytes, '\0'))
        map.tiles.erase(place);
      else
        map.tiles[place] = std::move(tile);
    }
  }
  static void take_points(Map& map, const std::string& bytes, bool forgets, std::uint32_t records) {
    ASSERT_EQ(bytes.size(), frame_head_bytes + records * 44);
    if (forgets) map.points.clear();
    for (std::size_t at = frame_head_bytes; at < bytes.size(); at += 44) {
      const auto slot = number_at<std::uint32_t>(bytes, at);
      if ((number_at<std::uint8_t>(bytes, at + 39) & 1) != 0)
        map.points.erase(slot);
      else
        map.points[slot] = bytes.substr(at + 4, 40);
    }
  }
  static void append(std::string& held, const std::string& bytes, bool forgets, std::uint32_t records,
                     std::size_t record_bytes) {
    ASSERT_EQ(bytes.size(), frame_head_bytes + records * record_bytes);
    if (forgets) held.clear();
    held += bytes.substr(frame_head_bytes);
  }
};

}  // namespace echoarc::server::test
