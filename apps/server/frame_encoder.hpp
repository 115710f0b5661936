// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "echoarc/live/map_store.hpp"
#include "echoarc/live/reading_log.hpp"

/// The binary frames of docs/protocol.md, byte by byte.
namespace echoarc::server {

/// One frame of a WebSocket, shared by all viewers it goes to.
struct Frame {
  std::string bytes;
  bool binary = false;
};
using SharedFrame = std::shared_ptr<const Frame>;

enum class FrameKind : std::uint8_t { pings = 1, tiles = 2, points = 3, laser = 4, path = 5 };
inline constexpr std::size_t frame_head_bytes = 16;
inline constexpr std::uint16_t frame_forgets = 1;  ///< flag: forget all of this kind (and method) before it

struct FrameHead {
  FrameKind kind = FrameKind::pings;
  std::uint8_t method = 0;
  std::uint16_t flags = 0;
  std::uint32_t sequence = 0;
  std::uint32_t question = 0;  ///< id of the question it answers; 0: live
};

/// Pings [begin, end) of the log.
[[nodiscard]] SharedFrame encode_pings(const FrameHead& head, const live::ReadingLog& readings, std::size_t begin,
                                       std::size_t end);
/// Tiles that changed after `since`; null when there are none (and nothing to forget).
[[nodiscard]] SharedFrame encode_tiles(const FrameHead& head, const live::MapStore& store, std::uint32_t since);
/// Points that changed after `since`; `map` tells how many pings support each.
[[nodiscard]] SharedFrame encode_points(const FrameHead& head, const live::MapStore& store, std::uint32_t since);
/// Positions, for laser and path.
[[nodiscard]] SharedFrame encode_positions(const FrameHead& head, std::span<const Vec2> positions);

}  // namespace echoarc::server
