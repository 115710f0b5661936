// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/reference.hpp"
#include "echoarc/eval/scene_scoring.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::studies {

/// Points every `spacing_m` or less on every surface that stands still: walls with both ends, the outlines of discs,
/// the samples of curves.
[[nodiscard]] std::vector<Vec2> surface_points(const sim::WorldDescription& world, double spacing_m = 0.002);

/// Those of `points` that somebody on `path` can see, in their order. A ray per point and eye is held against the
/// world; eyes that saw the point before are asked first, so that it costs about one ray per visible point.
[[nodiscard]] std::vector<Vec2> visible_points(const sim::World& world, std::span<const Vec2> points,
                                               std::span<const Vec2> path);

/// Positions at least `step_m` apart along a log's true path, or its odometry where it has no truth.
[[nodiscard]] std::vector<Vec2> path_positions(const Log& log, double step_m = 0.02);

/// Where the returns of the log's first laser lie, placed by the true poses ([Barshan07] 4.1: the structured-light
/// profile). Errors: no laser, no scan with a return.
[[nodiscard]] Result<std::vector<Vec2>> laser_points(const Log& log);

/// The reference of a run, as its scoring says: what is visible from the path, or what the laser measured; then,
/// where a degree is given, y as a polynomial of x through it, sampled every 2 mm. Points outside `scoring.region` by
/// more than 0.5 m are left out. Errors: nothing visible; as for `laser_points` and `fit_polynomial`.
[[nodiscard]] Result<Reference> scene_reference(const sim::World& world, const Log& log, const SceneScoring& scoring);

/// All directions of interest that a scoring names: across its walls, along its axis, around its centre (every
/// 0.25 degrees).
[[nodiscard]] DirectionSet scene_directions(const SceneScoring& scoring);

}  // namespace echoarc::studies
