// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>

#include "sensing/findings.hpp"

namespace echoarc {
namespace {

constexpr double fastest_mps = 10.0;  // no indoor robot drives faster
constexpr double fastest_turn_radps = 10.0;
constexpr std::size_t enough_steps = 20;

/// What the odometry does from record to record.
struct Steps {
  std::size_t count = 0;
  std::size_t too_fast = 0;
  std::size_t turning_too_fast = 0;
  std::uint64_t first_fast_line = 0;
  double length_m = 0.0;
  double longest_m = 0.0;  ///< of those that are not too fast
};

Steps steps_of(const std::vector<Odometry>& odometry) {
  Steps steps;
  for (std::size_t k = 1; k < odometry.size(); ++k) {
    const Odometry& from = odometry[k - 1];
    const Odometry& to = odometry[k];
    const double dt = to.time_s - from.time_s;
    if (!is_finite(from.T_world_robot) || !is_finite(to.T_world_robot) || !(dt > 0.0)) continue;
    const double length_m = norm(to.T_world_robot.position - from.T_world_robot.position);
    ++steps.count;
    steps.length_m += length_m;
    if (length_m > fastest_mps * dt) {
      if (steps.too_fast++ == 0) steps.first_fast_line = to.line;
    } else {
      steps.longest_m = std::max(steps.longest_m, length_m);
    }
    const Angle turn = abs(wrap(to.T_world_robot.heading - from.T_world_robot.heading));
    if (turn.rad() > fastest_turn_radps * dt) ++steps.turning_too_fast;
  }
  return steps;
}

void find_fast_steps(const Steps& steps, Findings& findings) {
  const std::string where = steps.first_fast_line > 0 ? ", first at line " + std::to_string(steps.first_fast_line) : "";
  const std::string message = std::to_string(steps.too_fast) + " of " + std::to_string(steps.count) +
                              " steps of the odometry are faster than 10 m/s" + where;
  if (10 * steps.too_fast > steps.count)
    findings.push_back({Severity::warning, "odometry_too_fast", message,
                        "x and y are in metres and t in seconds; a log in millimetres needs a description with units"});
  else if (steps.too_fast > 0)
    findings.push_back({Severity::warning, "pose_jumps", message,
                        "use raw odometry, or a localisation whose corrections are smooth; each jump tears the map"});
}

/// The unit in which a typical range would be plausible.
std::string_view likely_unit(double median, const SensorModel& model) {
  struct Unit {
    double metres;
    std::string_view name;
  };
  constexpr std::array units{Unit{0.01, "centimetres"}, Unit{0.001, "millimetres"}};
  for (const Unit& unit : units)
    if (median * unit.metres >= model.range_min_m && median * unit.metres <= model.range_max_m) return unit.name;
  return "";
}

}  // namespace

void find_odd_odometry(const Log& log, Findings& findings) {
  if (log.odometry.empty()) {
    findings.push_back({Severity::error, "no_odometry", "the log has no odometry; without poses there is no map",
                        "give poses with --odometry poses.csv (t,x,y,yaw), or a description that names their columns"});
    return;
  }
  const Steps steps = steps_of(log.odometry);
  find_fast_steps(steps, findings);
  if (steps.count >= enough_steps && 20 * steps.turning_too_fast > steps.count)
    findings.push_back({Severity::warning, "odometry_turns_too_fast",
                        std::to_string(steps.turning_too_fast) + " of " + std::to_string(steps.count) +
                            " steps of the odometry turn faster than 10 rad/s",
                        "yaw is in radians; a log in degrees needs a description with units"});
  if (steps.count >= enough_steps && steps.length_m < 0.05)
    findings.push_back({Severity::warning, "robot_stands_still",
                        "the odometry moves " + number_text(100.0 * steps.length_m, 1) + " cm in the whole log",
                        "check that the odometry is the robot's and that x and y are in metres"});
  if (steps.longest_m > 0.5)
    findings.push_back({Severity::note, "odometry_sparse",
                        "up to " + number_text(steps.longest_m, 2) + " m of way between two poses",
                        "log odometry more often; poses between are interpolated on a straight line"});
}

void find_odd_units(const Log& log, const SensingReport& report, Findings& findings) {
  const std::uint64_t implausible = report.rejected_pings[Rejection::implausible_range].count;
  if (implausible < enough_steps || 5 * implausible < report.pings) return;
  std::vector<double> ranges_m;
  const Sensor* first = nullptr;
  for (const Ping& ping : log.pings) {
    const Sensor* sensor = log.robot.sensors.find(ping.rx);
    if (sensor == nullptr || !std::isfinite(ping.range_m) || ping.range_m <= 2.0 * sensor->model.range_max_m) continue;
    ranges_m.push_back(ping.range_m);
    first = first == nullptr ? sensor : first;
  }
  if (first == nullptr) return;
  const auto middle = ranges_m.begin() + static_cast<std::ptrdiff_t>(ranges_m.size() / 2);
  std::ranges::nth_element(ranges_m, middle);
  const std::string_view unit = likely_unit(*middle, first->model);
  findings.push_back({Severity::error, "wrong_unit",
                      std::to_string(implausible) + " of " + std::to_string(report.pings) +
                          " ranges are beyond reach, typically " + number_text(*middle, 2) + " m" +
                          (unit.empty() ? "" : "; they look like " + std::string(unit)),
                      "ranges are in metres; describe the unit with --describe, or convert the log"});
}

}  // namespace echoarc
