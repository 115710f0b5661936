// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

struct ReadOptions {
  std::optional<std::filesystem::path> description;  ///< TOML description of a delimited text
  std::optional<RobotDescription> robot;             ///< replaces the robot the log describes
  std::optional<std::filesystem::path> odometry;     ///< odometry CSV beside a plain range CSV
  ReadLimits limits;
  /// Gets every good line of a JSON Lines log as it stands; of other formats nothing.
  ByteSink* copy_of_jsonl = nullptr;
};

/// Reads a log of any known format: with a description delimited text (a file or a folder), else JSON Lines, CARMEN or
/// plain CSV, recognised by content first and extension second. Errors name file, line and remedy.
[[nodiscard]] Result<Log> read_log(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace echoarc::io
