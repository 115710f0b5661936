// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/scores.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoarc/core/pose_track.hpp"
#include "live/seen_wall.hpp"

namespace echoarc::live {
namespace {

constexpr double wall_spacing_m = 0.005;

/// A reference that does not change: the true walls.
class TrueWalls {
 public:
  explicit TrueWalls(Reference reference) : reference_(std::move(reference)), nearest_(reference_.points) {}
  [[nodiscard]] double distance_m(Vec2 p) const { return nearest_.distance_m(p); }

 private:
  Reference reference_;
  NearestPoints nearest_;
};

std::optional<double> median_bound_m(const PointMap& map) {
  std::vector<double> bounds;
  for (const MapPoint& point : map.points())
    if (std::isfinite(point.bound_m)) bounds.push_back(point.bound_m);
  if (bounds.empty()) return std::nullopt;
  const auto middle = bounds.begin() + std::ptrdiff_t(bounds.size() / 2);
  std::ranges::nth_element(bounds, middle);
  return *middle;
}

struct Distances {
  double mean_m = 0.0;
  double p95_m = 0.0;
};

template <class DistanceOf>
std::optional<Distances> distances(const PointMap& map, DistanceOf&& distance_of) {
  std::vector<double> all;
  double sum_m = 0.0;
  for (const MapPoint& point : map.points())
    if (const double d_m = distance_of(point.position); std::isfinite(d_m)) {
      all.push_back(d_m);
      sum_m += d_m;
    }
  if (all.empty()) return std::nullopt;
  const auto at = std::size_t(std::ceil(0.95 * double(all.size()))) - 1;
  std::ranges::nth_element(all, all.begin() + std::ptrdiff_t(at));
  return Distances{sum_m / double(all.size()), all[at]};
}

}  // namespace

class ScoreKeeper::State {
 public:
  explicit State(const SourceDescription& described) : source(described), seen(described) {
    if (source.walls.empty()) return;
    auto reference = polyline_reference(source.walls, "walls of the source", wall_spacing_m);
    if (reference) walls = std::make_unique<TrueWalls>(std::move(*reference));
  }

  [[nodiscard]] std::string reason() const {
    if (walls) return "";
    if (source.robot.lasers.empty()) return "No truth or laser in this source, so no score.";
    return laser.empty() ? "The laser has not seen any surface often enough yet." : "";
  }

  [[nodiscard]] MethodScore score(const RunningMethod& method, std::uint64_t pings) {
    MethodScore score;
    score.method = method.id();
    if (method.insert_cpu_s > 0.0 && pings > 0) score.cpu_ms_per_ping = 1e3 * method.insert_cpu_s / double(pings);
    if (!method.map) return score;
    const PointMap& points = method.map->points;
    score.points = points.size();
    score.bound_m = median_bound_m(points);
    std::optional<Distances> found;
    if (walls)
      found = distances(points, [&](Vec2 p) { return walls->distance_m(p); });
    else if (!laser.empty())
      found = distances(points, [&](Vec2 p) { return laser.distance_m(p); });
    if (found) {
      score.mae_m = found->mean_m;
      score.p95_m = found->p95_m;
    }
    const NearPoints near(points.points(), found_distance_m);
    score.found = walls ? seen.share_found(near) : laser.share_found(near);
    return score;
  }

  SourceDescription source;
  SeenWall seen;
  LaserCells laser;
  std::unique_ptr<TrueWalls> walls;
  PoseTrack track;
  std::optional<Scan> waiting;
  double newest_s = 0.0;
  std::optional<double> scored_s;
  std::vector<Scores> history;
};

ScoreKeeper::ScoreKeeper(const SourceDescription& source) : state_(std::make_unique<State>(source)) {}
ScoreKeeper::ScoreKeeper(ScoreKeeper&&) noexcept = default;
ScoreKeeper& ScoreKeeper::operator=(ScoreKeeper&&) noexcept = default;
ScoreKeeper::~ScoreKeeper() = default;

void ScoreKeeper::push(const Record& record) {
  State& s = *state_;
  if (const auto* truth = std::get_if<Truth>(&record);
      truth != nullptr && is_finite(truth->pose.T_world_robot.position))
    s.seen.look_from(truth->pose.T_world_robot.position, path_step_m);
  if (const auto* scan = std::get_if<Scan>(&record); scan != nullptr && !s.walls) s.waiting = *scan;
  const auto* odometry = std::get_if<Odometry>(&record);
  if (odometry == nullptr || s.track.push(*odometry)) return;
  s.newest_s = odometry->time_s;
  if (!s.source.has_truth) s.seen.look_from(odometry->T_world_robot.position, path_step_m);
  if (s.waiting && s.waiting->time_s <= s.newest_s)
    s.laser.add(*std::exchange(s.waiting, std::nullopt), s.track, s.source.robot.lasers);
}

bool ScoreKeeper::due() const {
  return !state_->track.empty() && (!state_->scored_s || state_->newest_s >= *state_->scored_s + interval_s);
}

const Scores& ScoreKeeper::update(const Mapper& mapper) {
  Scores scores;
  scores.time_s = state_->newest_s;
  scores.reason = state_->reason();
  for (const RunningMethod& method : mapper.methods())
    scores.methods.push_back(state_->score(method, mapper.readings().size()));
  state_->scored_s = state_->newest_s;
  state_->history.push_back(std::move(scores));
  return state_->history.back();
}

std::span<const Scores> ScoreKeeper::history() const {
  return state_->history;
}

void ScoreKeeper::restart() {
  const SourceDescription source = state_->source;
  state_ = std::make_unique<State>(source);
}

}  // namespace echoarc::live
