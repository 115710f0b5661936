// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/scene_input.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/jsonl.hpp"
#include "echoarc/io/simulation_picture.hpp"
#include "echoarc/sim/simulate.hpp"
#include "host/interrupt.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct SimArguments {
  std::string scene;
  fs::path output;   ///< empty: the scene's name
  fs::path picture;  ///< empty: beside the log
  std::vector<std::string> settings;
  std::uint64_t seed = 1;
  bool force = false;
  bool json = false;
};

/// Where the results go.
struct SimFiles {
  fs::path log;
  fs::path picture;
};

SimFiles files_of(const SimArguments& arguments) {
  SimFiles files{arguments.output, arguments.picture};
  if (files.log.empty()) files.log = fs::path(arguments.scene).stem().string() + ".jsonl";
  if (files.picture.empty()) files.picture = fs::path(files.log).replace_extension(".png");
  return files;
}

Result<void> check_free(const SimFiles& files, bool force) {
  if (files.log == files.picture)
    return Error{ErrorCode::bad_value, "log and picture have the same name", files.log.string(),
                 "give the log another name, such as room.jsonl"};
  for (const fs::path& file : {files.log, files.picture})
    if (!force && fs::exists(file))
      return Error{ErrorCode::unwritable, "the file exists already", file.string(),
                   "give another name (-o LOG), or replace it with --force"};
  return {};
}

Result<sim::Simulation> run_scene(const sim::Scene& scene, std::uint64_t seed) {
  const host::InterruptGuard guard;
  ProgressBar bar("simulating");
  return sim::simulate(
      scene, seed,
      {.progress = [&](double fraction) { bar.show(fraction); }, .cancelled = &host::InterruptGuard::interrupted});
}

Result<void> write_results(const SimFiles& files, const sim::Scene& scene, const sim::Simulation& simulation) {
  const Result<std::unique_ptr<io::FileSink>> file = io::FileSink::create(files.log);
  if (!file) return file.error();
  if (const Result<void> written = io::write_jsonl(simulation.log, **file); !written) return written;
  if (const Result<void> committed = (*file)->commit(); !committed) return committed;
  return io::write_simulation_picture(files.picture, scene, simulation);
}

double share(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

void print_summary(const sim::Scene& scene, const sim::Simulation& simulation) {
  const sim::SimulationReport& report = simulation.report;
  fmt::print("{}\n", scene.title.empty() ? scene.name : scene.title);
  fmt::print("  robot     {}, {}, {}\n", scene.robot.name, counted(scene.robot.sensors.size(), "sonar"),
             counted(scene.lasers.size(), "laser"));
  fmt::print("  drive     {:.2f} m in {:.1f} s\n", report.path_m, report.duration_s);
  fmt::print("  records   {}, {}, {}, {}\n", counted(simulation.log.truth.size(), "true pose"),
             counted(simulation.log.pings.size(), "ping"), counted(simulation.log.polls.size(), "poll"),
             counted(simulation.log.scans.size(), "laser scan"));
  fmt::print("  firings   {}, heard by {}: {} silent ({:.1f} %)\n", report.firings, counted(report.windows, "window"),
             report.silent_windows, 100.0 * share(report.silent_windows, report.windows));
  const std::uint64_t echoes = report.windows - report.silent_windows;
  Table table({"cause", "echoes", "share"});
  for (std::size_t k = 0; k < report.echoes.size(); ++k)
    if (report.echoes[k] > 0)
      table.add({std::string(echo_cause_names[k]), std::to_string(report.echoes[k]),
                 fmt::format("{:.1f} %", 100.0 * share(report.echoes[k], echoes))});
  if (!table.empty()) fmt::print("\n{}", table.text());
}

void print_json(const SimArguments& arguments, const SimFiles& files, const sim::Simulation& simulation) {
  const sim::SimulationReport& report = simulation.report;
  Json echoes = Json::object();
  for (std::size_t k = 1; k < report.echoes.size(); ++k) echoes[std::string(echo_cause_names[k])] = report.echoes[k];
  const Json json{{"scene", arguments.scene},
                  {"seed", arguments.seed},
                  {"log", files.log.string()},
                  {"picture", files.picture.string()},
                  {"path_m", report.path_m},
                  {"duration_s", report.duration_s},
                  {"firings", report.firings},
                  {"windows", report.windows},
                  {"silent_windows", report.silent_windows},
                  {"silent_share", share(report.silent_windows, report.windows)},
                  {"echoes", std::move(echoes)},
                  {"truncated_pings", report.truncated_pings},
                  {"poses", simulation.log.truth.size()},
                  {"pings", simulation.log.pings.size()},
                  {"polls", simulation.log.polls.size()},
                  {"scans", simulation.log.scans.size()}};
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

ExitStatus run(const SimArguments& arguments) {
  Result<io::SceneFile> file = load_scene(arguments.scene);
  if (!file) return fail(file.error());
  sim::Scene& scene = file->scene;
  if (const Result<void> applied = apply_scene_settings(scene, arguments.settings); !applied)
    return misuse(applied.error());
  const SimFiles files = files_of(arguments);
  if (const Result<void> free = check_free(files, arguments.force); !free) return fail(free.error());
  const Result<sim::Simulation> simulation = run_scene(scene, arguments.seed);
  if (!simulation) return fail(simulation.error());
  if (const Result<void> written = write_results(files, scene, *simulation); !written) return fail(written.error());
  if (simulation->report.truncated_pings > 0)
    warn(fmt::format("{} had more reflections than are followed; some of their echoes are missing",
                     counted(simulation->report.truncated_pings, "ping")));
  if (arguments.json) {
    print_json(arguments, files, *simulation);
    return done;
  }
  print_summary(scene, *simulation);
  fmt::print("\nwrote {} and {}\n", files.log.string(), files.picture.string());
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<SimArguments>();
  app.add_option("SCENE", arguments->scene, "a scene.toml, or the name of a scene that comes with echoarc")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "log to write, JSON Lines; default ./SCENE.jsonl")->type_name("LOG");
  app.add_option("--seed", arguments->seed, "of all that is random: the same seed gives the same log")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--set", arguments->settings,
                 "TABLE.OPTION=VALUE over the scene's own; tables: sonar, drive, odometry, polling, laser; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  app.add_option("--picture", arguments->picture,
                 "picture of world, path and echoes by their cause; default: the log's name with .png")
      ->type_name("FILE.png");
  app.add_flag("--force", arguments->force, "replace files that exist");
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb sim_verb() {
  return {
      "sim",
      "a log of a simulated drive, with the truth",
      {{"echoarc sim demo -o drive.jsonl", "a room that comes with echoarc; drive.png shows what was heard and why"},
       {"echoarc sim curve -o curve.jsonl --seed 7", "other noise"},
       {"echoarc sim demo -o calm.jsonl --set sonar.outlier_share=0 --set odometry.perfect=false",
        "with other options"},
       {"echoarc sim demo -o drive.jsonl --json", "for programs"}},
      &declare};
}

}  // namespace echoarc::cli
