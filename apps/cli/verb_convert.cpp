// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <memory>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "cli/log_input.hpp"
#include "cli/report.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/jsonl.hpp"

namespace echoarc::cli {
namespace {

struct ConvertArguments {
  LogArguments input;
  std::filesystem::path output;
  bool force = false;
};

Result<void> write_log(const Log& log, const std::filesystem::path& path) {
  Result<std::unique_ptr<io::FileSink>> sink = io::FileSink::create(path);
  if (!sink) return sink.error();
  if (Result<void> written = io::write_jsonl(log, **sink); !written) return written;
  return (*sink)->commit();
}

ExitStatus run(const ConvertArguments& arguments) {
  if (!arguments.force && std::filesystem::exists(arguments.output))
    return fail({ErrorCode::unwritable, "the file exists already", arguments.output.string(),
                 "give another name, or replace it with --force"});
  const Result<Log> log = load_log(arguments.input);
  if (!log) return fail(log.error());
  warn_of(log->report);
  if (const Result<void> written = write_log(*log, arguments.output); !written) return fail(written.error());
  fmt::print("wrote {}: {}, {}, {}", arguments.output.string(), counted(log->odometry.size(), "pose"),
             counted(log->pings.size(), "ping"), counted(log->scans.size(), "laser scan"));
  if (!log->unknown_lines.empty())
    fmt::print(", {} kept as found", counted(log->unknown_lines.size(), "unknown record"));
  fmt::print("\n");
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<ConvertArguments>();
  declare_log(app, arguments->input);
  app.add_option("OUT", arguments->output, "the JSON Lines log to write")->required()->type_name("FILE");
  app.add_flag("--force", arguments->force, "replace OUT if it exists");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb convert_verb() {
  return {"convert",
          "a log of any known format as JSON Lines",
          {{"echoarc convert drive.clf drive.jsonl", "CARMEN"},
           {"echoarc convert run1 run1.jsonl --describe corridor.toml", "a folder of delimited texts"},
           {"echoarc convert ranges.csv ranges.jsonl --odometry poses.csv --robot robot.toml", "plain CSV"}},
          &declare};
}

}  // namespace echoarc::cli
