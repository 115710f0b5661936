// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <memory>
#include <string_view>

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

/// Passes bytes on and remembers whether there were any.
class NotingSink final : public io::ByteSink {
 public:
  explicit NotingSink(io::ByteSink& sink) : sink_(sink) {}
  [[nodiscard]] Result<void> write(std::string_view bytes) override {
    used_ = true;
    return sink_.write(bytes);
  }
  [[nodiscard]] bool used() const { return used_; }

 private:
  io::ByteSink& sink_;
  bool used_ = false;
};

/// The log, written to `path`. What is JSON Lines already is copied line by line, so that keys and record types unknown
/// to this version survive; unless another robot is to go into its header.
Result<Log> convert(const LogArguments& input, const std::filesystem::path& path) {
  Result<std::unique_ptr<io::FileSink>> file = io::FileSink::create(path);
  if (!file) return file.error();
  NotingSink copy(**file);
  Result<Log> log = load_log(input, input.robot.empty() ? &copy : nullptr);
  if (!log) return log;
  if (!copy.used())
    if (const Result<void> written = io::write_jsonl(*log, **file); !written) return written.error();
  if (const Result<void> committed = (*file)->commit(); !committed) return committed.error();
  return log;
}

ExitStatus run(const ConvertArguments& arguments) {
  if (!arguments.force && std::filesystem::exists(arguments.output))
    return fail({ErrorCode::unwritable, "the file exists already", arguments.output.string(),
                 "give another name, or replace it with --force"});
  const Result<Log> log = convert(arguments.input, arguments.output);
  if (!log) return fail(log.error());
  warn_of(log->report);
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
