// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/delimited.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

struct PlainCsvOptions {
  std::optional<RobotDescription> robot;          ///< where the sensors are; required
  std::optional<std::filesystem::path> odometry;  ///< instead of the file found beside the ranges
  ReadLimits limits;
};

/// Reads `t,sensor_id,range_m` beside odometry `t,x,y,yaw`, without any description. The header line names the columns,
/// in any order; a unit may follow the name (`t_ms`, `range_cm`, `yaw_deg`; SI otherwise); `#` starts a comment line.
///
/// The odometry is `NAME.odom.csv`, `odometry.csv` or `odom.csv` in the folder of `NAME.csv`, unless the ranges have
/// columns x, y, yaw themselves. Errors: no such odometry, no robot, columns that are missing.
[[nodiscard]] Result<Log> read_plain_csv(const std::filesystem::path& ranges, const PlainCsvOptions& options);
/// The same with the files named and opened by the caller; each is opened twice. Without `odometry` the ranges must
/// hold x, y and yaw.
[[nodiscard]] Result<Log> read_plain_csv(const std::string& ranges, const std::optional<std::string>& odometry,
                                         const RobotDescription& robot, const TableOpener& open,
                                         const ReadLimits& limits = {});

/// Whether a header line names the columns of such a file.
[[nodiscard]] bool is_plain_csv_header(std::string_view line);

}  // namespace echoarc::io
