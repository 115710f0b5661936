// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "echoarc/core/vec2.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// A piece of a ray: origin + t direction, t in [from_m, to_m]; `direction` of unit length.
struct Ray {
  Vec2 origin;
  Vec2 direction;
  double from_m = 0.0;
  double to_m = 0.0;
};

/// A wall as the searches want it.
struct Segment {
  Vec2 a;
  Vec2 along;  ///< b - a
  bool one_sided = false;
  bool rough = false;
};

/// A run of consecutive facets of a curve and a circle around them.
struct CurveChunk {
  static constexpr std::uint32_t facets = 16;
  std::uint32_t curve = 0;
  std::uint32_t first = 0;  ///< facet i goes from point i to point i + 1
  std::uint32_t last = 0;   ///< one past the last facet
  Vec2 centre;
  double radius_m = 0.0;
};

/// Parameter t at which a ray meets a segment, or `never`. Segments reach 1e-9 m beyond their ends, so that no ray
/// slips through a corner.
[[nodiscard]] double crossing(const Ray& ray, const Segment& segment);
/// The same for the rim of a disc: where the ray enters it, or leaves it if it starts inside.
[[nodiscard]] double crossing(const Ray& ray, const Disc& disc);

/// A uniform grid over walls, curve chunks and discs; a cell lists what touches it.
///
/// Cells have 0.5 m, less where many small things stand, or as much more as keeps their number and their lists in
/// proportion to the number of objects: a million walls stay below 200 MB.
class SpatialIndex {
 public:
  SpatialIndex() = default;
  explicit SpatialIndex(const WorldDescription& description);

  /// Items: walls first, then chunks, then discs.
  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }
  [[nodiscard]] std::span<const CurveChunk> chunks() const { return chunks_; }
  [[nodiscard]] std::uint32_t first_chunk() const { return static_cast<std::uint32_t>(segments_.size()); }
  [[nodiscard]] std::uint32_t first_disc() const { return first_chunk() + static_cast<std::uint32_t>(chunks_.size()); }

  [[nodiscard]] std::uint32_t count() const { return first_disc() + static_cast<std::uint32_t>(discs_.size()); }

  struct Cell {
    int x = 0;
    int y = 0;
  };
  [[nodiscard]] Cell cell_at(Vec2 point) const;  ///< clamped to the grid
  [[nodiscard]] std::span<const std::uint32_t> items(Cell cell) const;
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] Vec2 origin() const { return origin_; }

  /// Where the ray meets item number `item`.
  [[nodiscard]] double crossing_of(const Ray& ray, std::uint32_t item) const;
  /// The first item along the ray: {t, item}; t is `never` if there is none.
  struct Hit {
    double t = never;
    std::uint32_t item = 0;
  };
  [[nodiscard]] Hit first_hit(Ray ray) const;
  /// Whether any item stands on the ray. Adds the number of items looked at to `work`.
  [[nodiscard]] bool blocked(const Ray& ray, std::uint64_t& work) const;
  /// Distance from a point to an item; 0 inside a disc.
  [[nodiscard]] double distance(Vec2 point, std::uint32_t item) const;
  [[nodiscard]] double nearest(Vec2 point, double max_m) const;

 private:
  struct Box {
    Vec2 low;
    Vec2 high;
  };
  void choose_cells();
  template <class Visit>
  void cells_of(std::uint32_t item, const Visit& visit) const;
  template <class Visit>
  void walk(const Ray& ray, const Visit& visit) const;
  [[nodiscard]] Box box_of(std::uint32_t item) const;

  std::vector<Segment> segments_;
  std::vector<CurveChunk> chunks_;
  std::vector<std::span<const Vec2>> curves_;
  std::vector<Disc> discs_;
  Vec2 origin_;
  double cell_m_ = 0.5;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint64_t> starts_;
  std::vector<std::uint32_t> items_;
};

/// Distance from a point to the segment a, a + along.
[[nodiscard]] double distance_to_segment(Vec2 point, Vec2 a, Vec2 along);

}  // namespace echoarc::sim
