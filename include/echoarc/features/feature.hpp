// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "echoarc/core/reading.hpp"

namespace echoarc {

enum class FeatureKind : std::uint8_t {
  tangent,  ///< a line that touches several arcs of one sonar
  line,     ///< a line through a cluster of points
  wall,     ///< a region of constant depth whose normal stays while the robot moves
  corner,   ///< concave: where two walls meet around the robot
  edge,     ///< convex: a point that stays where it is
  region,   ///< a region of constant depth seen too rarely to tell
};
inline constexpr std::size_t feature_kind_count = 6;
/// As files spell it.
[[nodiscard]] constexpr std::string_view name(FeatureKind kind) {
  constexpr std::array<std::string_view, feature_kind_count> names = {"tangent", "line", "wall",
                                                                      "corner",  "edge", "region"};
  return names[static_cast<std::size_t>(kind)];
}

/// A line segment or a point in the world, in metres.
struct Feature {
  FeatureKind kind = FeatureKind::line;
  Vec2 begin;
  Vec2 end;                   ///< of a point the same as `begin`
  double residual_m = 0.0;    ///< root mean square of what the fit left over
  std::uint32_t count = 0;    ///< arcs, points or positions behind it
  std::vector<PingId> pings;  ///< behind it, where they are known

  [[nodiscard]] bool is_point() const { return begin == end; }
};

}  // namespace echoarc
