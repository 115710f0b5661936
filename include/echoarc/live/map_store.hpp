// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "echoarc/live/cell_layer.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::live {

/// p(occupied) of a cell in a byte: 0 unknown, else 1 + round(254 p).
using TileBytes = std::array<std::uint8_t, std::size_t{64} * 64>;

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
  struct TileIndex {
    std::int32_t column = 0;
    std::int32_t row = 0;
    auto operator<=>(const TileIndex&) const = default;
  };

  MapStore() = default;
  /// The map of a method that was there before, perhaps: whoever had its numbers up to `removed_at` must forget them.
  explicit MapStore(std::uint32_t removed_at) : sequence_(removed_at > 0 ? removed_at + 1 : 0), reset_at_(sequence_) {}

  /// Takes a new export; parts that differ from before get a new sequence number. `arc_centre_of`: the centre of a
  /// ping's arc, if known. Cells of point methods are left out (they are their points), and points of grids (they are
  /// the centres of their occupied cells).
  void update(const MapExport& map, const std::function<std::optional<Vec2>(PingId)>& arc_centre_of,
              const CellLayer& layer = {});
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
  struct Tile {
    TileBytes bytes{};
    std::uint32_t changed = 0;
    bool seen = false;
  };
  struct Slot {
    DrawnPoint drawn;
    std::uint32_t changed = 0;
    std::uint32_t seen = 0;  ///< update in which the map last had it
    std::size_t index = 0;   ///< in that map
  };
  /// Points of one ping and label are told apart by their order.
  struct PointKey {
    PingId ping = 0;
    PointLabel label = PointLabel::centerline;
    std::uint32_t occurrence = 0;
    friend bool operator==(const PointKey&, const PointKey&) = default;
  };
  struct PointKeyHash {
    std::size_t operator()(const PointKey& key) const;
  };

  void update_tiles(const MapExport& map, const CellLayer& layer, std::uint32_t next);
  void draw_tiles(const MapExport& map, CellMeaning meaning, std::int32_t first_i, std::int32_t first_j,
                  std::uint32_t next);
  void put_tile(TileIndex index, const TileBytes& bytes, std::uint32_t next);
  void update_points(const MapExport& map, const std::function<std::optional<Vec2>(PingId)>& arc_centre_of,
                     std::uint32_t next);
  std::uint32_t take_slot();
  void drop_unseen_points(std::uint32_t next);

  std::uint32_t sequence_ = 0;
  std::uint32_t reset_at_ = 0;
  std::uint32_t update_ = 0;
  bool changed_ = false;
  std::optional<GridGeometry> geometry_;
  std::map<TileIndex, Tile> tiles_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
  std::unordered_map<PointKey, std::uint32_t, PointKeyHash> slot_of_;
  std::unordered_map<PointKey, std::uint32_t, PointKeyHash> occurrences_;  ///< of one update; kept for its memory
};

}  // namespace echoarc::live
