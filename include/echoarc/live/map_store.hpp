// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::live {

/// p(occupied) of a cell in a byte: 0 unknown, else 1 + round(254 p).
using TileBytes = std::array<std::uint8_t, 64 * 64>;

/// A point as viewers draw it; it keeps its slot while it lives.
struct DrawnPoint {
  MapPoint point;
  std::optional<Vec2> arc_centre;
  double probability = 1.0;
  bool provisional = false;
  bool gone = false;
  friend bool operator==(const DrawnPoint& a, const DrawnPoint& b);
};

/// The newest map of one method, and when each part of it last changed: what a viewer lacks is what changed after the
/// sequence number that it has. So viewers need no queue, and one that skips ten states is sent the newest alone.
class MapStore {
 public:
  struct TileIndex { std::int32_t column = 0; std::int32_t row = 0; auto operator<=>(const TileIndex&) const = default; };

  /// Takes a new export; parts that differ from before get a new sequence number. `arc_centre_of`: the centre of a
  /// ping's arc, if known.
  void update(const MapExport& map, const std::function<std::optional<Vec2>(PingId)>& arc_centre_of);
  /// Forgets everything; viewers are told so.
  void reset();

  [[nodiscard]] std::uint32_t sequence() const { return sequence_; }
  /// Viewers with an older number than this must forget all they have.
  [[nodiscard]] std::uint32_t reset_at() const { return reset_at_; }
  [[nodiscard]] const std::optional<GridGeometry>& geometry() const { return geometry_; }
  void visit_tiles(std::uint32_t since, const std::function<void(TileIndex, const TileBytes&)>& visit) const;
  void visit_points(std::uint32_t since, const std::function<void(std::uint32_t slot, const DrawnPoint&)>& visit) const;
  /// The slot's place in the last export's points, if it lives.
  [[nodiscard]] std::optional<std::size_t> index_of(std::uint32_t slot) const;

 private:
  std::uint32_t sequence_ = 0;
  std::uint32_t reset_at_ = 0;
  std::optional<GridGeometry> geometry_;
  // the rest is up to the implementation
};

}  // namespace echoarc::live
