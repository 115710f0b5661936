// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/log_input.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/sensing/diagnosis.hpp"
#include "echoarc/sensing/log_statistics.hpp"
#include "echoarc/sensing/sensing.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
  LogArguments input;
  bool json = false;
};

/// Everything that is told, in either form.
struct LogInfo {
  const Log& log;
  SensingReport report;
  LogStatistics statistics;
};

std::string number(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

void print_head(const LogInfo& info) {
  const Log& log = info.log;
  fmt::print("{}\n", log.source);
  fmt::print("  robot     {}, {}, {}\n", log.robot.name, counted(log.robot.sensors.size(), "sonar"),
             counted(log.robot.lasers.size(), "laser"));
  fmt::print("  duration  {} s, from {} to {}\n", number(info.statistics.duration_s(), 1),
             number(info.statistics.begin_s, 3), number(info.statistics.end_s, 3));
  fmt::print("  path      {:.2f} m in {}\n", info.statistics.path_m, counted(log.odometry.size(), "pose"));
  fmt::print("  records   {}, {}, {}, {}, {}\n", counted(log.pings.size(), "ping"),
             counted(log.scans.size(), "laser scan"), counted(log.polls.size(), "poll"),
             counted(log.truth.size(), "true pose"), counted(log.walls.size(), "wall note"));
}

void print_sensors(const LogInfo& info) {
  Table table({"sonar", "bearing", "pings", "rate", "echo", "no echo", "too close", "unusable", "nearest", "median",
               "farthest"});
  for (const SensorStatistics& sensor : info.statistics.sensors) {
    const Mount& mount = info.log.robot.sensors.find(sensor.sensor)->mount;
    table.add({std::to_string(sensor.sensor), fmt::format("{:.1f} deg", mount.yaw.deg()), std::to_string(sensor.pings),
               number(sensor.rate_hz, 2) + " Hz", std::to_string(sensor.echoes), std::to_string(sensor.no_echoes),
               std::to_string(sensor.too_close), std::to_string(sensor.unusable), number(sensor.range_min_m, 2) + " m",
               number(sensor.range_median_m, 2) + " m", number(sensor.range_max_m, 2) + " m"});
  }
  fmt::print("\n{}", table.text());
  if (info.statistics.unknown_sensor_pings > 0)
    fmt::print("  {} of sensors that are not described\n", counted(info.statistics.unknown_sensor_pings, "ping"));
}

void print_rejections(const SensingReport& report) {
  fmt::print("\n");
  for (const std::string& sentence : no_echo_sentences(report.no_echo)) fmt::print("  {}\n", sentence);
  fmt::print("  {} can be mapped, {} cannot\n", counted(report.accepted(), "ping"), report.rejected_pings.total());
  for (const RejectionInfo& reason : rejections())
    if (const RejectionTally& tally = report.rejected_pings[reason.reason]; tally.count > 0)
      fmt::print("    {}\n", describe(reason.reason, tally, "ping"));
  for (const RejectionInfo& reason : rejections())
    if (const RejectionTally& tally = report.rejected_odometry[reason.reason]; tally.count > 0)
      fmt::print("    {}\n", describe(reason.reason, tally, "odometry record"));
}

Json sensor_json(const SensorStatistics& sensor, const Sensor& described) {
  return {{"id", sensor.sensor},
          {"yaw_deg", described.mount.yaw.deg()},
          {"beam_width_deg", described.model.beam_width.deg()},
          {"pings", sensor.pings},
          {"rate_hz", sensor.rate_hz},
          {"echo", sensor.echoes},
          {"no_echo", sensor.no_echoes},
          {"too_close", sensor.too_close},
          {"unusable", sensor.unusable},
          {"range_min_m", sensor.range_min_m},
          {"range_median_m", sensor.range_median_m},
          {"range_max_m", sensor.range_max_m}};
}

Json rejections_json(const RejectionCounters& counters) {
  Json json = Json::object();
  for (const RejectionInfo& reason : rejections()) {
    const RejectionTally& tally = counters[reason.reason];
    if (tally.count == 0) continue;
    json[std::string(reason.name)] = {{"count", tally.count},
                                      {"first_line", tally.first_line},
                                      {"explanation", reason.explanation},
                                      {"remedy", reason.remedy}};
  }
  return json;
}

void print_json(const LogInfo& info) {
  const Log& log = info.log;
  Json sensors = Json::array();
  for (const SensorStatistics& sensor : info.statistics.sensors)
    sensors.push_back(sensor_json(sensor, *log.robot.sensors.find(sensor.sensor)));
  const Json json{{"log", log.source},
                  {"robot", log.robot.name},
                  {"duration_s", info.statistics.duration_s()},
                  {"begin_s", info.statistics.begin_s},
                  {"end_s", info.statistics.end_s},
                  {"path_m", info.statistics.path_m},
                  {"poses", log.odometry.size()},
                  {"pings", log.pings.size()},
                  {"scans", log.scans.size()},
                  {"polls", log.polls.size()},
                  {"sensors", std::move(sensors)},
                  {"unknown_sensor_pings", info.statistics.unknown_sensor_pings},
                  {"no_echo", no_echo_sentences(info.report.no_echo)},
                  {"accepted", info.report.accepted()},
                  {"rejected", rejections_json(info.report.rejected_pings)},
                  {"rejected_odometry", rejections_json(info.report.rejected_odometry)},
                  {"lines", log.report.lines},
                  {"bad_lines", log.report.bad_lines}};
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

ExitStatus run(const InfoArguments& arguments) {
  const Result<Log> log = load_log(arguments.input);
  if (!log) return fail(log.error());
  warn_of(log->report);
  SensingReport report = sense(*log).report;
  const LogStatistics statistics = log_statistics(*log, report.no_echo);
  const LogInfo info{*log, std::move(report), statistics};
  if (arguments.json) {
    print_json(info);
    return done;
  }
  print_head(info);
  print_sensors(info);
  print_rejections(info.report);
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<InfoArguments>();
  declare_log(app, arguments->input);
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb info_verb() {
  return {"info",
          "sensors, duration, path, pings per outcome, rates",
          {{"echoarc info room.jsonl", "a log in numbers"},
           {"echoarc info run1 --describe corridor.toml", "of a folder of delimited texts"},
           {"echoarc info room.jsonl --json", "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
