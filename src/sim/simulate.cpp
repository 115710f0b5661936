// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/simulate.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "echoarc/core/speed_of_sound.hpp"
#include "sim/recording.hpp"
#include "sim/registers.hpp"
#include "sim/scene_checks.hpp"
#include "sim/scene_fault.hpp"

namespace echoarc::sim {
namespace {

/// A log is kept in memory while it is made.
Result<void> check_size(const Scene& scene, const FiringSchedule& schedule) {
  const auto sensors = static_cast<double>(scene.robot.sensors.size());
  const double receivers = scene.sonar.listening == Listening::all ? sensors : 1.0;
  if (static_cast<double>(schedule.count()) * receivers > static_cast<double>(max_firings))
    return scene_fault("all sensors would listen to so many firings that there were more than 10 million pings", 0,
                       "drive a shorter way, stop less often, or set listening = \"own\"");
  if (scene.polling.polled && schedule.end_s() * scene.polling.rate_hz * sensors > 10.0 * max_firings)
    return scene_fault("the polls would hold more than 100 million ranges", 0,
                       "drive a shorter way, or lower the polling's rate_hz");
  return {};
}

/// Registers in place of pings.
void poll(const Run& run, Simulation& simulation) {
  const Scene& scene = run.scene;
  const double speed_m_s = speed_of_sound_m_s(scene.sonar.assumed_temperature_k);
  double last_time_out_s = 0.0;
  for (const Sensor& sensor : scene.robot.sensors.sensors())
    last_time_out_s = std::max(last_time_out_s, 2.0 * sensor.model.range_max_m / speed_m_s);
  simulation.log.polls = poll_registers(scene.robot.sensors, simulation.log.pings, scene.polling.rate_hz,
                                        run.schedule.end_s() + last_time_out_s, speed_m_s);
  simulation.polled_pings = std::exchange(simulation.log.pings, {});
}

/// The measured times are the simulator's own: a robot's log has ranges, in its steps.
void forget_flight_times(std::vector<Ping>& pings) {
  for (Ping& ping : pings) ping.time_of_flight_s = std::numeric_limits<double>::quiet_NaN();
}

Result<Simulation> record(const Run& run) {
  Simulation simulation;
  Log& log = simulation.log;
  log.source = run.scene.name;
  log.temperature_k = run.scene.sonar.assumed_temperature_k;
  log.robot = run.scene.robot;
  if (const Result<void> recorded = record_poses(run, log); !recorded) return recorded.error();
  if (const Result<void> recorded = record_scans(run, log); !recorded) return recorded.error();
  if (!record_pings(run, simulation))
    return Error{ErrorCode::interrupted, "interrupted before the drive was over", "", "run it again"};
  record_wall(run, log);
  if (run.scene.polling.polled) poll(run, simulation);
  forget_flight_times(log.pings);
  forget_flight_times(simulation.polled_pings);
  simulation.report.path_m = run.plan.trajectory.length_m();
  simulation.report.duration_s = run.schedule.end_s();
  return simulation;
}

Result<Simulation> run_scene(const Scene& scene, std::uint64_t seed, const SimulationHost& host) {
  if (const Result<void> checked = check_scene(scene); !checked) return checked.error();
  const Result<World> world = World::make(scene.world);
  if (!world) return world.error();
  const std::size_t sensors = scene.robot.sensors.size();
  const Result<DrivePlan> plan = plan_drive(scene.drive, static_cast<double>(sensors) * scene.sonar.interval_s);
  if (!plan) return plan.error();
  if (const Result<void> free = check_clearance(*world, plan->trajectory, scene.robot.radius_m); !free)
    return free.error();
  const Result<FiringSchedule> schedule =
      FiringSchedule::make(*plan, sensors, scene.sonar.interval_s, scene.drive.dwell_s);
  if (!schedule) return schedule.error();
  if (const Result<void> fits = check_size(scene, *schedule); !fits) return fits.error();
  return record({scene, *world, *plan, *schedule, seed, host});
}

}  // namespace

Result<Simulation> simulate(const Scene& scene, std::uint64_t seed, const SimulationHost& host) {
  Result<Simulation> simulation = run_scene(scene, seed, host);
  if (!simulation) return in_file(simulation.error(), scene.file);
  return simulation;
}

}  // namespace echoarc::sim
