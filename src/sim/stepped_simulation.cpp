// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/stepped_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "echoarc/core/speed_of_sound.hpp"
#include "sim/bumper.hpp"
#include "sim/drive_plan.hpp"
#include "sim/laser.hpp"
#include "sim/odometry_drift.hpp"
#include "sim/registers.hpp"
#include "sim/scene_checks.hpp"
#include "sim/scene_fault.hpp"
#include "sim/sonar.hpp"

namespace echoarc::sim {
namespace {

constexpr double tick_s = 0.005;
// Times of callers and sensors are sums of decimal fractions: equal to about this.
constexpr double same_time_s = 1e-9;

/// Where the robot's base was at a moment.
struct Moment {
  Pose2 T_world_base;
  double travelled_m = 0.0;
};

Moment between(const Moment& from, const Moment& to, double fraction) {
  return {interpolate(from.T_world_base, to.T_world_base, fraction),
          from.travelled_m + fraction * (to.travelled_m - from.travelled_m)};
}

}  // namespace

struct SteppedSimulation::State {
  State(Scene of, std::shared_ptr<const World> in, std::uint64_t with_seed, const RobotLimits& limits)
      : scene(std::move(of)),
        world(std::move(in)),
        seed(with_seed),
        sonar(*world, scene.robot.sensors, scene.sonar, seed),
        registers(scene.robot.sensors, speed_of_sound_m_s(scene.sonar.assumed_temperature_k)),
        base(scene.drive.start, limits),
        bumper(*world, scene.robot.radius_m),
        before{scene.drive.start},
        after{scene.drive.start},
        T_world_measured(robot_of(scene.drive.start)),
        T_odom_measured(T_world_measured),
        drift(scene.odometry, seed, T_world_measured),
        scans(scene.lasers.size(), 0) {}

  /// The robot's frame is turned against its base by a turret, or keeps its heading.
  [[nodiscard]] Pose2 robot_of(const Pose2& T_world_base) const {
    const Angle heading = scene.drive.keep_heading ? scene.drive.start.heading : T_world_base.heading;
    return {T_world_base.position, heading + scene.drive.facing};
  }

  [[nodiscard]] Moment moment_at(double at_s) const {
    const double begin_s = tick_s * (static_cast<double>(ticks) - 1.0);
    return between(before, after, std::clamp((at_s - begin_s) / tick_s, 0.0, 1.0));
  }

  void tick_until(double until_s);
  void measure(double at_s, std::vector<SteppedRecord>& records);
  void scan(std::size_t laser, double at_s, std::vector<SteppedRecord>& records);
  void fire(double at_s, std::vector<SteppedRecord>& records);
  void poll(double at_s, std::vector<SteppedRecord>& records);
  bool say_next(double until_s, std::vector<SteppedRecord>& records);

  Scene scene;
  std::shared_ptr<const World> world;
  std::uint64_t seed;
  Sonar sonar;
  Registers registers;
  SimulatedRobot base;
  Bumper bumper;

  double time_s = 0.0;
  std::uint64_t ticks = 0;  // made so far; `before` and `after` the newest
  Moment before;
  Moment after;
  Pose2 T_world_measured;  // when odometry was last read: where the robot was,
  Pose2 T_odom_measured;   // and where it believed to be
  OdometryDrift drift;
  std::vector<Firing> firings;  // that can still be heard
  std::vector<Ping> heard;
  // How many there were of each.
  std::uint64_t poses = 0;
  std::uint64_t fired = 0;
  std::uint64_t polls = 0;
  std::vector<std::uint64_t> scans;  // by laser
};

void SteppedSimulation::State::tick_until(double until_s) {
  while (tick_s * static_cast<double>(ticks) + same_time_s < until_s) {
    ++ticks;
    before = after;
    base.step(tick_s);
    bumper.check(base, before.T_world_base.position, tick_s * static_cast<double>(ticks));
    const Pose2& now = base.T_world_robot();
    after = {now, before.travelled_m + norm(now.position - before.T_world_base.position)};
  }
}

void SteppedSimulation::State::measure(double at_s, std::vector<SteppedRecord>& records) {
  ++poses;
  T_world_measured = robot_of(moment_at(at_s).T_world_base);
  T_odom_measured = drift.advance(T_world_measured);
  records.emplace_back(Odometry{.time_s = at_s, .T_world_robot = T_odom_measured});
  records.emplace_back(TruePose{{.time_s = at_s, .T_world_robot = T_world_measured}});
}

void SteppedSimulation::State::scan(std::size_t laser, double at_s, std::vector<SteppedRecord>& records) {
  const LaserOptions& options = scene.lasers[laser];
  records.emplace_back(scan_of(*world, *find_laser(scene.robot, options.laser), options,
                               robot_of(moment_at(at_s).T_world_base), at_s, seed, scans[laser]++));
}

void SteppedSimulation::State::fire(double at_s, std::vector<SteppedRecord>& records) {
  const Moment moment = moment_at(at_s);
  const Firing now{.number = fired,
                   .time_s = at_s,
                   .sensor = static_cast<std::size_t>(fired % scene.robot.sensors.size()),
                   .T_world_robot = robot_of(moment.T_world_base),
                   .travelled_m = moment.travelled_m};
  ++fired;
  std::erase_if(firings, [&](const Firing& firing) { return at_s - firing.time_s > sonar.memory_s(); });
  heard.clear();
  sonar.listen(firings, now, heard);
  firings.push_back(now);
  for (Ping& ping : heard) {
    if (scene.polling.polled) {
      registers.hear(ping);
      continue;
    }
    ping.time_of_flight_s = std::numeric_limits<double>::quiet_NaN();  // the simulator's own
    records.emplace_back(ping);
  }
}

void SteppedSimulation::State::poll(double at_s, std::vector<SteppedRecord>& records) {
  ++polls;
  records.emplace_back(Poll{.time_s = at_s, .ranges_m = registers.at(at_s)});
}

/// The next thing to be said, if its time has come; poses before what is heard from them.
bool SteppedSimulation::State::say_next(double until_s, std::vector<SteppedRecord>& records) {
  constexpr double never_s = std::numeric_limits<double>::infinity();
  const auto at_rate = [](std::uint64_t number, double rate_hz) { return static_cast<double>(number) / rate_hz; };
  const double pose_s = at_rate(poses, scene.odometry.rate_hz);
  const double firing_s = static_cast<double>(fired) * scene.sonar.interval_s;
  const double poll_s = scene.polling.polled ? at_rate(polls, scene.polling.rate_hz) : never_s;
  double scan_s = never_s;
  std::size_t laser = 0;
  for (std::size_t k = 0; k < scans.size(); ++k)
    if (const double next_s = at_rate(scans[k], scene.lasers[k].rate_hz); next_s < scan_s) {
      scan_s = next_s;
      laser = k;
    }
  const double next_s = std::min({pose_s, scan_s, firing_s, poll_s});
  if (!(next_s <= until_s + same_time_s)) return false;
  tick_until(next_s);
  if (pose_s == next_s)
    measure(next_s, records);
  else if (scan_s == next_s)
    scan(laser, next_s, records);
  else if (firing_s == next_s)
    fire(next_s, records);
  else
    poll(next_s, records);
  return true;
}

SteppedSimulation::SteppedSimulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
SteppedSimulation::SteppedSimulation(SteppedSimulation&&) noexcept = default;
SteppedSimulation& SteppedSimulation::operator=(SteppedSimulation&&) noexcept = default;
SteppedSimulation::~SteppedSimulation() = default;

Result<SteppedSimulation> SteppedSimulation::make(Scene scene, std::uint64_t seed, const RobotLimits& limits) {
  if (const Result<void> checked = check_scene(scene); !checked) return in_file(checked.error(), scene.file);
  if (const Result<void> checked = validate(limits); !checked) return checked.error();
  Result<World> made = World::make(scene.world);
  if (!made) return in_file(made.error(), scene.file);
  const auto world = std::make_shared<const World>(std::move(made).value());
  Drive start = scene.drive;
  start.legs.clear();
  const Result<DrivePlan> plan = plan_drive(start, 0.0);
  if (!plan) return in_file(plan.error(), scene.file);
  if (const Result<void> free = check_clearance(*world, plan->trajectory, scene.robot.radius_m); !free)
    return in_file(free.error(), scene.file);
  return SteppedSimulation(std::make_unique<State>(std::move(scene), world, seed, limits));
}

void SteppedSimulation::command(const RobotVelocity& wanted, std::optional<double> deceleration_m_s2) {
  state_->base.command(wanted, deceleration_m_s2);
}

void SteppedSimulation::advance(double until_s, std::vector<SteppedRecord>& records) {
  if (!std::isfinite(until_s) || until_s < state_->time_s) return;
  while (state_->say_next(until_s, records)) {
  }
  state_->tick_until(until_s);
  state_->time_s = until_s;
}

double SteppedSimulation::time_s() const {
  return state_->time_s;
}

Pose2 SteppedSimulation::T_world_base() const {
  return state_->moment_at(state_->time_s).T_world_base;
}

Pose2 SteppedSimulation::T_world_robot() const {
  return state_->robot_of(T_world_base());
}

Pose2 SteppedSimulation::T_odom_base() const {
  return state_->T_odom_measured * (inverse(state_->T_world_measured) * T_world_base());
}

RobotVelocity SteppedSimulation::velocity() const {
  return state_->base.velocity();
}

double SteppedSimulation::travelled_m() const {
  return state_->moment_at(state_->time_s).travelled_m;
}

bool SteppedSimulation::touching() const {
  return state_->bumper.touching();
}

std::uint64_t SteppedSimulation::contacts() const {
  return state_->bumper.contacts();
}

const Scene& SteppedSimulation::scene() const {
  return state_->scene;
}

std::shared_ptr<const World> SteppedSimulation::world() const {
  return state_->world;
}

}  // namespace echoarc::sim
