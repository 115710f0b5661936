// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/log_input.hpp"
#include "cli/report.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/robot_toml.hpp"
#include "echoarc/sensing/diagnosis.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DoctorArguments {
  LogArguments input;
  bool json = false;
};

Result<std::vector<Finding>> examine(const LogArguments& input) {
  if (input.log.extension() == ".toml") {
    const Result<RobotDescription> robot = io::read_robot_toml(input.log);
    if (!robot) return robot.error();
    return diagnose(*robot);
  }
  const Result<Log> log = load_log(input);
  if (!log) return log.error();
  return diagnose(*log);
}

void print_findings(const std::string& subject, const std::vector<Finding>& findings) {
  const auto count = [&](Severity severity) {
    return static_cast<std::size_t>(std::ranges::count(findings, severity, &Finding::severity));
  };
  for (const Finding& finding : findings)
    fmt::print("{:<8} {}\n         {}\n         -> {}\n", name(finding.severity), finding.name, finding.message,
               finding.remedy);
  fmt::print("{}{}: {}, {}, {}\n", findings.empty() ? "" : "\n", subject, counted(count(Severity::error), "error"),
             counted(count(Severity::warning), "warning"), counted(count(Severity::note), "note"));
}

void print_json(const std::string& subject, const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings)
    list.push_back({{"severity", name(finding.severity)},
                    {"name", finding.name},
                    {"message", finding.message},
                    {"remedy", finding.remedy}});
  const Json json{{"subject", subject}, {"findings", std::move(list)}};
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

ExitStatus run(const DoctorArguments& arguments) {
  const Result<std::vector<Finding>> findings = examine(arguments.input);
  if (!findings) return fail(findings.error());
  const std::string subject = arguments.input.log.string();
  if (arguments.json)
    print_json(subject, *findings);
  else
    print_findings(subject, *findings);
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<DoctorArguments>();
  declare_log(app, arguments->input);
  app.get_option("LOG")->description("a log, a folder of delimited texts (with --describe), or a robot.toml");
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb doctor_verb() {
  return {"doctor",
          "what is wrong with a log or a robot description, and what to do about it",
          {{"echoarc doctor room.jsonl", "findings, the gravest first"},
           {"echoarc doctor robot.toml", "of a robot description alone"},
           {"echoarc doctor ranges.csv --odometry poses.csv --robot robot.toml", "of two plain tables"},
           {"echoarc doctor room.jsonl --json", "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
