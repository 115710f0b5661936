// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/localisation_drive.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "echoarc/core/rng.hpp"

namespace echoarc::studies {
namespace {

/// Ways of the legs; turns are none.
std::vector<double> leg_lengths_m(const sim::Drive& drive) {
  std::vector<double> lengths_m;
  Vec2 here = drive.start.position;
  for (const sim::DriveLeg& leg : drive.legs) {
    lengths_m.push_back(leg.to ? norm(*leg.to - here) : 0.0);
    here = leg.to.value_or(here);
  }
  return lengths_m;
}

/// Direction of travel and place after a leg.
Pose2 after(const Pose2& before, const sim::DriveLeg& leg) {
  if (!leg.to) return {before.position, wrap(before.heading + leg.turn.value_or(Angle{}))};
  const Vec2 way = *leg.to - before.position;
  return {*leg.to, norm(way) > 0.0 ? bearing(way) : before.heading};
}

/// The first sample that is not earlier.
const Odometry& sample_at(const std::vector<Odometry>& samples, double time_s) {
  const auto at = std::ranges::lower_bound(samples, time_s, {}, &Odometry::time_s);
  return at == samples.end() ? samples.back() : *at;
}

template <class Record>
void cut(std::vector<Record>& records, double begin_s, double end_s) {
  std::erase_if(records, [&](const Record& r) { return r.time_s >= begin_s && r.time_s < end_s; });
  for (Record& r : records)
    if (r.time_s >= end_s) r.time_s -= end_s - begin_s;
}

}  // namespace

sim::Drive repeated(sim::Drive drive, int laps) {
  const std::vector<sim::DriveLeg> once = drive.legs;
  for (int lap = 1; lap < laps; ++lap) drive.legs.insert(drive.legs.end(), once.begin(), once.end());
  return drive;
}

sim::Drive window_of(const sim::Drive& drive, std::size_t first, double length_m) {
  sim::Drive window = drive;
  window.legs.clear();
  Pose2 here = drive.start;
  for (std::size_t k = 0; k < drive.legs.size(); ++k) {
    sim::DriveLeg leg = drive.legs[k];
    const Pose2 from = std::exchange(here, after(here, leg));
    if (k < first) {
      window.start.position = here.position;
      if (!drive.keep_heading) window.start.heading = here.heading;
      continue;
    }
    const double leg_m = norm(here.position - from.position);
    if (leg.to && leg_m >= length_m) leg.to = from.position + (length_m / leg_m) * (here.position - from.position);
    window.legs.push_back(leg);
    length_m -= leg_m;
    if (length_m <= 0.0) break;
  }
  return window;
}

std::size_t any_leg(const sim::Drive& drive, double length_m, std::uint64_t seed) {
  const std::vector<double> lengths_m = leg_lengths_m(drive);
  double ahead_m = 0.0;
  std::size_t legs = lengths_m.size();
  while (legs > 0 && ahead_m < length_m) ahead_m += lengths_m[--legs];
  if (ahead_m < length_m || lengths_m.empty()) return 0;
  return static_cast<std::size_t>(Rng(seed).below(legs + 1));
}

void carry_away(SimulatedDrive& drive, double after_s, double ahead_s) {
  Log& log = drive.log;
  const double until_s = after_s + ahead_s;
  if (log.odometry.empty() || log.odometry.back().time_s <= until_s) return;
  const Pose2 T_old_new =
      sample_at(log.odometry, after_s).T_world_robot * inverse(sample_at(log.odometry, until_s).T_world_robot);
  for (Odometry& sample : log.odometry)
    if (sample.time_s >= until_s) sample.T_world_robot = T_old_new * sample.T_world_robot;
  for (Reading& reading : drive.readings) {
    if (reading.time_s < until_s) continue;
    for (Pose2* pose : {&reading.T_world_robot, &reading.T_world_tx, &reading.T_world_rx}) *pose = T_old_new * *pose;
  }
  cut(log.odometry, after_s, until_s);
  cut(log.truth, after_s, until_s);
  cut(log.pings, after_s, until_s);
  cut(drive.readings, after_s, until_s);
}

}  // namespace echoarc::studies
