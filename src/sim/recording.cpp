// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/recording.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "sim/laser.hpp"
#include "sim/odometry_drift.hpp"
#include "sim/scene_checks.hpp"
#include "sim/scene_fault.hpp"
#include "sim/sonar.hpp"

namespace echoarc::sim {
namespace {

constexpr std::size_t max_beams = 1'000'000'000;
constexpr double same_time_s = 1e-6;

/// 0, 1/rate, 2/rate, ... to the end, the end itself, and when stops begin and end; none twice.
std::vector<double> pose_times(const Run& run) {
  const double rate_hz = run.scene.odometry.rate_hz;
  const double end_s = run.schedule.end_s();
  std::vector<double> times;
  for (std::uint64_t k = 0; static_cast<double>(k) <= end_s * rate_hz; ++k)
    times.push_back(static_cast<double>(k) / rate_hz);
  for (const Trajectory::Move& move : run.plan.trajectory.moves())
    if (run.plan.with_stops) times.push_back(move.begin_s);
  times.push_back(end_s);
  std::ranges::sort(times);
  const auto close = [](double a, double b) { return b - a < same_time_s; };
  times.erase(std::unique(times.begin(), times.end(), close), times.end());
  // What is left of two close ones is the earlier; the last record must not come before the last ping.
  times.back() = std::max(times.back(), end_s);
  return times;
}

std::optional<Error> hit_by_disc(const Run& run, const Pose2& T_world_robot, double time_s) {
  for (const MovingDisc& disc : run.world.description().moving)
    if (norm(disc.at(time_s).centre - T_world_robot.position) < disc.radius_m + run.scene.robot.radius_m)
      return scene_fault("a moving disc hits the robot after " + short_number(time_s) + " s", disc.line,
                         "lead it past the robot, or start it at another time");
  return std::nullopt;
}

void count_ping(const Ping& ping, SimulationReport& report) {
  if (ping.echo_index > 0) return;
  ++report.windows;
  if (ping.cause == EchoCause::unknown)
    ++report.silent_windows;
  else
    ++report.echoes[static_cast<std::size_t>(ping.cause)];
}

std::vector<double> scan_times(const Run& run, const LaserOptions& laser) {
  if (run.plan.with_stops) return run.plan.stops_s;
  std::vector<double> times;
  for (std::uint64_t k = 0; static_cast<double>(k) <= run.schedule.end_s() * laser.rate_hz; ++k)
    times.push_back(static_cast<double>(k) / laser.rate_hz);
  return times;
}

double scans_of(const Run& run, const LaserOptions& laser) {
  return run.plan.with_stops ? static_cast<double>(run.plan.stops_s.size())
                             : run.schedule.end_s() * laser.rate_hz + 1.0;
}

}  // namespace

Result<void> record_poses(const Run& run, Log& log) {
  if (run.schedule.end_s() * run.scene.odometry.rate_hz > static_cast<double>(max_firings))
    return scene_fault("the drive lasts so long that it would have more than 10 million odometry records", 0,
                       "drive faster or a shorter way, or lower the odometry's rate_hz");
  OdometryDrift drift(run.scene.odometry, run.seed, run.plan.trajectory.at(0.0));
  for (const double time_s : pose_times(run)) {
    const Pose2 T_world_robot = run.plan.trajectory.at(time_s);
    if (const auto hit = hit_by_disc(run, T_world_robot, time_s)) return *hit;
    log.truth.push_back({.time_s = time_s, .T_world_robot = T_world_robot});
    log.odometry.push_back({.time_s = time_s, .T_world_robot = drift.advance(T_world_robot)});
  }
  return {};
}

bool record_pings(const Run& run, Simulation& simulation) {
  constexpr std::uint64_t block = 256;
  Sonar sonar(run.world, run.scene.robot.sensors, run.scene.sonar, run.seed);
  const auto look_back = static_cast<std::uint64_t>(std::ceil(sonar.memory_s() / run.scene.sonar.interval_s));
  std::vector<Firing> firings;
  const std::uint64_t count = run.schedule.count();
  for (std::uint64_t begin = 0; begin < count; begin += block) {
    if (run.host.cancelled && run.host.cancelled()) return false;
    if (run.host.progress) run.host.progress(static_cast<double>(begin) / static_cast<double>(count));
    const std::uint64_t end = std::min(begin + block, count);
    const std::uint64_t oldest = begin - std::min(begin, look_back);
    firings.clear();
    for (std::uint64_t k = oldest; k < end; ++k) firings.push_back(run.schedule.firing(k));
    for (std::uint64_t k = begin; k < end; ++k)
      sonar.listen(std::span(firings).first(k - oldest), firings[k - oldest], simulation.log.pings);
  }
  for (const Ping& ping : simulation.log.pings) count_ping(ping, simulation.report);
  simulation.report.firings = count;
  simulation.report.truncated_pings = sonar.truncated();
  return true;
}

Result<void> record_scans(const Run& run, Log& log) {
  double beams = 0.0;
  for (const LaserOptions& laser : run.scene.lasers) beams += scans_of(run, laser) * laser.beams;
  if (beams > static_cast<double>(max_beams))
    return scene_fault("the lasers would cast more than 10^9 beams", 0, "lower their rate_hz or beams");
  for (const LaserOptions& laser : run.scene.lasers) {
    const LaserMount& mount = *find_laser(run.scene.robot, laser.laser);
    std::uint64_t number = 0;
    for (const double time_s : scan_times(run, laser))
      log.scans.push_back(scan_of(run.world, mount, laser, run.plan.trajectory.at(time_s), time_s, run.seed, number++));
  }
  std::ranges::stable_sort(log.scans, {}, &Scan::time_s);
  return {};
}

void record_wall(const Run& run, Log& log) {
  constexpr double straight_deg = 1e-6;
  const double facing_deg = wrap(run.scene.drive.facing).deg();
  if (!run.plan.with_stops || std::abs(std::abs(facing_deg) - 90.0) > straight_deg) return;
  log.walls.push_back({.time_s = 0.0, .side = facing_deg > 0.0 ? WallSide::left : WallSide::right});
}

}  // namespace echoarc::sim
