// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <vector>

#include "echoarc/eval/directions.hpp"
#include "echoarc/eval/point_set.hpp"

namespace echoarc {

/// Where the truth that a scene's maps are held against comes from.
enum class ReferenceSource : std::uint8_t {
  truth,             ///< every point of the world's surfaces that is visible from the path
  structured_light,  ///< what the scene's first laser measured, noise included
};

/// How maps of a scene are judged: the table `[scoring]` of a scene.
struct SceneScoring {
  Box region;  ///< of the grid that is judged
  double cell_m = 0.01;
  std::vector<WallSpan> walls;       ///< directions of interest at right angles to walls
  std::optional<Angle> axis;         ///< parallel directions over the whole region
  std::optional<Vec2> polar_centre;  ///< directions that fan out from a point
  ReferenceSource reference = ReferenceSource::truth;
  int polynomial_degree = 0;  ///< > 0: y as a polynomial of x fitted to the reference ([Barshan07] 4.1)
};

}  // namespace echoarc
