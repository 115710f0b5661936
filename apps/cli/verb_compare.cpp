// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/log_input.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/scene_toml.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/studies/comparison_findings.hpp"
#include "host/interrupt.hpp"
#include "host/thread_pool.hpp"
#include "report/comparison_document.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  fs::path logs;
  fs::path description;
  std::vector<std::string> scenes{"all"};
  std::vector<std::string> methods{"all"};
  fs::path output = "comparison";
  int seeds = 3;
  std::size_t threads = host::hardware_threads();
  bool json = false;
};

Result<std::vector<std::string>> chosen_scenes(const std::vector<std::string>& names) {
  if (names == std::vector<std::string>{"none"}) return std::vector<std::string>{};
  std::vector<std::string> chosen;
  for (const io::BuiltinText& scene : io::builtin_scenes()) {
    const bool wanted = std::ranges::find(names, scene.name) != names.end();
    if (wanted || names == std::vector<std::string>{"all"}) chosen.emplace_back(scene.name);
  }
  for (const std::string& name : names)
    if (name != "all" && !io::builtin_scene(name))
      return Error{ErrorCode::bad_value, fmt::format("there is no scene {}", name), "--scenes",
                   "choose from those that `echoarc sim --help` lists, or all, or none"};
  return chosen;
}

/// All variants of the methods named.
Result<std::vector<studies::ComparedMethod>> chosen_methods(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (name != "all" && find_method(name) == nullptr)
      return Error{ErrorCode::bad_value, fmt::format("there is no method {}", name), "--methods",
                   "see `echoarc methods` for their names"};
  std::vector<studies::ComparedMethod> methods = studies::compared_methods();
  std::erase_if(methods, [&](const studies::ComparedMethod& method) {
    return std::ranges::none_of(names, [&](const std::string& name) { return name == "all" || name == method.method; });
  });
  return methods;
}

/// The logs of a folder, in the order of their names: folders of texts with a description, other files as they are.
Result<std::vector<studies::ComparedLog>> load_logs(const CompareArguments& arguments) {
  std::vector<studies::ComparedLog> logs;
  if (arguments.logs.empty()) return logs;
  std::error_code fault;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(arguments.logs, fault)) paths.push_back(entry.path());
  if (fault) {
    warn(fmt::format("the logs are absent ({}: {}): the comparison holds scenes alone", arguments.logs.string(),
                     fault.message()));
    return logs;
  }
  std::ranges::sort(paths);
  for (const fs::path& path : paths) {
    Result<Log> log = load_log({.log = path, .description = arguments.description, .odometry = {}, .robot = {}});
    if (!log) return log.error();
    warn_of(log->report);
    logs.push_back({path.stem().string(), std::move(*log)});
  }
  return logs;
}

Result<studies::StudyScene> carried_scene(std::string_view name) {
  Result<io::SceneFile> file = io::read_scene(io::builtin_scene(name).value_or(""), name);
  if (!file) return file.error();
  return studies::StudyScene{std::move(file->scene), file->scoring.value_or(SceneScoring{})};
}

std::string canonical_command(const CompareArguments& arguments) {
  std::string command = "echoarc compare";
  if (!arguments.logs.empty()) command += " --logs " + arguments.logs.string();
  if (!arguments.description.empty()) command += " --describe " + arguments.description.string();
  if (arguments.methods != std::vector<std::string>{"all"})
    command += fmt::format(" --methods {}", fmt::join(arguments.methods, ","));
  return command + fmt::format(" --scenes {} --seeds {}", fmt::join(arguments.scenes, ","), arguments.seeds);
}

Result<studies::Comparison> run_comparison(const CompareArguments& arguments,
                                           const studies::ComparisonRequest& request) {
  host::ThreadPool pool(arguments.threads);
  ProgressBar bar("comparing");
  const studies::StudyHost host{.executor = &pool,
                                .scene = &carried_scene,
                                .seeds = arguments.seeds,
                                .progress = [&](double fraction) { bar.show(fraction); },
                                .cancelled = &host::InterruptGuard::interrupted,
                                .thread_cpu_s = {}};
  return studies::compare_methods(host, request);
}

/// The folder first: a run of minutes must not end with a folder that cannot be written.
Result<void> make_folders(const fs::path& folder) {
  std::error_code fault;
  for (const char* part : {"pictures", "tables"}) {
    fs::create_directories(folder / part, fault);
    if (fault) return Error{ErrorCode::unwritable, fault.message(), folder.string(), "choose another folder with -o"};
  }
  return {};
}

Result<void> write_files(const fs::path& folder, const report::ComparisonDocument& document) {
  const Result<std::vector<report::ReportFile>> files = report::comparison_files(document);
  if (!files) return files.error();
  for (const report::ReportFile& file : *files) {
    const Result<std::unique_ptr<io::FileSink>> sink = io::FileSink::create(folder / file.path);
    if (!sink) return sink.error();
    if (Result<void> written = (*sink)->write(file.bytes); !written) return written;
    if (Result<void> committed = (*sink)->commit(); !committed) return committed;
  }
  return {};
}

std::string pair_of(const studies::MeanScores& scores) {
  const auto share = [](double value) { return std::isnan(value) ? "-" : fmt::format("{:.3f}", value); };
  return share(scores.accuracy[1]) + "/" + share(scores.coverage);
}

/// Whole logs and cut ones, of every method; scenes are too many for a terminal.
void print_summary(const report::ComparisonDocument& document, const fs::path& folder) {
  const studies::Comparison& comparison = document.comparison;
  std::vector<std::string> head{"method"};
  for (const studies::ComparedPlace& place : comparison.places)
    if (place.kind == studies::PlaceKind::log) head.push_back(place.name);
  if (head.size() == 1)
    for (std::size_t p = 0; p < std::min<std::size_t>(4, comparison.places.size()); ++p)
      head.push_back(comparison.places[p].name);
  Table table(head);
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
    std::vector<std::string> row{comparison.methods[m].label};
    for (const studies::ComparedPlace& place : comparison.places)
      if (std::ranges::find(head.begin() + 1, head.end(), place.name) != head.end())
        row.push_back(pair_of(mean_scores(place.maps[m], studies::one_per_cell)));
    table.add(row);
  }
  fmt::print("{}\nshare of points within 10 cm / coverage, one point per 5 cm cell\n\nThe comparison: {}\n",
             table.text(), (folder / "comparison.html").string());
}

Result<ExitStatus> compare(const CompareArguments& arguments, studies::ComparisonRequest request) {
  Result<std::vector<studies::ComparedLog>> logs = load_logs(arguments);
  if (!logs) return logs.error();
  request.logs = std::move(*logs);
  if (request.logs.empty() && request.scenes.empty())
    return Error{ErrorCode::bad_value, "there is neither a log nor a scene to compare on", "",
                 "give --logs DIR, or scenes with --scenes"};
  if (const Result<void> made = make_folders(arguments.output); !made) return made.error();
  const host::InterruptGuard guard;
  Result<studies::Comparison> comparison = run_comparison(arguments, request);
  if (!comparison) return comparison.error();
  const report::ComparisonDocument document{ECHOARC_VERSION, canonical_command(arguments), std::move(*comparison)};
  if (const Result<void> written = write_files(arguments.output, document); !written) return written.error();
  if (arguments.json)
    fmt::print("{}", report::comparison_json(document));
  else
    print_summary(document, arguments.output);
  return done;
}

ExitStatus run(const CompareArguments& arguments) {
  Result<std::vector<std::string>> scenes = chosen_scenes(arguments.scenes);
  if (!scenes) return misuse(scenes.error());
  Result<std::vector<studies::ComparedMethod>> methods = chosen_methods(arguments.methods);
  if (!methods) return misuse(methods.error());
  const Result<ExitStatus> status =
      compare(arguments, {.logs = {}, .scenes = std::move(*scenes), .methods = std::move(*methods)});
  return status ? *status : fail(status.error());
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  app.add_option("--logs", arguments->logs, "folder with recorded logs that have a laser, the reference")
      ->type_name("DIR");
  app.add_option("--describe", arguments->description, "TOML that says what the columns of logs of delimited text mean")
      ->type_name("FILE");
  app.add_option("--scenes", arguments->scenes, "scenes to simulate: names, all, or none")
      ->delimiter(',')
      ->type_name("A,B")
      ->capture_default_str();
  app.add_option("--methods", arguments->methods, "methods of the catalogue, each in all its settings; or all")
      ->delimiter(',')
      ->type_name("A,B")
      ->capture_default_str();
  app.add_option("--seeds", arguments->seeds,
                 "how often every scene is simulated; drives of more than half an hour once")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--threads", arguments->threads, "how many threads work; the figures do not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output,
                 "folder for comparison.html, comparison.json, pictures and tables; one that echoarc wrote is replaced")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--json", arguments->json, "print comparison.json, too");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb compare_verb() {
  return {"compare",
          "every method on every log and scene: scores, calibration, pictures",
          {{"echoarc compare --scenes rcd --methods consensus,centerline --seeds 1", "one scene, two methods: seconds"},
           {"echoarc compare -o comparison", "every method on every scene the program carries along: minutes"},
           {"echoarc compare --logs corridor --describe corridor.toml", "and on recorded logs, against their laser"}},
          &declare};
}

}  // namespace echoarc::cli
