// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/map_store.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoarc::live {
namespace {

constexpr std::int32_t tile_size = 64;

/// NaN equals NaN here: a bound that is unknown and stays so has not changed.
bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

std::uint8_t byte_of(CellMeaning meaning, double value, CellState state) {
  const auto p = probability_of(meaning, value, state);
  if (!p || std::isnan(*p)) return 0;
  return std::uint8_t(1 + std::lround(254.0 * std::clamp(*p, 0.0, 1.0)));
}

/// Rounds down, below zero as well.
std::int32_t tile_of(std::int32_t cell) {
  return cell >= 0 ? cell / tile_size : -((-cell + tile_size - 1) / tile_size);
}

bool same_slot(const DrawnPoint& drawn, const MapPoint& point, const PointBelief& belief) {
  const MapPoint& had = drawn.point;
  return !drawn.gone && had.position == point.position && had.label == point.label && had.ping == point.ping &&
         had.sensor == point.sensor && had.support_count == point.support_count && same(had.bound_m, point.bound_m) &&
         same(had.time_s, point.time_s) && drawn.probability == belief.probability &&
         drawn.provisional == belief.provisional;
}

/// The bytes of one row of cells, from the values or, without, the states alone.
class RowBytes {
 public:
  RowBytes(const MapExport& map, CellMeaning meaning) : map_(map), meaning_(meaning) {}

  void draw(std::int32_t j, std::int32_t begin, std::int32_t end, std::uint8_t* out) const {
    const std::span<const CellState> states = map_.states.row(j);
    if (meaning_ == CellMeaning::state) {
      for (std::int32_t i = begin; i < end; ++i)
        *out++ = states[std::size_t(i)] == CellState::unknown ? std::uint8_t{0}
                                                              : byte_of(meaning_, 0.0, states[std::size_t(i)]);
      return;
    }
    const auto* values = std::get_if<DenseGrid<float>>(&map_.values);
    if (values == nullptr) return;
    float last = 0.0F;  // neighbours are often alike, and exp is what costs
    std::uint8_t last_byte = byte_of(meaning_, 0.0, CellState::unknown);
    for (const float value : values->row(j).subspan(std::size_t(begin), std::size_t(end - begin))) {
      if (value != last) {
        last = value;
        last_byte = byte_of(meaning_, double(value), CellState::unknown);
      }
      *out++ = last_byte;
    }
  }

 private:
  const MapExport& map_;
  CellMeaning meaning_;
};

}  // namespace

bool operator==(const DrawnPoint& a, const DrawnPoint& b) {
  if (a.gone || b.gone) return a.gone == b.gone;
  return same_slot(a, b.point, {{}, b.probability, b.provisional}) && a.arc_centre == b.arc_centre;
}

std::size_t MapStore::PointKeyHash::operator()(const PointKey& key) const {
  const std::uint64_t mixed =
      (key.ping * 16 + std::uint64_t(key.label)) * 0x9e3779b97f4a7c15ULL + key.occurrence * 0xbf58476d1ce4e5b9ULL;
  return std::size_t(mixed ^ (mixed >> 29));
}

void MapStore::reset() {
  reset_at_ = ++sequence_;
  geometry_.reset();
  tiles_.clear();
  slots_.clear();
  free_slots_.clear();
  slot_of_.clear();
}

void MapStore::update(const MapExport& map, const std::function<std::optional<Vec2>(PingId)>& arc_centre_of,
                      const CellLayer& layer) {
  if (has_cells(map) && geometry_) {
    const double cell_m = map.states.geometry().cell_m;
    const bool other_grid = layer.geometry ? *layer.geometry != *geometry_ : cell_m != geometry_->cell_m;
    if (other_grid && !map.states.empty()) reset();
  }
  const std::uint32_t next = sequence_ + 1;
  changed_ = false;
  ++update_;
  if (has_cells(map))
    update_tiles(map, layer, next);
  else
    update_points(map, arc_centre_of, next);
  if (changed_) sequence_ = next;
}

void MapStore::update_tiles(const MapExport& map, const CellLayer& layer, std::uint32_t next) {
  for (auto& [index, tile] : tiles_) tile.seen = false;
  if (!map.states.empty()) {
    const GridGeometry& part = map.states.geometry();
    if (!geometry_) geometry_ = layer.geometry.value_or(part);
    const Vec2 shift = (part.origin - geometry_->origin) / part.cell_m;
    draw_tiles(map, layer.meaning, std::int32_t(std::lround(shift.x)), std::int32_t(std::lround(shift.y)), next);
  }
  // A tile that is empty now stays as zeros, so that those who have it hear of it.
  constexpr TileBytes zeros{};
  for (auto& [index, tile] : tiles_)
    if (!tile.seen) put_tile(index, zeros, next);
}

/// `first_i`, `first_j`: where the export's lower left cell lies in the method's grid.
void MapStore::draw_tiles(const MapExport& map, CellMeaning meaning, std::int32_t first_i, std::int32_t first_j,
                          std::uint32_t next) {
  const RowBytes rows(map, meaning);
  const std::int32_t width = map.states.width();
  const std::int32_t height = map.states.height();
  TileBytes bytes;
  for (std::int32_t row = tile_of(first_j); row * tile_size < first_j + height; ++row)
    for (std::int32_t column = tile_of(first_i); column * tile_size < first_i + width; ++column) {
      bytes.fill(0);
      const std::int32_t i0 = column * tile_size - first_i;
      const std::int32_t j0 = row * tile_size - first_j;
      const std::int32_t begin = std::max(0, i0);
      for (std::int32_t j = std::max(0, j0); j < std::min(height, j0 + tile_size); ++j)
        rows.draw(j, begin, std::min(width, i0 + tile_size),
                  bytes.data() + std::size_t(j - j0) * tile_size + std::size_t(begin - i0));
      put_tile({column, row}, bytes, next);
    }
}

void MapStore::put_tile(TileIndex index, const TileBytes& bytes, std::uint32_t next) {
  auto found = tiles_.find(index);
  if (found == tiles_.end()) {
    if (std::ranges::all_of(bytes, [](std::uint8_t b) { return b == 0; })) return;
    found = tiles_.try_emplace(index).first;
  }
  Tile& tile = found->second;
  tile.seen = true;
  if (tile.bytes == bytes) return;
  tile.bytes = bytes;
  tile.changed = next;
  changed_ = true;
}

void MapStore::update_points(const MapExport& map, const std::function<std::optional<Vec2>(PingId)>& arc_centre_of,
                             std::uint32_t next) {
  occurrences_.clear();
  const std::span<const MapPoint> points = map.points.points();
  const std::span<const PointBelief> beliefs = map.points.beliefs();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const MapPoint& point = points[k];
    const PointBelief belief = k < beliefs.size() ? beliefs[k] : PointBelief{};
    const PingId own = own_ping(map.points, point);
    PointKey key{own, point.label, 0};
    key.occurrence = occurrences_[key]++;
    const auto [place, is_new] = slot_of_.try_emplace(key, 0);
    if (is_new) place->second = take_slot();
    Slot& slot = slots_[place->second];
    slot.seen = update_;
    slot.index = k;
    if (!is_new && same_slot(slot.drawn, point, belief)) continue;
    slot.drawn = {point, arc_centre_of ? arc_centre_of(own) : std::nullopt, belief.probability, belief.provisional,
                  false};
    slot.changed = next;
    changed_ = true;
  }
  drop_unseen_points(next);
}

std::uint32_t MapStore::take_slot() {
  if (free_slots_.empty()) {
    slots_.emplace_back();
    return std::uint32_t(slots_.size() - 1);
  }
  const std::uint32_t slot = free_slots_.back();
  free_slots_.pop_back();
  return slot;
}

void MapStore::drop_unseen_points(std::uint32_t next) {
  std::vector<std::uint32_t> dropped;
  std::erase_if(slot_of_, [&](const auto& entry) {
    Slot& slot = slots_[entry.second];
    if (slot.seen == update_) return false;
    slot.drawn.gone = true;
    slot.changed = next;
    dropped.push_back(entry.second);
    return true;
  });
  if (dropped.empty()) return;
  changed_ = true;
  // Not in the order of the hash: the same maps give the same slots everywhere.
  std::ranges::sort(dropped, std::greater<>());
  free_slots_.insert(free_slots_.end(), dropped.begin(), dropped.end());
}

void MapStore::visit_tiles(std::uint32_t since, const std::function<void(TileIndex, const TileBytes&)>& visit) const {
  for (const auto& [index, tile] : tiles_)
    if (tile.changed > since) visit(index, tile.bytes);
}

void MapStore::visit_points(std::uint32_t since,
                            const std::function<void(std::uint32_t slot, const DrawnPoint&)>& visit) const {
  for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
    if (slots_[slot].changed > since) visit(slot, slots_[slot].drawn);
}

std::optional<std::size_t> MapStore::index_of(std::uint32_t slot) const {
  if (slot >= slots_.size() || slots_[slot].drawn.gone || slots_[slot].changed == 0) return std::nullopt;
  return slots_[slot].index;
}

}  // namespace echoarc::live
