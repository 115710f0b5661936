// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/reference.hpp"

namespace echoarc::io {

/// Name of the robot's path in an output folder.
inline constexpr std::string_view path_csv_name = "path.csv";

/// Writes `t,x,y,yaw`, one pose a line: seconds, metres, radians, in the shortest form that reads back as the same
/// number.
[[nodiscard]] Result<void> write_path_csv(const std::filesystem::path& path, std::span<const Odometry> poses);

/// The columns `x` and `y` (metres) of a comma separated file with a header line: points.csv, path.csv. Other columns
/// are ignored. Errors name file and line: no such column, a row that is too short, a cell that is no number.
[[nodiscard]] Result<std::vector<Vec2>> read_positions_csv(const std::filesystem::path& path);

/// Surfaces as `polyline,x,y`: neighbouring rows with the same number form one chain of segments. Errors as for
/// `read_positions_csv`.
[[nodiscard]] Result<std::vector<Polyline>> read_polylines_csv(const std::filesystem::path& path);

}  // namespace echoarc::io
