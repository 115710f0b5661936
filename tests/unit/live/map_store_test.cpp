// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/map_store.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace echoarc::live {
namespace {

constexpr CellLayer layer{CellMeaning::log_odds, "log-odds", GridGeometry{0.1, {0.05, -0.05}}};

using Cells = std::map<std::pair<int, int>, float>;

MapExport grid_of(const Cells& cells) {
  MapExport map;
  map.values = DenseGrid<float>();
  if (cells.empty()) return map;
  CellBox box;
  for (const auto& [cell, value] : cells) box = unite(box, {cell.first, cell.second, cell.first + 1, cell.second + 1});
  GridGeometry part = *layer.geometry;
  part.origin = layer.geometry->corner({box.i_begin, box.j_begin});
  DenseGrid<float> values(part, std::int32_t(box.width()), std::int32_t(box.height()));
  map.states = DenseGrid<CellState>(part, std::int32_t(box.width()), std::int32_t(box.height()));
  for (const auto& [cell, value] : cells) values.at({cell.first - box.i_begin, cell.second - box.j_begin}) = value;
  map.values = std::move(values);
  return map;
}

/// What a viewer holds.
struct Viewer {
  std::map<MapStore::TileIndex, TileBytes> tiles;
  std::map<std::uint32_t, DrawnPoint> points;
  std::uint32_t sequence = 0;

  void take(const MapStore& store) {
    if (sequence < store.reset_at()) {
      tiles.clear();
      points.clear();
    }
    store.visit_tiles(sequence, [&](MapStore::TileIndex index, const TileBytes& bytes) { tiles[index] = bytes; });
    store.visit_points(sequence, [&](std::uint32_t slot, const DrawnPoint& point) {
      if (point.gone)
        points.erase(slot);
      else
        points[slot] = point;
    });
    sequence = store.sequence();
  }

  [[nodiscard]] int byte_at(int i, int j) const {
    const auto floor_div = [](int a) { return int(std::floor(double(a) / 64.0)); };
    const auto found = tiles.find({floor_div(i), floor_div(j)});
    if (found == tiles.end()) return 0;
    return found->second[std::size_t((j - 64 * floor_div(j)) * 64 + i - 64 * floor_div(i))];
  }
};

RC_GTEST_PROP(MapStore, WhoeverSkipsStatesEndsWithTheNewestCells, ()) {
  MapStore store;
  Viewer often;
  Viewer seldom;
  Cells cells;
  const int rounds = *rc::gen::inRange(1, 8);
  for (int round = 0; round < rounds; ++round) {
    for (int n = *rc::gen::inRange(0, 6); n > 0; --n) {
      const std::pair cell{*rc::gen::inRange(-130, 130), *rc::gen::inRange(-130, 130)};
      if (const int value = *rc::gen::inRange(-8, 9); value == 0)
        cells.erase(cell);
      else
        cells[cell] = float(value);
    }
    if (*rc::gen::inRange(0, 10) == 0) store.reset();
    store.update(grid_of(cells), {}, layer);
    often.take(store);
    if (*rc::gen::inRange(0, 3) == 0) seldom.take(store);
  }
  seldom.take(store);
  for (const Viewer* viewer : {&often, &seldom}) {
    int drawn = 0;
    for (const auto& [index, bytes] : viewer->tiles)
      for (const std::uint8_t byte : bytes) drawn += byte > 0 ? 1 : 0;
    RC_ASSERT(drawn == int(cells.size()));
    for (const auto& [cell, value] : cells) {
      const int expected = 1 + int(std::lround(254.0 / (1.0 + std::exp(-double(value)))));
      RC_ASSERT(viewer->byte_at(cell.first, cell.second) == expected);
    }
  }
  RC_ASSERT(cells.empty() || store.geometry() == layer.geometry);
}

MapPoint point_of(PingId ping, PointLabel label, double x) {
  MapPoint point;
  point.position = {x, 0.0};
  point.label = label;
  point.ping = ping;
  return point;
}

RC_GTEST_PROP(MapStore, PointsKeepTheirSlotsWhateverTheirOrder, ()) {
  MapStore store;
  Viewer often;
  Viewer seldom;
  std::map<PingId, std::uint32_t> slots;
  std::map<PingId, double> points;
  const int rounds = *rc::gen::inRange(1, 8);
  for (int round = 0; round < rounds; ++round) {
    for (int n = *rc::gen::inRange(0, 6); n > 0; --n) {
      const auto ping = PingId(*rc::gen::inRange(0, 12));
      if (*rc::gen::inRange(0, 3) == 0)
        points.erase(ping);
      else
        points[ping] = *rc::gen::inRange(0, 4);
    }
    MapExport map;
    const bool backwards = *rc::gen::arbitrary<bool>();
    std::vector<std::pair<PingId, double>> order(points.begin(), points.end());
    if (backwards) std::reverse(order.begin(), order.end());
    for (const auto& [ping, x] : order) map.points.add(point_of(ping, PointLabel::atm, x));
    store.update(map, [](PingId ping) { return std::optional(Vec2{double(ping), 1.0}); });
    often.take(store);
    if (*rc::gen::inRange(0, 3) == 0) seldom.take(store);
    std::map<PingId, std::uint32_t> now;
    for (const auto& [slot, drawn] : often.points) {
      now[drawn.point.ping] = slot;
      RC_ASSERT(drawn.arc_centre == std::optional(Vec2{double(drawn.point.ping), 1.0}));
      RC_ASSERT(drawn.point.position.x == points.at(drawn.point.ping));
      RC_ASSERT(store.index_of(slot) && map.points.points()[*store.index_of(slot)].ping == drawn.point.ping);
    }
    RC_ASSERT(now.size() == points.size());
    for (const auto& [ping, slot] : now)
      if (slots.contains(ping)) RC_ASSERT(slots.at(ping) == slot);
    slots = now;
  }
  seldom.take(store);
  RC_ASSERT(seldom.points == often.points);
}

TEST(MapStore, WhatDoesNotChangeGetsNoNewNumber) {
  MapStore store;
  MapExport map;
  MapPoint point = point_of(3, PointLabel::carved, 1.0);
  point.bound_m = std::nan("");
  map.points.add(point);
  store.update(map, {});
  const std::uint32_t sequence = store.sequence();
  EXPECT_GT(sequence, 0U);
  store.update(map, {});
  EXPECT_EQ(store.sequence(), sequence);
}

TEST(MapStore, FreeSlotsAreUsedAgain) {
  MapStore store;
  std::uint32_t highest = 0;
  for (PingId ping = 0; ping < 50; ++ping) {
    MapExport map;
    map.points.add(point_of(ping, PointLabel::atm, 0.0));
    store.update(map, {});
    store.visit_points(0, [&](std::uint32_t slot, const DrawnPoint&) { highest = std::max(highest, slot); });
  }
  EXPECT_LE(highest, 1U);
}

TEST(MapStore, AnotherCellSizeStartsAnew) {
  MapStore store;
  store.update(grid_of({{{0, 0}, 1.0F}}), {}, layer);
  const std::uint32_t before = store.sequence();
  CellLayer coarse = layer;
  coarse.geometry->cell_m = 0.2;
  store.update(grid_of({{{0, 0}, 1.0F}}), {}, coarse);
  EXPECT_GT(store.reset_at(), before);
}

}  // namespace
}  // namespace echoarc::live
