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

#include "cli/localisation_output.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/scene_input.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/output_directory.hpp"
#include "echoarc/io/robot_toml.hpp"
#include "echoarc/studies/localisation.hpp"
#include "host/clocks.hpp"
#include "host/interrupt.hpp"
#include "host/thread_pool.hpp"

namespace echoarc::cli {
namespace {

struct LocaliseArguments {
  std::string scene;
  bool global = false;
  bool kidnap = false;
  std::string map = "surfaces";
  std::string robot;
  std::vector<std::string> settings;
  std::optional<double> speed_m_s;
  bool drive_on = false;
  bool scatter = false;
  int laps = 1;
  double cell_m = 0.05;
  double limit_s = 600.0;
  int seeds = 1;
  std::uint64_t first_seed = 1;
  std::size_t threads = host::hardware_threads();
  std::filesystem::path output;
  bool json = false;
};

std::string canonical_command(const LocaliseArguments& arguments) {
  std::string text = fmt::format("echoarc localise {}", arguments.scene);
  if (arguments.global) text += " --global";
  if (arguments.kidnap) text += " --kidnap";
  text += fmt::format(" --map {}", arguments.map);
  if (!arguments.robot.empty()) text += " --robot " + arguments.robot;
  for (const std::string& setting : arguments.settings) text += " --set " + setting;
  if (arguments.speed_m_s) text += fmt::format(" --speed {}", *arguments.speed_m_s);
  if (arguments.drive_on) text += " --drive-on";
  if (arguments.scatter) text += " --scatter";
  return text + fmt::format(" --laps {} --cell {} --limit {} --seeds {} --first-seed {}", arguments.laps,
                            arguments.cell_m, arguments.limit_s, arguments.seeds, arguments.first_seed);
}

/// The scene with the robot and the settings of the command line. Its odometry drifts unless they say otherwise.
Result<sim::Scene> scene_of(const LocaliseArguments& arguments) {
  Result<io::SceneFile> file = load_scene(arguments.scene);
  if (!file) return file.error();
  sim::Scene scene = std::move(file->scene);
  if (!arguments.robot.empty()) {
    Result<RobotDescription> robot = load_robot(arguments.robot);
    if (!robot) return robot.error();
    scene.robot = std::move(*robot);
  }
  scene.odometry.perfect = false;
  if (const Result<void> applied = apply_scene_settings(scene, arguments.settings); !applied) return applied.error();
  if (arguments.speed_m_s) scene.drive.speed_m_s = *arguments.speed_m_s;
  if (arguments.drive_on) {
    scene.drive.stop_step_m = 0.0;
    scene.drive.stop_turn = {};
  }
  return scene;
}

studies::LocalisationRequest request_of(const LocaliseArguments& arguments, sim::Scene scene) {
  studies::LocalisationRequest request;
  request.scene = std::move(scene);
  if (arguments.global) request.start = studies::KnownStart::nothing;
  if (arguments.kidnap) request.start = studies::KnownStart::misled;
  if (arguments.map == "evidence") request.map = studies::LocalisationMap::evidence;
  request.cell_m = arguments.cell_m;
  request.limit_s = arguments.limit_s;
  request.laps = arguments.laps;
  request.scatter = arguments.scatter;
  return request;
}

Result<std::vector<studies::LocalisationRun>> run_seeds(const studies::LocalisationRequest& request,
                                                        const LocaliseArguments& arguments) {
  host::ThreadPool pool(arguments.threads);
  ProgressBar bar("localising");
  studies::StudyHost host;
  host.executor = &pool;
  host.seeds = arguments.seeds;
  host.progress = [&](double fraction) { bar.show(fraction); };
  host.cancelled = &host::InterruptGuard::interrupted;
  host.thread_cpu_s = &host::thread_cpu_time_s;
  return studies::localise_seeds(request, host, arguments.first_seed);
}

Result<ExitStatus> localise(const LocaliseArguments& arguments, const studies::LocalisationRequest& request) {
  const host::InterruptGuard guard;
  std::optional<io::OutputDirectory> folder;
  if (!arguments.output.empty()) {
    Result<io::OutputDirectory> made = io::OutputDirectory::create(arguments.output);
    if (!made) return made.error();
    folder.emplace(std::move(*made));
  }
  const Result<std::vector<studies::LocalisationRun>> runs = run_seeds(request, arguments);
  if (!runs) return runs.error();
  const LocalisationReport report{canonical_command(arguments), &request, *runs};
  if (folder) {
    if (const Result<void> written = write_localisation(folder->path(), report); !written) return written.error();
    if (const Result<void> committed = folder->commit(); !committed) return committed.error();
  }
  fmt::print("{}", arguments.json ? localisation_json(report) : localisation_table(report));
  if (folder && !arguments.json) fmt::print("\nwrote {}\n", arguments.output.string());
  return done;
}

ExitStatus run(const LocaliseArguments& arguments) {
  Result<sim::Scene> scene = scene_of(arguments);
  if (!scene) return fail(scene.error());
  const Result<ExitStatus> status = localise(arguments, request_of(arguments, std::move(*scene)));
  return status ? *status : fail(status.error());
}

void declare_way(CLI::App& app, LocaliseArguments& arguments) {
  app.add_option("--robot", arguments.robot,
                 "a robot.toml, or the name of a robot that comes with echoarc, in place of the scene's")
      ->type_name("ROBOT");
  app.add_option("--set", arguments.settings,
                 "TABLE.OPTION=VALUE over the scene's own, as for `echoarc sim`; odometry drifts unless "
                 "odometry.perfect=true; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  app.add_option("--speed", arguments.speed_m_s, "of the drive; default: the scene's")
      ->check(CLI::Range(0.01, 2.0).description(""))
      ->type_name("M/S");
  app.add_flag("--drive-on", arguments.drive_on, "do not halt for readings where the scene's drive does");
  app.add_option("--laps", arguments.laps, "drive the way so many times; for one that ends where it begins")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--scatter", arguments.scatter, "let every seed begin at a leg of the drive of its own");
  app.add_option("--limit", arguments.limit_s, "simulated time after which a run ends, if the drive does not before")
      ->check(CLI::Range(1.0, 1e6).description(""))
      ->type_name("S")
      ->capture_default_str();
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<LocaliseArguments>();
  app.add_option("SCENE", arguments->scene, "a scene.toml, or the name of a scene that comes with echoarc")
      ->required()
      ->type_name("");
  CLI::Option* global = app.add_flag("--global", arguments->global, "tell the robot nothing of where it stands");
  app.add_flag("--kidnap", arguments->kidnap,
               "after 60 s carry it to where it would have been 30 s later, and do not tell it")
      ->excludes(global);
  app.add_option("--map", arguments->map,
                 "surfaces: the world as it is; evidence: a grid of an earlier drive, with perfect odometry")
      ->check(CLI::IsMember({"surfaces", "evidence"}).description(""))
      ->type_name("MAP")
      ->capture_default_str();
  app.add_option("--cell", arguments->cell_m, "of the map")
      ->check(CLI::Range(0.01, 1.0).description(""))
      ->type_name("M")
      ->capture_default_str();
  declare_way(app, *arguments);
  app.add_option("--seeds", arguments->seeds, "runs; the same seed gives the same run")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--first-seed", arguments->first_seed, "seed of the first run; the others follow")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--threads", arguments->threads, "how many runs go on at once; the results do not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output, "folder for CSV and JSON; without it nothing is written")
      ->type_name("DIR");
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb localise_verb() {
  return {
      "localise",
      "a robot finds out where it is on a known map, by its sonars",
      {{"echoarc localise room-a --robot nomad200 --set sonar.listening=own --drive-on --limit 60",
        "keeps the pose it was told while its odometry drifts"},
       {"echoarc localise room-a --robot nomad200 --set sonar.listening=own --drive-on --global --limit 60 -o found",
        "finds it from nothing"},
       {"echoarc localise demo --global --map evidence --limit 60 --json", "on a map of its own, for programs"}},
      &declare};
}

}  // namespace echoarc::cli
