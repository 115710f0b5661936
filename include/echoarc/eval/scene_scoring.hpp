// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/eval/directions.hpp"
#include "echoarc/eval/point_set.hpp"

namespace echoarc {

/// Where the truth that a scene's maps are held against comes from.
enum class ReferenceSource : std::uint8_t {
  truth,             ///< every point of the world's surfaces that is visible from the path
  structured_light,  ///< what the scene's first laser measured, noise included
};

constexpr std::array<Choice<ReferenceSource>, 2> choices(ReferenceSource /*tag*/) {
  return {{{ReferenceSource::truth, "truth"}, {ReferenceSource::structured_light, "structured_light"}}};
}

/// How maps of a scene are judged: the table `[scoring]` of a scene.
struct SceneScoring {
  Box region;  ///< of the grid that is judged
  double cell_m = 0.01;
  std::vector<WallSpan> walls;       ///< directions of interest at right angles to walls
  std::optional<Angle> axis;         ///< parallel directions over the whole region
  std::optional<Vec2> polar_centre;  ///< directions that fan out from a point
  ReferenceSource reference = ReferenceSource::truth;
  int polynomial_degree = 0;  ///< > 0: y as a polynomial of x fitted to the reference ([Barshan07] 4.1)

  /// The part of the table that is options; region and directions are read apart.
  static constexpr auto fields() {
    return std::tuple{
        field("cell_m", &SceneScoring::cell_m, {.unit = "m", .min = 0.001, .max = 10.0, .doc = "of the judged grid"}),
        field("reference", &SceneScoring::reference,
              {.doc = "what maps are held against: the world itself, or what the scene's first laser measured of it",
               .source = "[Barshan07] 4.1"}),
        field("polynomial_degree", &SceneScoring::polynomial_degree,
              {.min = 0,
               .max = 20,
               .doc = "above 0: the reference is y as a polynomial of x, fitted to its points",
               .source = "[Barshan07] 4.1"})};
  }
};

}  // namespace echoarc
