// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/exploration_output.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/text_file.hpp"
#include "echoarc/eval/statistics.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/exploration_picture.hpp"
#include "echoarc/io/jsonl.hpp"
#include "echoarc/io/run_report.hpp"
#include "echoarc/nav/voronoi_text.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;
using studies::ExplorationRun;

/// A goal counts as reached when the robot's centre came as near as this.
constexpr double reached_m = 0.3;

std::size_t goals_reached(const ExplorationRun& run) {
  return static_cast<std::size_t>(std::ranges::count_if(run.goal_distance_m, [](double d) { return d <= reached_m; }));
}

double covered(const ExplorationRun& run) {
  return run.coverage.empty() ? 0.0 : run.coverage.back().covered;
}

/// Simulated seconds per second of processor time.
double speed(const ExplorationRun& run) {
  return run.cpu_s > 0.0 ? run.time_s / run.cpu_s : 0.0;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const studies::MapScore& score) {
  return {{"points", score.points},
          {"mae_m", number(score.mae_m)},
          {"correct_detection", number(score.detection.overall_ratio())}};
}

Json json_of(const ExplorationRun& run) {
  Json json{{"seed", run.seed},
            {"status", name(run.status)},
            {"reason", run.reason},
            {"time_s", run.time_s},
            {"travelled_m", run.travelled_m},
            {"collisions", run.collisions},
            {"least_clearance_m", number(run.least_clearance_m)},
            {"covered", covered(run)},
            {"goals", run.goal_distance_m.size()},
            {"goals_reached", goals_reached(run)},
            {"goal_distance_m", run.goal_distance_m}};
  if (run.score) json["score"] = json_of(*run.score);
  if (run.directions)
    json["directional_maximum"] = {{"followed", json_of(run.directions->followed)},
                                   {"ideal", json_of(run.directions->ideal)}};
  return json;
}

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string runs_csv(const std::vector<ExplorationRun>& runs) {
  std::string text =
      "seed,status,reason,time_s,travelled_m,collisions,least_clearance_m,covered,goals_reached,points,mae_m\n";
  for (const ExplorationRun& run : runs)
    text += fmt::format("{},{},\"{}\",{:.2f},{:.3f},{},{},{:.5f},{},{},{}\n", run.seed, name(run.status), run.reason,
                        run.time_s, run.travelled_m, run.collisions, cell(run.least_clearance_m), covered(run),
                        goals_reached(run), run.score ? run.score->points : 0, run.score ? cell(run.score->mae_m) : "");
  return text;
}

/// The only figures that differ from run to run.
Json times_of(const ExplorationRun& run) {
  return {{"seed", run.seed}, {"cpu_s", run.cpu_s}, {"steering_p99_s", run.steering_p99_s}};
}

Json report_of(const ExplorationReport& report) {
  Json runs = Json::array();
  for (const ExplorationRun& run : report.runs) runs.push_back(json_of(run));
  return {{"written_by", "echoarc"},
          {"version", ECHOARC_VERSION},
          {"command", report.command},
          {"scene", report.request->scene.name},
          {"strategy", report.request->strategy},
          {"method", report.request->maps.method},
          {"runs", std::move(runs)}};
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string timings(const std::vector<ExplorationRun>& runs) {
  Json times = Json::array();
  for (const ExplorationRun& run : runs) times.push_back(times_of(run));
  return text_of({{"runs", std::move(times)}});
}

std::string coverage_csv(const std::vector<ExplorationRun>& runs) {
  std::string text = "seed,time_s,travelled_m,covered\n";
  for (const ExplorationRun& run : runs)
    for (const studies::CoverageSample& sample : run.coverage)
      text += fmt::format("{},{:.2f},{:.3f},{:.5f}\n", run.seed, sample.time_s, sample.travelled_m, sample.covered);
  return text;
}

Result<void> write_log(const std::filesystem::path& path, const Log& log) {
  const Result<std::unique_ptr<io::FileSink>> sink = io::FileSink::create(path);
  if (!sink) return sink.error();
  if (Result<void> written = io::write_jsonl(log, **sink); !written) return written;
  return (*sink)->commit();
}

Result<void> write_run(const std::filesystem::path& folder, const ExplorationReport& report, const ExplorationRun& run,
                       bool with_log) {
  const std::string stem = fmt::format("seed-{}", run.seed);
  if (Result<void> written =
          io::write_exploration_picture(folder / (stem + ".png"), report.request->scene, run.log, run.map, run.sketch);
      !written)
    return written;
  if (run.graph) {
    if (Result<void> written = write_text(folder / (stem + ".graphml"), nav::to_graphml(*run.graph)); !written)
      return written;
    if (Result<void> written = write_text(folder / (stem + "-graph.json"), nav::to_json(*run.graph)); !written)
      return written;
  }
  return with_log ? write_log(folder / (stem + ".jsonl"), run.log) : Result<void>{};
}

}  // namespace

std::string exploration_table(const ExplorationReport& report) {
  const bool goals = !report.request->goals.empty();
  const bool scored = std::ranges::any_of(report.runs, [](const ExplorationRun& run) { return run.score.has_value(); });
  std::vector<std::string> head{"seed", "end", "time [s]", "way [m]", "collisions", "clearance [cm]", "covered [%]"};
  if (goals) head.emplace_back("goals");
  if (scored) head.emplace_back("MAE [cm]");
  head.insert(head.end(), {"x real time", "step p99 [ms]"});
  head.emplace_back("why");
  Table table(head);
  table.words({1, head.size() - 1});
  for (const ExplorationRun& run : report.runs) {
    std::vector<std::string> row{std::to_string(run.seed),
                                 std::string(name(run.status)),
                                 fmt::format("{:.0f}", run.time_s),
                                 fmt::format("{:.1f}", run.travelled_m),
                                 std::to_string(run.collisions),
                                 fmt::format("{:.0f}", 100.0 * run.least_clearance_m),
                                 fmt::format("{:.1f}", 100.0 * covered(run))};
    if (goals) row.push_back(fmt::format("{} of {}", goals_reached(run), run.goal_distance_m.size()));
    if (scored) row.push_back(run.score ? fmt::format("{:.1f}", 100.0 * run.score->mae_m) : "-");
    row.push_back(fmt::format("{:.0f}", speed(run)));
    row.push_back(fmt::format("{:.2f}", 1e3 * run.steering_p99_s));
    row.push_back(run.reason);
    table.add(row);
  }
  return fmt::format("{}: {}\n{}", report.request->scene.name, report.request->strategy, table.text());
}

std::string exploration_json(const ExplorationReport& report) {
  Json json = report_of(report);
  for (std::size_t k = 0; k < report.runs.size(); ++k) json["runs"][k].update(times_of(report.runs[k]));
  return text_of(json);
}

Result<void> write_exploration(const std::filesystem::path& folder, const ExplorationReport& report, bool logs) {
  if (Result<void> written = write_text(folder / "runs.csv", runs_csv(report.runs)); !written) return written;
  if (Result<void> written = write_text(folder / "coverage.csv", coverage_csv(report.runs)); !written) return written;
  if (Result<void> written = write_text(folder / io::run_report_name, text_of(report_of(report))); !written)
    return written;
  if (Result<void> written = write_text(folder / "timings.json", timings(report.runs)); !written) return written;
  for (const ExplorationRun& run : report.runs)
    if (Result<void> written = write_run(folder, report, run, logs); !written) return written;
  return {};
}

}  // namespace echoarc::cli
