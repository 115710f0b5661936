// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "sensing/findings.hpp"

namespace echoarc {
namespace {

constexpr std::size_t enough_pings = 20;

std::vector<double> raw_ranges(const std::vector<Ping>& pings) {
  std::vector<double> ranges_m;
  for (const Ping& ping : pings) ranges_m.push_back(ping.range_m);
  return ranges_m;
}

bool constant(const std::vector<double>& values) {
  return std::ranges::all_of(values, [&](double v) { return v == values.front(); });
}

void find_silent(const Log& log, const PingsBySensor& pings, Findings& findings) {
  std::vector<SensorId> missing;
  for (const Sensor& sensor : log.robot.sensors.sensors())
    if (!pings.contains(sensor.id)) missing.push_back(sensor.id);
  if (missing.empty() || pings.empty()) return;
  findings.push_back({Severity::warning, "sensor_missing",
                      sensor_text(missing) + (missing.size() == 1 ? " never reports" : " never report"),
                      "check the wiring and the ids; take a sensor that is not fitted out of the description"});
}

void find_unknown(const Log& log, Findings& findings) {
  std::set<SensorId> unknown;
  for (const Ping& ping : log.pings)
    for (const SensorId id : {ping.tx, ping.rx})
      if (unknown.size() < 64 && log.robot.sensors.find(id) == nullptr) unknown.insert(id);
  if (unknown.empty()) return;
  findings.push_back({Severity::warning, "sensor_not_described",
                      sensor_text({unknown.begin(), unknown.end()}) + " report but are not described",
                      "add their mounts to the robot description; ids must agree with those in the log"});
}

void find_deaf(const SensingReport& report, Findings& findings) {
  std::vector<SensorId> deaf;
  for (const SensorTally& tally : report.sensors)
    if (tally.echoes == 0 && tally.no_echoes >= enough_pings) deaf.push_back(tally.sensor);
  if (deaf.empty()) return;
  findings.push_back({Severity::warning, "never_an_echo",
                      sensor_text(deaf) + (deaf.size() == 1 ? " never hears" : " never hear") + " an echo",
                      "check that the sensor works and what its values for \"nothing there\" are (no_echo)"});
}

/// Enough that a wall alongside, read in whole centimetres, would have shown a second value.
constexpr std::size_t enough_to_be_stuck = 40;

void find_stuck(const Log& log, const PingsBySensor& pings, Findings& findings) {
  std::vector<SensorId> stuck;
  for (const auto& [sensor, own] : pings) {
    const std::vector<double> values = raw_ranges(own);
    const double range_max_m = log.robot.sensors.find(sensor)->model.range_max_m;
    if (values.size() >= enough_to_be_stuck && constant(values) && values.front() > 0.0 && values.front() < range_max_m)
      stuck.push_back(sensor);
  }
  if (stuck.empty()) return;
  findings.push_back({Severity::warning, "sensor_stuck",
                      sensor_text(stuck) + (stuck.size() == 1 ? " always reports" : " always report") + " one value",
                      "check wiring and driver; take the sensor out of the description until it works"});
}

/// Several sensors with one series of values: a driver that reads one of them under every name.
void find_copies(const PingsBySensor& pings, Findings& findings) {
  std::map<std::vector<std::uint64_t>, std::vector<SensorId>> same;
  for (const auto& [sensor, own] : pings) {
    const std::vector<double> values = raw_ranges(own);
    if (values.size() < enough_pings || constant(values)) continue;
    std::vector<std::uint64_t> bits;  // NaN equals NaN here
    for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
    same[std::move(bits)].push_back(sensor);
  }
  for (const auto& [bits, ids] : same)
    if (ids.size() > 1)
      findings.push_back({Severity::warning, "sensors_alike", sensor_text(ids) + " report the same series of values",
                          "check the driver: it seems to read one sensor under several ids"});
}

/// Most echoes of a sensor come from where its beam meets the floor.
void find_floor_echoes(const Log& log, const PingsBySensor& pings, Findings& findings) {
  std::vector<SensorId> hearing;
  for (const auto& [sensor, own] : pings) {
    const double floor_m = floor_range_m(*log.robot.sensors.find(sensor));
    if (!std::isfinite(floor_m) || own.size() < enough_pings) continue;
    const auto near_floor =
        std::ranges::count_if(own, [&](const Ping& ping) { return std::abs(ping.range_m - floor_m) < 0.03 * floor_m; });
    if (5 * near_floor > 4 * static_cast<std::ptrdiff_t>(own.size())) hearing.push_back(sensor);
  }
  if (hearing.empty()) return;
  findings.push_back({Severity::warning, "hears_floor",
                      sensor_text(hearing) + ": most echoes come from where the beam meets the floor",
                      "mount the sensor higher or tilt it up (negative pitch)"});
}

}  // namespace

void find_odd_sensors(const Log& log, const SensingReport& report, const PingsBySensor& pings, Findings& findings) {
  find_silent(log, pings, findings);
  find_unknown(log, findings);
  find_deaf(report, findings);
  find_stuck(log, pings, findings);
  find_copies(pings, findings);
  find_floor_echoes(log, pings, findings);
}

}  // namespace echoarc
