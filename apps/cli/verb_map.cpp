// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include "cli/log_input.hpp"
#include "cli/map_output.hpp"
#include "cli/map_settings.hpp"
#include "cli/map_summary.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/output_directory.hpp"
#include "echoarc/sensing/diagnosis.hpp"
#include "host/clocks.hpp"
#include "host/interrupt.hpp"
#include "host/thread_pool.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

struct MapArguments {
  LogArguments input;
  SettingArguments settings{.takes_features = true};
  fs::path output;
  std::size_t threads = host::hardware_threads();
  std::uint64_t seed = 0;
};

/// "logs/run1.jsonl" and "logs/run1/" -> "run1-map"
fs::path default_output(const fs::path& log) {
  fs::path path = fs::absolute(log).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return (fs::is_directory(path) ? path.filename() : path.stem()).string() + "-map";
}

/// The command without what cannot change the result (threads, output folder), so that run.json is the same.
std::string canonical_command(const MapArguments& arguments, const MapSettings& settings) {
  std::string text = "echoarc map " + arguments.input.log.string();
  const auto add = [&](std::string_view flag, const std::string& value) {
    if (!value.empty()) text += fmt::format(" {} {}", flag, value);
  };
  add("--describe", arguments.input.description.string());
  add("--odometry", arguments.input.odometry.string());
  add("--robot", arguments.input.robot.string());
  add("--method", fmt::format("{}", fmt::join(settings.methods, ",")));
  add("--features", fmt::format("{}", fmt::join(settings.features, ",")));
  add("--config", arguments.settings.config.string());
  for (const std::string& setting : arguments.settings.settings) add("--set", setting);
  add("--seed", std::to_string(arguments.seed));
  return text;
}

/// Replacing a folder must not take the log away that is being read.
Result<void> check_apart(const fs::path& log, const fs::path& output) {
  const fs::path inside = fs::weakly_canonical(log).lexically_relative(fs::weakly_canonical(output));
  if (inside.empty() || *inside.begin() == "..") return {};
  return Error{ErrorCode::unwritable, "the log lies inside the output folder", output.string(),
               "choose another folder with -o"};
}

/// An error when nothing, or next to nothing, can be mapped: an empty map without a reason helps nobody.
Result<void> check_usable(const Log& log, const LogRun& run) {
  const bool hopeless = run.report.echoes == 0 && run.report.rejected_pings.total() > run.report.accepted();
  if (run.report.accepted() > 0 && !hopeless) return {};
  if (run.cancelled)
    return Error{ErrorCode::interrupted, "interrupted before the first ping was mapped", log.source, "run it again"};
  if (log.pings.empty() && log.polls.empty())
    return Error{ErrorCode::bad_format, "the log holds no pings", log.source,
                 "check with `echoarc info` what it does hold"};
  const auto worst = std::ranges::max_element(
      rejections(), {}, [&](const RejectionInfo& reason) { return run.report.rejected_pings[reason.reason].count; });
  const RejectionTally& tally = run.report.rejected_pings[worst->reason];
  return Error{
      ErrorCode::bad_value,
      fmt::format("{} of {} cannot be used and none is an echo; {} are {}: {}", run.report.rejected_pings.total(),
                  counted(run.report.pings, "ping"), tally.count, worst->name, worst->explanation),
      tally.first_line > 0 ? fmt::format("{}:{}", log.source, tally.first_line) : log.source,
      std::string(worst->remedy)};
}

LogRun run_methods(const Log& log, const SensingOptions& sensing, std::vector<AnyMethod>& methods,
                   FeatureExtraction& features, std::size_t threads) {
  host::ThreadPool pool(threads);
  ProgressBar bar("mapping");
  const PipelineHost callbacks{.progress = [&](double fraction) { bar.show(fraction); },
                               .cancelled = &host::InterruptGuard::interrupted,
                               .thread_cpu_s = &host::thread_cpu_time_s,
                               .readings = [&](std::span<const Reading> readings) { features.insert(readings); }};
  return run_log(log, sensing, methods, pool, callbacks);
}

Result<void> write_reports(const fs::path& folder, const MapArguments& arguments, const MapSettings& settings,
                           const SensingOptions& sensing, const MapRun& run,
                           const std::vector<io::MethodReport>& reports, double begin_s) {
  io::RunReport report{.version = ECHOARC_VERSION,
                       .command = canonical_command(arguments, settings),
                       .inputs = {},
                       .seed = arguments.seed,
                       .interrupted = run.result.cancelled,
                       .sensing = option_values(sensing),
                       .pings = {},
                       .rejected = {},
                       .notes = no_echo_sentences(run.result.report.no_echo),
                       .methods = reports};
  count_pings(run.result.report, report);
  for (const fs::path& file : input_files(arguments.input)) {
    const Result<io::InputFile> input = io::describe_input(file);
    if (!input) return input.error();
    report.inputs.push_back(*input);
  }
  if (Result<void> written = io::write_run_report(folder, report); !written) return written;
  io::Timings timings{.threads = arguments.threads, .seconds = {{"wall", host::wall_time_s() - begin_s}}};
  for (std::size_t k = 0; k < reports.size(); ++k) {
    timings.seconds.emplace_back(reports[k].name + ".insert_cpu", run.result.costs[k].insert_cpu_s);
    timings.seconds.emplace_back(reports[k].name + ".finish_cpu", run.result.costs[k].finish_cpu_s);
  }
  return io::write_timings(folder, timings);
}

/// Everything between the settings and the last line of the summary.
Result<ExitStatus> map_log(const MapArguments& arguments, const MapSettings& settings) {
  const double begin_s = host::wall_time_s();
  const Result<SensingOptions> sensing = make_options<SensingOptions>(settings.sensing);
  if (!sensing) return sensing.error();
  Result<std::vector<AnyMethod>> methods = make_methods(settings);
  if (!methods) return methods.error();
  Result<FeatureExtraction> features = FeatureExtraction::make(settings.features, settings.options);
  if (!features) return features.error();
  const fs::path output = arguments.output.empty() ? default_output(arguments.input.log) : arguments.output;
  if (const Result<void> apart = check_apart(arguments.input.log, output); !apart) return apart.error();
  const Result<Log> log = load_log(arguments.input);
  if (!log) return log.error();
  warn_of(log->report);
  // Until here nothing is written and Ctrl-C simply ends the process; from here on it ends the mapping.
  const host::InterruptGuard guard;
  Result<io::OutputDirectory> folder = io::OutputDirectory::create(output);
  if (!folder) return folder.error();
  LogRun result = run_methods(*log, *sensing, *methods, *features, arguments.threads);
  MapRun run{*log, std::move(result), std::move(*methods), std::move(*features)};
  print_pings(*log, run.result.report);
  if (const Result<void> usable = check_usable(*log, run.result); !usable) return usable.error();
  const Result<std::vector<io::MethodReport>> reports = write_maps(folder->path(), run);
  if (!reports) return reports.error();
  const Result<void> written = write_reports(folder->path(), arguments, settings, *sensing, run, *reports, begin_s);
  if (!written) return written.error();
  if (const Result<void> committed = folder->commit(); !committed) return committed.error();
  print_maps(run, *reports, output);
  if (!run.result.cancelled) return done;
  warn(fmt::format("interrupted: the maps hold the first {} of {}", run.result.report.pings,
                   counted(log->pings.size(), "ping")));
  return interrupted;
}

ExitStatus run(const MapArguments& arguments) {
  const auto settings = resolve_settings(arguments.settings);
  if (const auto* fault = std::get_if<SettingFault>(&settings))
    return fault->command_line ? misuse(fault->error) : fail(fault->error);
  const Result<ExitStatus> status = map_log(arguments, std::get<MapSettings>(settings));
  return status ? *status : fail(status.error());
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<MapArguments>();
  declare_log(app, arguments->input);
  declare_settings(app, arguments->settings);
  app.add_option("--features", arguments->settings.features,
                 "features to extract: tangents, regions, lines, or all; into DIR/features and the pictures")
      ->delimiter(',')
      ->type_name("A,B");
  app.add_option("--threads", arguments->threads, "how many threads work; the maps do not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--seed", arguments->seed, "for methods that draw random numbers; kept in run.json")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output,
                 "folder to write, default ./LOGNAME-map; one that echoarc wrote is replaced")
      ->type_name("DIR");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb map_verb() {
  return {"map",
          "maps of a log",
          {{"echoarc map room.jsonl", "tangent consensus and evidence grid, with pictures, in ./room-map"},
           {"echoarc map room.jsonl --method all -o maps", "every method, into a folder of your choice"},
           {"echoarc map room.jsonl --method carve --features all", "walls and edges as GeoJSON, too"},
           {"echoarc map run1 --describe corridor.toml", "a folder of delimited texts"},
           {"echoarc map ranges.csv --odometry poses.csv --robot robot.toml", "two plain tables"},
           {"echoarc map room.jsonl --method evidence --set evidence.cell_m=0.02",
            "with an option; see `echoarc methods`"}},
          &declare};
}

}  // namespace echoarc::cli
