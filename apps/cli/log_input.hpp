// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <vector>

#include <CLI/App.hpp>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_sink.hpp"

namespace echoarc::cli {

/// The files a log may consist of, as every verb that reads one takes them.
struct LogArguments {
  std::filesystem::path log;
  std::filesystem::path description;  ///< empty: none
  std::filesystem::path odometry;     ///< empty: none
  std::filesystem::path robot;        ///< empty: the robot the log describes
};

/// Declares LOG, and the files below.
void declare_log(CLI::App& app, LogArguments& arguments);
/// Declares --describe, --odometry and --robot.
void declare_log_files(CLI::App& app, LogArguments& arguments);

/// Reads the log. `copy_of_jsonl`: see io::ReadOptions.
[[nodiscard]] Result<Log> load_log(const LogArguments& arguments, io::ByteSink* copy_of_jsonl = nullptr);
/// Tells on stderr what was skipped or odd on the way.
void warn_of(const ReadReport& report);

/// Every file behind the arguments, those of a folder one by one in the order of their names.
[[nodiscard]] std::vector<std::filesystem::path> input_files(const LogArguments& arguments);

}  // namespace echoarc::cli
