// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/eval/passability.hpp"
#include "echoarc/maps/point_map.hpp"
#include "echoarc/studies/map_picture.hpp"
#include "echoarc/studies/study_host.hpp"

/// How wide an opening in a wall looks in the maps of a drive past it.
namespace echoarc::studies::choset {

/// A stretch a -> b of a scene's wall with one opening in it.
struct Mouth {
  std::string_view scene;
  Vec2 a;
  Vec2 b;
};

/// The opening, along a -> b; empty where no wall is missing.
[[nodiscard]] Gap mouth_opening(const sim::WorldDescription& world, const Mouth& mouth);

struct MouthView {
  double gap_m = 0.0;     ///< the widest gap free of points inside the opening
  double beside_m = 0.0;  ///< the widest one along the walls beside it: what a map must be judged against
  /// Whether somebody who knows the map alone would find the opening: as wide as the robot, wider than gaps in walls.
  [[nodiscard]] bool shows_opening(double robot_m) const { return gap_m >= robot_m && gap_m > beside_m; }
  std::vector<MapPoint> points;
};

struct MouthRun {
  MouthView centerline;
  MouthView atm;             ///< the medians alone, of the ten newest arcs per sonar (IV-D)
  MouthView atm_all;         ///< the medians over all arcs of the drive, as Figs. 16 and 17 draw them
  MouthView atm_centerline;  ///< and the middle of arcs without a crossing
  std::vector<Reading> readings;
};

/// One drive. Points and readings are kept if asked for. Errors: those of `simulate`.
[[nodiscard]] Result<MouthRun> look_at_mouth(const StudyScene& scene, const Mouth& mouth, std::uint64_t seed,
                                             bool keep);

[[nodiscard]] Image mouth_picture(const StudyScene& scene, std::span<const MapPoint> points);
/// All arcs as they were measured.
[[nodiscard]] Image arcs_picture(const StudyScene& scene, std::span<const Reading> readings);

}  // namespace echoarc::studies::choset
