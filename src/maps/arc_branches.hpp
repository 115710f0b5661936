// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/maps/arc_raster.hpp"

namespace echoarc {

/// The branches of an arc whose radius of curvature is 8 cells and more: one, or two that meet at its top or bottom.
/// They point into \p columns.
[[nodiscard]] std::span<const ArcBranch> find_branches(const Arc& arc, const GridGeometry& geometry,
                                                       std::vector<std::int32_t>& columns,
                                                       std::array<ArcBranch, 2>& branches);

}  // namespace echoarc
