// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

#include "echoarc/mapping/method.hpp"

namespace echoarc {

/// What point methods hand over: the points, and the cells of `geometry` they lie in as occupied. An error when they
/// are spread too far to be drawn.
[[nodiscard]] Result<MapExport> export_points(const PointMap& points, const GridGeometry& geometry,
                                              std::string_view method);

}  // namespace echoarc
