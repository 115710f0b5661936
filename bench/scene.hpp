// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/pose2.hpp"

namespace echoarc::bench {

struct Segment {
  Vec2 a;
  Vec2 b;
};
struct Circle {
  Vec2 centre;
  double radius_m;
};

/// Surfaces in the plane, metres, with (0, 0) in the lower left corner.
struct Scene {
  Vec2 size;
  std::vector<Segment> walls;
  std::vector<Circle> pillars;
};

/// 20 x 15 m with a block in the middle, four pillars and a cabinet.
[[nodiscard]] Scene hall();
/// 5.25 x 5.25 m, empty: at 1 cm the 525 x 525 cells of [Barshan07]'s rooms.
[[nodiscard]] Scene chamber();
/// 40 x 2.5 m with a row of doorways 0.3 m deep on one side.
[[nodiscard]] Scene corridor();

/// Distance of the nearest point of any surface inside the beam, however slanted the surface; infinity where there is
/// none. Beam width is the full angle, below 180 degrees.
[[nodiscard]] double nearest_surface_m(const Scene& scene, const Pose2& T_world_sensor, Angle beam_width);

}  // namespace echoarc::bench
