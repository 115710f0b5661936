// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/log_input.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/report.hpp"
#include "echoarc/io/read_log.hpp"
#include "echoarc/io/robot_toml.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> unless_empty(const fs::path& path) {
  return path.empty() ? std::nullopt : std::optional{path};
}

}  // namespace

void declare_log(CLI::App& app, LogArguments& arguments) {
  app.add_option("LOG", arguments.log, "a log, or a folder of delimited texts (with --describe)")
      ->required()
      ->type_name("PATH");
  declare_log_files(app, arguments);
}

void declare_log_files(CLI::App& app, LogArguments& arguments) {
  app.add_option("--describe", arguments.description, "TOML that says what the columns of a delimited text mean")
      ->type_name("FILE");
  app.add_option("--odometry", arguments.odometry, "poses (t,x,y,yaw) beside a CSV of ranges (t,sensor_id,range_m)")
      ->type_name("FILE");
  app.add_option("--robot", arguments.robot, "robot.toml: replaces the robot the log describes; see `echoarc init`")
      ->type_name("FILE");
}

Result<Log> load_log(const LogArguments& arguments, io::ByteSink* copy_of_jsonl) {
  io::ReadOptions options{.description = unless_empty(arguments.description),
                          .robot = std::nullopt,
                          .odometry = unless_empty(arguments.odometry),
                          .limits = {},
                          .copy_of_jsonl = copy_of_jsonl};
  if (!arguments.robot.empty()) {
    Result<RobotDescription> robot = io::read_robot_toml(arguments.robot);
    if (!robot) return robot.error();
    options.robot = std::move(*robot);
  }
  return io::read_log(arguments.log, options);
}

void warn_of(const ReadReport& report) {
  for (const std::string& warning : report.warnings) warn(warning);
  if (report.bad_lines == 0) return;
  const BadLine& first = report.first_bad.front();
  warn(fmt::format("skipped {} that could not be read, the first one line {}: {}", counted(report.bad_lines, "line"),
                   first.line, first.message));
}

std::vector<fs::path> input_files(const LogArguments& arguments) {
  std::vector<fs::path> files;
  std::error_code ignored;
  if (fs::is_directory(arguments.log, ignored)) {
    for (const auto& entry : fs::directory_iterator(arguments.log, ignored))
      if (entry.is_regular_file(ignored)) files.push_back(entry.path());
    std::ranges::sort(files);
  } else {
    files.push_back(arguments.log);
  }
  for (const fs::path& path : {arguments.description, arguments.odometry, arguments.robot})
    if (!path.empty()) files.push_back(path);
  return files;
}

}  // namespace echoarc::cli
