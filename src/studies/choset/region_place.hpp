// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/features/depth_regions.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::studies::choset {

/// Where the echo point of a region of constant depth lies in the true world.
enum class RegionPlace : std::uint8_t {
  on_surface,  ///< within `surface_m` of a surface
  beyond,      ///< farther than what stands in its direction: a ghost of several reflections
  before,      ///< nearer, in free space
};
inline constexpr double surface_m = 0.10;

[[nodiscard]] RegionPlace place_of(const DepthRegion& region, const sim::World& world);

/// The sweep as `depth_regions` wants it: bearing and distance of the middle of every arc, seen from the middle of the
/// robot; silence at infinity. All readings from one place.
[[nodiscard]] std::vector<DepthReturn> depth_returns(std::span<const Reading> readings);

}  // namespace echoarc::studies::choset
