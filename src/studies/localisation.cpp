// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/localisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "echoarc/core/executor.hpp"
#include "echoarc/eval/statistics.hpp"
#include "echoarc/live/navigation_grid.hpp"
#include "echoarc/mapping/evidence_grid.hpp"
#include "studies/localisation_drive.hpp"

namespace echoarc::studies {
namespace {

using nav::LocalisationState;

constexpr double right_m = 0.5;
constexpr Angle right_turn = degrees(10.0);
constexpr double wrong_m = 1.0;
constexpr Angle wrong_turn = degrees(30.0);
constexpr double update_period_s = 0.1;
constexpr double sample_period_s = 1.0;
constexpr double heard_margin_m = 6.0;              // of an evidence grid around the way
constexpr std::uint64_t mapping_seed = 0x6d617070;  // of the drive that made the map: noise of its own

/// The way of one seed, no longer than is watched.
sim::Scene scene_of(const LocalisationRequest& request, std::uint64_t seed) {
  sim::Scene scene = request.scene;
  scene.lasers.clear();  // a robot that localises itself by sonar has none to carry
  scene.drive = repeated(scene.drive, request.laps);
  const bool misled = request.start == KnownStart::misled;
  const double length_m = scene.drive.speed_m_s * (request.limit_s + (misled ? request.carry_ahead_s : 0.0));
  const std::size_t first = request.scatter ? any_leg(scene.drive, length_m, seed) : 0;
  scene.drive = window_of(scene.drive, first, length_m);
  return scene;
}

/// What an earlier drive along the same way made of it.
Result<DenseGrid<CellState>> heard_map(sim::Scene scene, double cell_m, std::uint64_t seed) {
  scene.odometry.perfect = true;
  const Result<SimulatedDrive> drive = simulate_drive(scene, seed ^ mapping_seed);
  if (!drive) return drive.error();
  EvidenceGrid evidence({.cell_m = cell_m});
  InlineExecutor executor;
  evidence.insert(drive->readings, executor);
  Box box{scene.drive.start.position, scene.drive.start.position};
  for (const Reading& reading : drive->readings) {
    const Vec2 p = reading.T_world_robot.position;
    box = {{std::min(box.low.x, p.x), std::min(box.low.y, p.y)},
           {std::max(box.high.x, p.x), std::max(box.high.y, p.y)}};
  }
  const Vec2 margin{heard_margin_m, heard_margin_m};
  live::NavigationGrid grid(cell_m);
  if (!grid.cover(box))
    return Error{ErrorCode::too_large, "the map of the drive is too large", "", "use larger cells, or a shorter limit"};
  grid.take(evidence, {box.low - margin, box.high + margin});
  return grid.cells();
}

/// Runs the localisation through a drive.
class Pursuit {
 public:
  Pursuit(const LocalisationRequest& request, const SimulatedDrive& drive, std::uint64_t seed, const StudyHost& host)
      : request_(request), drive_(drive), host_(host), localisation_(request.options, seed) {
    run_.seed = seed;
  }

  /// False if the host cancelled.
  bool follow(const DenseGrid<CellState>& map) {
    localisation_.set_map(map);
    if (request_.start != KnownStart::nothing) localisation_.start_at(drive_.log.truth.front().T_world_robot);
    double next_update_s = 0.0;
    for (const Odometry& sample : drive_.log.odometry) {
      if (sample.time_s > request_.limit_s) break;
      if (sample.time_s + eps_s < next_update_s) continue;
      next_update_s = sample.time_s + update_period_s;
      if (host_.cancelled && host_.cancelled()) return false;
      update(sample);
      judge(sample);
    }
    conclude();
    return true;
  }

  LocalisationRun& run() { return run_; }

 private:
  static constexpr double eps_s = 1e-9;

  void update(const Odometry& sample) {
    const std::vector<Reading>& readings = drive_.readings;
    std::size_t end = heard_;
    while (end < readings.size() && readings[end].time_s <= sample.time_s) ++end;
    const double begin_s = host_.thread_cpu_s ? host_.thread_cpu_s() : 0.0;
    localisation_.update(sample.T_world_robot, std::span(readings).subspan(heard_, end - heard_));
    if (host_.thread_cpu_s) steps_s_.push_back(host_.thread_cpu_s() - begin_s);
    heard_ = end;
  }

  [[nodiscard]] const Pose2& truth_at(double time_s) {
    const std::vector<Odometry>& truth = drive_.log.truth;
    while (true_ + 1 < truth.size() && truth[true_ + 1].time_s <= time_s + eps_s) ++true_;
    return truth[true_].T_world_robot;
  }

  void judge(const Odometry& sample) {
    const Pose2 T_map_true = truth_at(sample.time_s);
    const double step_s = time_s_ ? sample.time_s - *time_s_ : 0.0;
    const double step_m = time_s_ ? norm(T_map_true.position - last_place_) : 0.0;
    time_s_ = sample.time_s;
    last_place_ = T_map_true.position;
    const bool carried = request_.start == KnownStart::misled && sample.time_s + eps_s >= request_.carry_after_s;
    // The way on which it was carried is not its own.
    if (carried == carried_) run_.travelled_m += step_m;
    if (carried && !carried_) begin_again(sample.time_s);
    carried_ = carried;

    const nav::PoseEstimate& estimate = localisation_.estimate();
    const double error_m = norm(estimate.T_map_robot.position - T_map_true.position);
    const Angle error = abs(wrap(estimate.T_map_robot.heading - T_map_true.heading));
    const bool claimed = estimate.state == LocalisationState::localised;
    if (claimed && !found_s_ && error_m <= right_m && error <= right_turn) {
      run_.found_s = found_s_ = sample.time_s - begin_s_;
      run_.found_m = run_.travelled_m - begin_m_;
    }
    tally(estimate.state, step_s, error_m, error);
    if (sample.time_s + eps_s >= next_sample_s_) {
      run_.samples.push_back({sample.time_s, estimate.state, estimate.T_map_robot, T_map_true});
      next_sample_s_ += sample_period_s;
    }
    T_world_odometry_ = sample.T_world_robot;
  }

  /// It was carried away: from here on it has to be found.
  void begin_again(double time_s) {
    begin_s_ = time_s;
    begin_m_ = run_.travelled_m;
    found_s_.reset();
    run_.found_s.reset();
    run_.found_m.reset();
    misled_ = true;
  }

  void tally(LocalisationState state, double step_s, double error_m, Angle error) {
    const bool claimed = state == LocalisationState::localised;
    if (claimed) localised_s_ += step_s;
    if (state == LocalisationState::ambiguous) ambiguous_s_ += step_s;
    const bool wrong = claimed && (error_m > wrong_m || error > wrong_turn);
    misled_ = misled_ && wrong;
    if (wrong) (misled_ ? run_.misled_s : run_.wrong_s) += step_s;
    if (wrong && !misled_ && !was_wrong_) ++run_.wrong_claims;
    was_wrong_ = wrong;
    if (misled_) return;
    if (claimed) {
      errors_m_.push_back(error_m);
      errors_deg_.push_back(error.deg());
    }
    if (found_s_) any_errors_m_.push_back(error_m);
  }

  void conclude() {
    run_.time_s = time_s_.value_or(0.0);
    const double whole_s = std::max(run_.time_s, eps_s);
    run_.localised_share = localised_s_ / whole_s;
    run_.ambiguous_share = ambiguous_s_ / whole_s;
    run_.error_median_m = percentile(errors_m_, 0.5);
    run_.error_p95_m = percentile(errors_m_, 0.95);
    run_.heading_p95_deg = percentile(errors_deg_, 0.95);
    run_.any_error_p95_m = percentile(any_errors_m_, 0.95);
    run_.odometry_error_m = norm(T_world_odometry_.position - last_place_);
    run_.last_word = localisation_.estimate().reason;
    if (steps_s_.empty()) return;
    run_.step_p99_s = percentile(steps_s_, 0.99);
    run_.step_max_s = std::ranges::max(steps_s_);
    for (const double step_s : steps_s_) run_.cpu_s += step_s;
  }

  const LocalisationRequest& request_;
  const SimulatedDrive& drive_;
  const StudyHost& host_;
  nav::GlobalLocalisation localisation_;
  LocalisationRun run_;
  std::size_t heard_ = 0;         // readings
  std::size_t true_ = 0;          // index of the newest true pose
  std::optional<double> time_s_;  // of the last update
  Vec2 last_place_;
  double begin_s_ = 0.0;  // of looking for its pose
  double begin_m_ = 0.0;
  std::optional<double> found_s_;
  bool carried_ = false;
  bool misled_ = false;  // carried away, and has not noticed
  bool was_wrong_ = false;
  double localised_s_ = 0.0;
  double ambiguous_s_ = 0.0;
  double next_sample_s_ = 0.0;
  Pose2 T_world_odometry_;
  std::vector<double> errors_m_;
  std::vector<double> errors_deg_;
  std::vector<double> any_errors_m_;
  std::vector<double> steps_s_;
};

}  // namespace

Result<LocalisationRun> localise(const LocalisationRequest& request, std::uint64_t seed, const StudyHost& host) {
  const sim::Scene scene = scene_of(request, seed);
  Result<SimulatedDrive> drive = simulate_drive(scene, seed);
  if (!drive) return drive.error();
  if (request.start == KnownStart::misled) carry_away(*drive, request.carry_after_s, request.carry_ahead_s);
  Result<DenseGrid<CellState>> map = request.map == LocalisationMap::evidence
                                         ? heard_map(scene, request.cell_m, seed)
                                         : Result(surface_map(scene.world, scene.drive.start.position, request.cell_m));
  if (!map) return map.error();
  Pursuit pursuit(request, *drive, seed, host);
  if (!pursuit.follow(*map)) return interrupted_study();
  return std::move(pursuit.run());
}

Result<std::vector<LocalisationRun>> localise_seeds(const LocalisationRequest& request, const StudyHost& host,
                                                    std::uint64_t first_seed) {
  const auto count = static_cast<std::size_t>(host.seeds);
  StudyProgress progress(host, count);
  return run_tasks<LocalisationRun>(host, count, progress,
                                    [&](std::size_t k) { return localise(request, first_seed + k, host); });
}

}  // namespace echoarc::studies
