// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace echoarc {

/// What an echo of a simulated sonar came from: truth that a simulator knows and no hardware does.
enum class EchoCause : std::uint8_t {
  unknown,     ///< a real log, or no echo
  wall,        ///< one reflection on a straight wall
  corner,      ///< two or more reflections that ended in a concave corner: the path meets both of its walls
  multiple,    ///< two or more reflections on walls that do not meet: a ghost beyond the wall
  disc,        ///< a cylinder
  curve,       ///< a smoothly curved surface
  edge,        ///< diffraction at a convex edge or the end of a wall
  scatterer,   ///< a bump of a rough wall
  wall_edge,   ///< a wall and an edge
  floor,       ///< the ground
  cross_talk,  ///< an earlier ping of another sensor
  outlier,     ///< noise that crossed the threshold
};

/// In the order of the enumerators; as logs spell them.
inline constexpr std::array<std::string_view, 12> echo_cause_names{"unknown",   "wall",  "corner",     "multiple",
                                                                   "disc",      "curve", "edge",       "scatterer",
                                                                   "wall_edge", "floor", "cross_talk", "outlier"};

[[nodiscard]] constexpr std::string_view name(EchoCause cause) {
  return echo_cause_names[static_cast<std::size_t>(cause)];
}

/// The cause of that name, if there is one.
[[nodiscard]] constexpr std::optional<EchoCause> echo_cause(std::string_view name) {
  for (std::size_t k = 0; k < echo_cause_names.size(); ++k)
    if (echo_cause_names[k] == name) return static_cast<EchoCause>(k);
  return std::nullopt;
}

}  // namespace echoarc
