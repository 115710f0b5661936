// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/sweep_output.hpp"
#include "cli/sweep_subject.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/output_directory.hpp"
#include "host/clocks.hpp"
#include "host/interrupt.hpp"
#include "host/thread_pool.hpp"

namespace echoarc::cli {
namespace {

struct SweepArguments {
  SubjectArguments subject;
  std::vector<std::string> methods;
  std::vector<std::string> options;
  std::vector<std::string> settings;
  int seeds = 3;
  std::size_t threads = host::hardware_threads();
  std::filesystem::path output;
  bool json = false;
};

/// --option as they stand, then --set, which have one value each.
Result<std::vector<studies::SweepAxis>> axes_of(const SweepArguments& arguments) {
  const bool has_scene = names_scene(arguments.subject);
  std::vector<studies::SweepAxis> axes;
  for (const auto* texts : {&arguments.options, &arguments.settings})
    for (const std::string& text : *texts) {
      Result<studies::SweepAxis> axis = studies::parse_axis(text, arguments.methods, has_scene);
      if (!axis) return axis.error();
      if (texts == &arguments.settings && axis->values.size() != 1)
        return Error{ErrorCode::bad_value, text + " has several values", "--set", "vary it with --option"};
      axes.push_back(std::move(*axis));
    }
  return axes;
}

std::string canonical_command(const SweepArguments& arguments) {
  std::string text = fmt::format("echoarc sweep {} --method {}", arguments.subject.log.log.string(),
                                 fmt::join(arguments.methods, ","));
  for (const std::string& option : arguments.options) text += " --option " + option;
  for (const std::string& setting : arguments.settings) text += " --set " + setting;
  if (!arguments.subject.reference.empty()) text += " --reference " + arguments.subject.reference;
  if (names_scene(arguments.subject)) text += fmt::format(" --seeds {}", arguments.seeds);
  return text;
}

Result<studies::SweepResult> measure(const SweepArguments& arguments, const studies::SweepRequest& request) {
  host::ThreadPool pool(arguments.threads);
  ProgressBar bar("sweep");
  studies::StudyHost host;
  host.executor = &pool;
  host.seeds = arguments.seeds;
  host.progress = [&](double fraction) { bar.show(fraction); };
  host.cancelled = &host::InterruptGuard::interrupted;
  host.thread_cpu_s = &host::thread_cpu_time_s;
  return studies::run_sweep(request, host);
}

Result<ExitStatus> sweep(const SweepArguments& arguments, std::vector<studies::SweepAxis> axes) {
  Result<studies::SweepSubject> subject = load_subject(arguments.subject);
  if (!subject) return subject.error();
  const host::InterruptGuard guard;
  std::optional<io::OutputDirectory> folder;
  if (!arguments.output.empty()) {
    Result<io::OutputDirectory> made = io::OutputDirectory::create(arguments.output);
    if (!made) return made.error();
    folder.emplace(std::move(*made));
  }
  Result<studies::SweepResult> result =
      measure(arguments, {.subject = std::move(*subject), .methods = arguments.methods, .axes = std::move(axes)});
  if (!result) return result.error();
  const SweepReport report{.subject = arguments.subject.log.log.string(),
                           .command = canonical_command(arguments),
                           .result = std::move(*result)};
  if (folder) {
    if (const Result<void> written = write_sweep(folder->path(), report); !written) return written.error();
    if (const Result<void> committed = folder->commit(); !committed) return committed.error();
  }
  fmt::print("{}", arguments.json ? sweep_json(report) : sweep_table(report));
  if (folder && !arguments.json)
    fmt::print("\nsweep.csv, runs.csv, run.json and charts (.svg) are in {}\n", arguments.output.string());
  return done;
}

/// Errors about the command line itself name its option.
bool is_misuse(const Error& error) {
  return error.where.starts_with("--");
}

ExitStatus run(const SweepArguments& arguments) {
  Result<std::vector<studies::SweepAxis>> axes = axes_of(arguments);
  if (!axes) return misuse(axes.error());
  const Result<ExitStatus> status = sweep(arguments, std::move(*axes));
  if (status) return *status;
  return is_misuse(status.error()) ? misuse(status.error()) : fail(status.error());
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<SweepArguments>();
  declare_subject(app, arguments->subject);
  app.add_option("--method", arguments->methods, "methods to compare; see `echoarc methods`")
      ->required()
      ->delimiter(',')
      ->type_name("A,B");
  app.add_option("--option", arguments->options,
                 "FROM:TO:STEP or v1,v2 of OPTION, METHOD.OPTION, sensing.OPTION, or of a scene's tables as "
                 "sonar.OPTION; repeatable: every combination is tried")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUES");
  app.add_option("--set", arguments->settings, "the same keys with one value, for all rows; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  app.add_option("--seeds", arguments->seeds, "how often a scene is simulated; a log is what it is")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--threads", arguments->threads, "how many threads work; the scores do not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output, "folder for CSV, JSON and charts; without it nothing is written")
      ->type_name("DIR");
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb sweep_verb() {
  return {"sweep",
          "scores over a range of any option",
          {{"echoarc sweep corner-90 --method vt,dm --option threshold=5:25:10 --seeds 1", "thresholds in a scene"},
           {"echoarc sweep corner-90 --method carve --option sonar.range_noise_share=0,0.01 --seeds 2 -o noise",
            "of the simulated sonars; with CSV and charts in ./noise"},
           {"echoarc sweep room.jsonl --reference room-truth.csv --method vt --option threshold=1:5:1", "on a log"},
           {"echoarc sweep room.jsonl --reference room-truth.csv --method carve --option history=50,250 --json",
            "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
