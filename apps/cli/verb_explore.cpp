// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/exploration_output.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/scene_input.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/output_directory.hpp"
#include "echoarc/io/robot_toml.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/nav/strategies.hpp"
#include "echoarc/studies/exploration.hpp"
#include "host/clocks.hpp"
#include "host/interrupt.hpp"
#include "host/thread_pool.hpp"

namespace echoarc::cli {
namespace {

struct ExploreArguments {
  std::string scene;
  std::string strategy;
  std::string method = "combined";
  std::string map = "evidence";
  std::string robot;
  std::vector<std::string> settings;
  double cell_m = 0.10;
  std::optional<double> speed_m_s;
  double limit_s = 3600.0;
  int seeds = 1;
  std::size_t threads = host::hardware_threads();
  std::filesystem::path output;
  bool logs = false;
  bool json = false;
};

live::PlanningMap planning_map(const std::string& name) {
  if (name == "limited") return live::PlanningMap::limited;
  return name == "points" ? live::PlanningMap::points : live::PlanningMap::evidence;
}

std::string canonical_command(const ExploreArguments& arguments) {
  std::string text = fmt::format("echoarc explore {} --strategy {} --method {} --map {}", arguments.scene,
                                 arguments.strategy, arguments.method, arguments.map);
  if (!arguments.robot.empty()) text += " --robot " + arguments.robot;
  for (const std::string& setting : arguments.settings) text += " --set " + setting;
  if (arguments.speed_m_s) text += fmt::format(" --speed {}", *arguments.speed_m_s);
  return text + fmt::format(" --cell {} --limit {} --seeds {}", arguments.cell_m, arguments.limit_s, arguments.seeds);
}

/// The scene with the robot and the settings of the command line.
Result<io::SceneFile> scene_of(const ExploreArguments& arguments) {
  Result<io::SceneFile> file = load_scene(arguments.scene);
  if (!file) return file;
  if (!arguments.robot.empty()) {
    Result<RobotDescription> robot = load_robot(arguments.robot);
    if (!robot) return robot.error();
    file->scene.robot = std::move(*robot);
  }
  if (const Result<void> applied = apply_scene_settings(file->scene, arguments.settings); !applied)
    return applied.error();
  return file;
}

Result<studies::ExplorationRequest> request_of(const ExploreArguments& arguments, io::SceneFile file) {
  const nav::StrategySettings settings{.body = {.radius_m = file.scene.robot.radius_m, .limits = {}},
                                       .cruise_m_s = arguments.speed_m_s.value_or(file.scene.drive.speed_m_s),
                                       .goals = file.goals};
  const Result<std::unique_ptr<nav::Strategy>> tried = nav::make_strategy(arguments.strategy, settings);
  if (!tried) return tried.error();
  studies::ExplorationRequest request;
  request.scene = std::move(file.scene);
  request.strategy = arguments.strategy;
  request.scoring = std::move(file.scoring);
  request.goals = std::move(file.goals);
  request.make_strategy = [name = arguments.strategy, settings] { return nav::make_strategy(name, settings).value(); };
  request.maps = {.method = arguments.method, .map = planning_map(arguments.map), .cell_m = arguments.cell_m};
  request.limit_s = arguments.limit_s;
  request.keep_log = true;
  return request;
}

Result<std::vector<studies::ExplorationRun>> run_seeds(const studies::ExplorationRequest& request,
                                                       const ExploreArguments& arguments) {
  host::ThreadPool pool(arguments.threads);
  ProgressBar bar("exploring");
  studies::StudyHost host;
  host.executor = &pool;
  host.seeds = arguments.seeds;
  host.progress = [&](double fraction) { bar.show(fraction); };
  host.cancelled = &host::InterruptGuard::interrupted;
  host.thread_cpu_s = &host::thread_cpu_time_s;
  return studies::explore_seeds(request, host);
}

Result<ExitStatus> explore(const ExploreArguments& arguments, const studies::ExplorationRequest& request) {
  const host::InterruptGuard guard;
  std::optional<io::OutputDirectory> folder;
  if (!arguments.output.empty()) {
    Result<io::OutputDirectory> made = io::OutputDirectory::create(arguments.output);
    if (!made) return made.error();
    folder.emplace(std::move(*made));
  }
  const Result<std::vector<studies::ExplorationRun>> runs = run_seeds(request, arguments);
  if (!runs) return runs.error();
  const ExplorationReport report{canonical_command(arguments), &request, *runs};
  if (folder) {
    if (const Result<void> written = write_exploration(folder->path(), report, arguments.logs); !written)
      return written.error();
    if (const Result<void> committed = folder->commit(); !committed) return committed.error();
  }
  fmt::print("{}", arguments.json ? exploration_json(report) : exploration_table(report));
  if (folder && !arguments.json) fmt::print("\nwrote {}\n", arguments.output.string());
  return done;
}

ExitStatus run(ExploreArguments& arguments) {
  if (arguments.strategy == "wall") arguments.strategy = "wall-left";
  Result<io::SceneFile> file = scene_of(arguments);
  if (!file) return fail(file.error());
  const Result<studies::ExplorationRequest> request = request_of(arguments, std::move(*file));
  if (!request) return misuse(request.error());
  if (find_method(arguments.method) == nullptr) return misuse(make_method(arguments.method).error());
  const Result<ExitStatus> status = explore(arguments, *request);
  return status ? *status : fail(status.error());
}

std::string strategy_help() {
  std::string text;
  for (const nav::StrategyEntry& entry : nav::strategies())
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", entry.name, entry.summary);
  return text + "; wall: as wall-left";
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<ExploreArguments>();
  app.add_option("SCENE", arguments->scene, "a scene.toml, or the name of a scene that comes with echoarc")
      ->required()
      ->type_name("");
  app.add_option("--strategy", arguments->strategy, strategy_help())->required()->type_name("S");
  app.add_option("--method", arguments->method,
                 "whose points are the obstacles around the robot; see `echoarc methods`")
      ->type_name("M")
      ->capture_default_str();
  app.add_option(
         "--map", arguments->map,
         "what plans are made on: evidence, a grid; limited, the same of laser-limited readings; points, those of "
         "the method")
      ->check(CLI::IsMember({"evidence", "limited", "points"}).description(""))
      ->type_name("MAP")
      ->capture_default_str();
  app.add_option("--robot", arguments->robot,
                 "a robot.toml, or the name of a robot that comes with echoarc, in place of the scene's")
      ->type_name("ROBOT");
  app.add_option(
         "--set", arguments->settings,
         "TABLE.OPTION=VALUE over the scene's own, as for `echoarc sim`: odometry.perfect=false drifts; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  app.add_option("--speed", arguments->speed_m_s, "cruising speed; default: that of the scene's drive")
      ->check(CLI::Range(0.01, 2.0).description(""))
      ->type_name("M/S");
  app.add_option("--cell", arguments->cell_m, "of the map that plans are made on")
      ->check(CLI::Range(0.01, 1.0).description(""))
      ->type_name("M")
      ->capture_default_str();
  app.add_option("--limit", arguments->limit_s, "simulated time after which a run is stopped")
      ->check(CLI::Range(1.0, 1e6).description(""))
      ->type_name("S")
      ->capture_default_str();
  app.add_option("--seeds", arguments->seeds, "runs, seeds 1, 2, ...; the same seed gives the same run")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--threads", arguments->threads, "how many runs go on at once; the results do not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output,
                 "folder for CSV, JSON, pictures and graphs; without it nothing is written")
      ->type_name("DIR");
  app.add_flag("--logs", arguments->logs, "write every run's log, too");
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb explore_verb() {
  return {"explore",
          "a robot explores a scene by itself, headless",
          {{"echoarc explore t-world --strategy gvg -o explored", "along the generalised Voronoi graph"},
           {"echoarc explore demo --strategy wall-left", "once round along the wall on its left"},
           {"echoarc explore hallway --strategy manual-script --map points --method centerline --seeds 3",
            "to the scene's goals, on the map of another method"},
           {"echoarc explore demo --strategy frontier --json", "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
