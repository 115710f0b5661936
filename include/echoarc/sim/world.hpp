// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"

namespace echoarc::sim {

/// How a surface answers sound and light.
struct Material {
  std::string name = "wood";
  double loss_db = 0.5;            ///< of every reflection, >= 0
  std::optional<double> rough_db;  ///< strength of the bumps of a rough surface, < 0; none: smooth as a mirror
  double rough_pitch_m = 0.05;     ///< mean distance of the bumps
  bool laser_ok = true;            ///< false: lasers get no return (glass, dark cloth)
};

using MaterialId = std::uint16_t;

// `line` is the line of the scene file an object came from, counted from 1, for messages; 0 where there is none.

/// A straight wall. Two-sided, or a mirror only for what stands on the left of a -> b (its far side is then no
/// obstacle, either).
struct Wall {
  Vec2 a;
  Vec2 b;
  MaterialId material = 0;
  bool one_sided = false;
  std::uint64_t line = 0;
};

/// A solid disc: a post, a bin, a person.
struct Disc {
  Vec2 centre;
  double radius_m = 0.1;
  MaterialId material = 0;
  std::uint64_t line = 0;
};

/// A smooth curve through samples at most 2 mm apart: never facets. Two-sided.
struct SmoothCurve {
  std::vector<Vec2> points;
  MaterialId material = 0;
  std::uint64_t line = 0;
};

/// A disc that moves: on straight lines between the stations, at rest before the first and after the last.
struct MovingDisc {
  struct Station {
    double time_s = 0.0;
    Vec2 centre;
  };
  double radius_m = 0.2;
  MaterialId material = 0;
  std::vector<Station> path;
  std::uint64_t line = 0;

  /// Where it is. Requires a path that is not empty.
  [[nodiscard]] Disc at(double time_s) const;
};

/// Everything that stands in a scene, as its author wrote it. Coordinates in metres, world frame.
struct WorldDescription {
  std::vector<Material> materials{Material{}};
  std::vector<Wall> walls;
  std::vector<Disc> discs;
  std::vector<SmoothCurve> curves;
  std::vector<MovingDisc> moving;
  std::uint64_t seed = 1;  ///< places and strengths of the bumps of rough surfaces
};

/// What a vertex is to sound. The walls (and curves) that meet at a point cut the space around it into sectors; walls
/// are two-sided, so every sector is free space, and at most one of them is wider than 180 degrees.
enum class VertexKind : std::uint8_t {
  concave,  ///< no sector is wider than 180 degrees: no echo of its own, the images make it
  convex,   ///< one sector is: a weak diffracting point for whom it stands in, a concave corner for the others
  end,      ///< the end of a wall or curve that stands free: a weak diffracting point from all sides
};

/// A point where walls end. Ends closer than 1e-6 m are the same point; an end on another wall's middle meets it there.
struct Vertex {
  Vec2 point;
  VertexKind kind = VertexKind::end;
  /// The sector it echoes into, counter-clockwise between these unit vectors; equal: all around.
  Vec2 from;
  Vec2 to;

  /// Whether a point lies in that sector.
  [[nodiscard]] bool echoes_to(Vec2 listener) const;
};

/// A bump of a rough wall or curve: the same point for every ping.
struct Scatterer {
  Vec2 point;
  Vec2 facing;  ///< unit normal of its side of the wall; it echoes into the half plane before it
  double gain_db = 0.0;

  [[nodiscard]] bool echoes_to(Vec2 listener) const { return dot(listener - point, facing) > 0.0; }
};

/// What a ray met first.
struct RayHit {
  double distance_m = 0.0;
  MaterialId material = 0;
};

struct WorldModel;  // src/sim/world_model.hpp: the searchable form

/// A checked world that answers "what does a ray meet" and "do two points see each other" in a time that hardly grows
/// with its size. Immutable after `make`, so that any number of threads may ask at once.
class World {
 public:
  static constexpr std::size_t max_walls = 1'000'000;
  static constexpr std::size_t max_curve_points = 10'000'000;
  static constexpr std::size_t max_scatterers = 20'000'000;
  static constexpr double max_coordinate_m = 1e5;

  /// Errors, each at the line of the object: a wall shorter than 1e-6 m, coordinates that are not finite or beyond
  /// `max_coordinate_m`, radii that are not positive, a curve with fewer than 3 points, steps above 2 mm, or one that
  /// crosses itself, an unknown material, a negative loss, a rough material of non-negative strength or a pitch below
  /// 1 mm, a moving disc whose times do not grow, more than `max_walls` walls.
  [[nodiscard]] static Result<World> make(WorldDescription description);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  [[nodiscard]] const WorldDescription& description() const;
  [[nodiscard]] std::span<const Vertex> vertices() const;
  [[nodiscard]] std::span<const Scatterer> scatterers() const;
  [[nodiscard]] const WorldModel& model() const;
  /// The moving discs where they are at a time.
  [[nodiscard]] std::vector<Disc> moving_at(double time_s) const;

  /// The nearest surface along a ray. `direction` of unit length; surfaces nearer than 1e-9 m are behind the eye.
  /// One-sided walls are met from their left alone.
  [[nodiscard]] std::optional<RayHit> first_hit(Vec2 origin, Vec2 direction, double max_m,
                                                std::span<const Disc> moving = {}) const;
  /// Whether nothing stands between two points on the way from `a` to `b`; the last 1e-6 m at both ends do not count.
  /// The order of the points matters to one-sided walls alone. A line along a wall is blocked by it.
  [[nodiscard]] bool visible(Vec2 a, Vec2 b, std::span<const Disc> moving = {}) const;
  /// Distance to the nearest surface, up to `max_m`; 0 inside a disc.
  [[nodiscard]] double clearance(Vec2 point, double max_m, std::span<const Disc> moving = {}) const;

 private:
  explicit World(std::unique_ptr<const WorldModel> model);
  std::unique_ptr<const WorldModel> model_;
};

}  // namespace echoarc::sim
