// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/diagnosis.hpp"

#include <algorithm>

#include "echoarc/sensing/sensing.hpp"
#include "sensing/findings.hpp"

namespace echoarc {
namespace {

PingsBySensor by_sensor(const Log& log) {
  PingsBySensor pings;
  for (const Ping& ping : log.pings)
    if (log.robot.sensors.find(ping.rx) != nullptr) pings[ping.rx].push_back(ping);
  return pings;
}

void add_reading_faults(const ReadReport& report, Findings& findings) {
  for (const std::string& warning : report.warnings)
    findings.push_back({Severity::note, "reader", warning, "see the description of the format"});
  if (report.bad_lines == 0) return;
  const BadLine& first = report.first_bad.front();
  findings.push_back({Severity::warning, "bad_lines",
                      std::to_string(report.bad_lines) + " of " + std::to_string(report.lines) +
                          " lines cannot be read, first line " + std::to_string(first.line) + ": " + first.message,
                      "correct the program that writes the log"});
}

/// One finding per reason; how grave it is follows from the share of records it concerns.
void add_rejections(const RejectionCounters& counters, std::uint64_t offered, std::string_view kind,
                    Findings& findings) {
  for (const RejectionInfo& reason : rejections()) {
    const RejectionTally& tally = counters[reason.reason];
    if (tally.count == 0) continue;
    const Severity severity = 2 * tally.count > offered     ? Severity::error
                              : 100 * tally.count > offered ? Severity::warning
                                                            : Severity::note;
    const std::string where = tally.first_line > 0 ? ", first at line " + std::to_string(tally.first_line) : "";
    findings.push_back({severity, reason.name,
                        std::to_string(tally.count) + " of " + std::to_string(offered) + " " + std::string(kind) +
                            " left out" + where + ": " + std::string(reason.explanation),
                        std::string(reason.remedy)});
  }
}

}  // namespace

std::vector<std::string> no_echo_sentences(std::span<const NoEchoDecision> decisions) {
  std::vector<std::string> rules;
  std::vector<std::vector<SensorId>> sensors;
  for (const NoEchoDecision& decision : decisions) {
    const auto known = std::ranges::find(rules, decision.rule);
    if (known == rules.end()) {
      rules.push_back(decision.rule);
      sensors.push_back({decision.sensor});
    } else {
      sensors[static_cast<std::size_t>(known - rules.begin())].push_back(decision.sensor);
    }
  }
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < rules.size(); ++k) sentences.push_back(sensor_text(sensors[k]) + ": " + rules[k]);
  return sentences;
}

std::vector<Finding> diagnose(const Log& log, const SensingOptions& options) {
  Findings findings = diagnose(log.robot);
  const SensingReport report = sense(log, options).report;
  const PingsBySensor pings = by_sensor(log);
  if (log.pings.empty())
    findings.push_back(
        {Severity::error, "no_pings", "the log holds no pings", "check with `echoarc info` what it does hold"});
  find_odd_odometry(log, findings);
  find_odd_clocks(log, pings, findings);
  find_odd_units(log, report, findings);
  find_odd_sensors(log, report, pings, findings);
  add_rejections(report.rejected_pings, report.pings, "pings", findings);
  add_rejections(report.rejected_odometry, report.odometry, "poses", findings);
  add_reading_faults(log.report, findings);
  for (const std::string& sentence : no_echo_sentences(report.no_echo))
    findings.push_back({Severity::note, "no_echo", sentence, "set no_echo in the robot description to overrule it"});
  std::ranges::stable_sort(findings, std::greater{}, &Finding::severity);
  return findings;
}

}  // namespace echoarc
