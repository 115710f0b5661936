// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/sim/world.hpp"
#include "sim/mirror.hpp"
#include "sim/spatial_index.hpp"

namespace echoarc::sim {

/// Which walls meet where.
struct Topology {
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};

  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 2>> ends_of_wall;  ///< vertices at a and b
  std::vector<std::uint32_t> walls_start;                  ///< of vertex v: walls [walls_start[v], walls_start[v + 1])
  std::vector<std::uint32_t> walls;
  std::vector<std::array<std::uint32_t, 2>> ends_of_curve;

  [[nodiscard]] std::span<const std::uint32_t> walls_at(std::uint32_t vertex) const {
    return std::span(walls).subspan(walls_start[vertex], walls_start[vertex + 1] - walls_start[vertex]);
  }
};

/// The bumps of rough walls, wall by wall along each; those on the left side first, then those on the right.
struct Bumps {
  std::vector<Scatterer> points;
  std::vector<std::uint32_t> start_of_surface;  ///< surfaces: walls, then curves; two sides each

  [[nodiscard]] std::span<const Scatterer> of(std::size_t surface, bool right) const {
    const std::size_t k = 2 * surface + (right ? 1 : 0);
    return std::span(points).subspan(start_of_surface[k], start_of_surface[k + 1] - start_of_surface[k]);
  }
};

/// A world as the searches want it.
struct WorldModel {
  WorldDescription description;
  SpatialIndex index;
  Topology topology;
  Bumps bumps;
  std::vector<Mirror> mirrors;  ///< of walls
  bool has_one_sided = false;   ///< then whether a sees b may differ from whether b sees a

  [[nodiscard]] MaterialId material_of(std::uint32_t item) const;
  [[nodiscard]] double loss_db(MaterialId material) const { return description.materials[material].loss_db; }
  /// `World::visible`.
  [[nodiscard]] bool visible(Vec2 a, Vec2 b, std::span<const Disc> moving) const {
    std::uint64_t work = 0;
    return visible(a, b, moving, work);
  }
  /// Adds the number of items looked at to `work`.
  [[nodiscard]] bool visible(Vec2 a, Vec2 b, std::span<const Disc> moving, std::uint64_t& work) const;
  /// Whether one vertex belongs to both walls; an end on the other's middle does.
  [[nodiscard]] bool share_vertex(std::uint32_t wall, std::uint32_t other) const;
};

/// The errors of `World::make`; none if the description stands.
[[nodiscard]] std::optional<Error> check_description(const WorldDescription& description);
/// `index` finds the walls that others end on. The error says that too many walls lie in one place.
[[nodiscard]] Result<Topology> find_vertices(const WorldDescription& description, const SpatialIndex& index);
[[nodiscard]] Result<Bumps> place_bumps(const WorldDescription& description);

}  // namespace echoarc::sim
