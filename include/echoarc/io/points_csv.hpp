// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>

#include "echoarc/core/result.hpp"
#include "echoarc/maps/point_map.hpp"

namespace echoarc::io {

/// The points as text: a header line `x,y,label,bound,t,sensor,ping,support`, then one line a point. Metres and seconds
/// in the shortest form that reads back as the same number; `support` are ping ids joined by ";". A cell has no time,
/// sensor and ping of its own: these columns are empty. Maps with beliefs have four more columns,
/// `nx,ny,p,provisional`: the unit normal out of the surface, the probability, and 1 for points that may still move,
/// else 0.
[[nodiscard]] std::string points_csv(const PointMap& points);
[[nodiscard]] Result<void> write_points_csv(const std::filesystem::path& path, const PointMap& points);

/// The segments of a map as text: a header line `x1,y1,x2,y2,label`, then one line a segment, in metres.
[[nodiscard]] std::string segments_csv(const PointMap& points);
[[nodiscard]] Result<void> write_segments_csv(const std::filesystem::path& path, const PointMap& points);

}  // namespace echoarc::io
