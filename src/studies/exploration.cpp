// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/exploration.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/live/live_robot.hpp"
#include "echoarc/live/simulated_source.hpp"
#include "echoarc/studies/scene_reference.hpp"

namespace echoarc::studies {
namespace {

constexpr double step_s = 0.1;
constexpr double sample_period_s = 10.0;
constexpr double surface_step_m = 0.01;
/// What can be seen of a whole building is not worked out for a score.
constexpr double largest_scored_m2 = 1000.0;

/// Times what another strategy costs.
class TimedStrategy final : public nav::Strategy {
 public:
  TimedStrategy(std::unique_ptr<nav::Strategy> inner, std::function<double()> clock, std::vector<double>& steps_s)
      : inner_(std::move(inner)), clock_(std::move(clock)), steps_s_(steps_s) {}

  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  [[nodiscard]] nav::Sketch sketch() const override { return inner_->sketch(); }
  [[nodiscard]] const nav::VoronoiGraph* voronoi_graph() const override { return inner_->voronoi_graph(); }
  [[nodiscard]] nav::Steering update(const nav::Surroundings& surroundings) override {
    if (!clock_) return inner_->update(surroundings);
    const double begin_s = clock_();
    nav::Steering steering = inner_->update(surroundings);
    steps_s_.push_back(clock_() - begin_s);
    return steering;
  }

 private:
  std::unique_ptr<nav::Strategy> inner_;
  std::function<double()> clock_;
  std::vector<double>& steps_s_;
};

double percentile_99(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + std::ptrdiff_t(0.99 * double(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

/// How good the method's map of everything that was heard is.
Result<void> score(const ExplorationRequest& request, ExplorationRun& run) {
  if (!request.scoring) return {};
  const Vec2 size = request.scoring->region.high - request.scoring->region.low;
  if (size.x * size.y > largest_scored_m2) return {};
  const Result<Experiment> experiment = Experiment::make({request.scene, *request.scoring});
  if (!experiment) return experiment.error();
  const Result<Trial> trial = experiment->trial(run.seed, run.log);
  if (!trial) return trial.error();
  const MethodSpec spec{.label = request.maps.method, .method = request.maps.method, .options = {}};
  const Result<std::vector<MethodResult>> results = run_methods(*trial, {&spec, 1});
  if (!results) return results.error();
  run.score = results->front().points;
  Result<std::optional<DirectionScores>> directions = score_directions(*trial);
  if (!directions) return directions.error();
  run.directions = *directions;
  return {};
}

/// A run while it happens.
class Watch {
 public:
  Watch(const ExplorationRequest& request, const ReachableFloor& floor, const NearestPoints& surfaces)
      : request_(request), floor_(floor), surfaces_(surfaces) {
    run_.goal_distance_m.assign(request.goals.size(), std::numeric_limits<double>::infinity());
    run_.least_clearance_m = std::numeric_limits<double>::infinity();
    run_.log.robot = request.scene.robot;
    run_.log.source = request.scene.name;
  }

  void see(const live::LiveRobot& robot, double time_s) {
    const Vec2 here = robot.T_world_true()->position;
    const double clearance_m = surfaces_.distance_m(here) - request_.scene.robot.radius_m;
    run_.least_clearance_m = std::min(run_.least_clearance_m, clearance_m);
    for (std::size_t k = 0; k < request_.goals.size(); ++k)
      run_.goal_distance_m[k] = std::min(run_.goal_distance_m[k], norm(here - request_.goals[k]));
    if (time_s >= next_sample_s_) sample(robot, time_s);
  }

  void sample(const live::LiveRobot& robot, double time_s) {
    next_sample_s_ = time_s + sample_period_s;
    run_.coverage.push_back({time_s, robot.travelled_m(), floor_.covered(robot.navigator()->evidence().cells())});
  }

  void keep(std::vector<live::Record>& records) {
    if (request_.keep_log)
      for (const live::Record& record : records) std::visit([&](const auto& said) { put(said); }, record);
    records.clear();
  }

  ExplorationRun& run() { return run_; }

 private:
  template <class Said>
  void put(const Said& said) {
    if constexpr (std::is_same_v<Said, Odometry>)
      run_.log.odometry.push_back(said);
    else if constexpr (std::is_same_v<Said, live::Truth>)
      run_.log.truth.push_back(said.pose);
    else if constexpr (std::is_same_v<Said, Ping>)
      run_.log.pings.push_back(said);
    else if constexpr (std::is_same_v<Said, Poll>)
      run_.log.polls.push_back(said);
    else if constexpr (std::is_same_v<Said, Scan>)
      run_.log.scans.push_back(said);
    else if constexpr (std::is_same_v<Said, WallNote>)
      run_.log.walls.push_back(said);
  }

  const ExplorationRequest& request_;
  const ReachableFloor& floor_;
  const NearestPoints& surfaces_;
  double next_sample_s_ = 0.0;
  ExplorationRun run_;
};

/// Until the strategy has ended or the time is over. False if the host cancelled.
Result<bool> drive(live::LiveRobot& robot, Watch& watch, double limit_s, const StudyHost& host) {
  std::vector<live::Record> records;
  for (double time_s = step_s; time_s <= limit_s; time_s += step_s) {
    if (host.cancelled && host.cancelled()) return false;
    const Result<void> stepped = robot.step(time_s, time_s, records);
    if (!stepped) return stepped.error();
    watch.see(robot, time_s);
    watch.keep(records);
    if (robot.control()->state().mode != live::Mode::navigate) break;
  }
  return true;
}

void conclude(ExplorationRun& run, const live::LiveRobot& robot, const live::ControlState& state, double time_s) {
  run.time_s = time_s;
  run.travelled_m = robot.travelled_m();
  const nav::Strategy& strategy = *robot.navigator()->strategy();
  run.sketch = strategy.sketch();
  if (const nav::VoronoiGraph* graph = strategy.voronoi_graph()) run.graph = *graph;
  run.map = robot.navigator()->map().cells();
  run.reason = state.detail;
  if (state.reason == live::Reason::finished) run.status = nav::Status::finished;
  if (state.reason == live::Reason::failed) run.status = nav::Status::failed;
  if (run.status == nav::Status::running) run.reason = "the time was over while " + state.detail;
}

}  // namespace

Result<ExplorationRun> explore(const ExplorationRequest& request, const ReachableFloor& floor, std::uint64_t seed,
                               const StudyHost& host) {
  Result<std::unique_ptr<live::SimulatedSource>> made = live::SimulatedSource::make(request.scene, seed);
  if (!made) return made.error();
  const live::SimulatedSource& source = **made;
  Result<live::Navigator> navigator = live::Navigator::make(source.description(), request.maps);
  if (!navigator) return navigator.error();
  Result<PointSet> surfaces = PointSet::make(surface_points(request.scene.world, surface_step_m));
  if (!surfaces) return surfaces.error();
  const NearestPoints nearest(*surfaces);
  const double begin_cpu_s = host.thread_cpu_s ? host.thread_cpu_s() : 0.0;

  live::LiveRobot robot(std::move(*made), {}, std::move(*navigator));
  std::vector<double> steps_s;
  robot.navigate(std::make_unique<TimedStrategy>(request.make_strategy(), host.thread_cpu_s, steps_s), request.goals);
  Watch watch(request, floor, nearest);
  const Result<bool> whole = drive(robot, watch, request.limit_s, host);
  if (!whole) return whole.error();
  if (!*whole) return interrupted_study();

  ExplorationRun& run = watch.run();
  conclude(run, robot, robot.control()->state(), source.time_s());
  watch.sample(robot, run.time_s);
  run.seed = seed;
  run.collisions = source.simulation().contacts();
  run.steering_p99_s = percentile_99(steps_s);
  if (host.thread_cpu_s) run.cpu_s = host.thread_cpu_s() - begin_cpu_s;
  if (request.keep_log)
    if (const Result<void> scored = score(request, run); !scored) return scored.error();
  return std::move(run);
}

Result<std::vector<ExplorationRun>> explore_seeds(const ExplorationRequest& request, const StudyHost& host) {
  const ReachableFloor floor(request.scene.world, request.scene.drive.start.position, request.scene.robot.radius_m);
  const auto count = static_cast<std::size_t>(host.seeds);
  StudyProgress progress(host, count);
  return run_tasks<ExplorationRun>(host, count, progress,
                                   [&](std::size_t k) { return explore(request, floor, k + 1, host); });
}

}  // namespace echoarc::studies
