// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/global_localisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace echoarc::nav {
namespace {

constexpr std::size_t max_pending = 1024;  // readings of one step; a robot that stands hears no end of them
constexpr std::size_t coarse_probes = 16;
constexpr std::size_t fine_probes = 100;
constexpr std::size_t quick_probes = 60;
constexpr double around_m = 0.12;  // spread of particles around a pose that was searched for
constexpr Angle around = degrees(3.0);
constexpr double slip_m = 0.7;  // spread of newcomers around the pose as it was believed
constexpr Angle slip = degrees(15.0);
constexpr std::size_t candidates_each = 20;  // of which one newcomer is the best
constexpr double look_every_m = 1.0;         // while a pose is to be confirmed
constexpr double same_place_m = 0.5;
constexpr Angle same_heading = degrees(20.0);

bool same_place(const Pose2& a, const Pose2& b) {
  return norm(a.position - b.position) < same_place_m && abs(wrap(a.heading - b.heading)) < same_heading;
}

}  // namespace

GlobalLocalisation::GlobalLocalisation(const LocalisationOptions& options, std::uint64_t seed)
    : options_(options), filter_(options.filter, options.noise, seed), search_(options.search) {
  start_anywhere();
}

void GlobalLocalisation::set_map(const DenseGrid<CellState>& map) {
  map_ = LikelihoodMap(map);
  has_map_ = !map.empty();
  if (searching_) search_.begin(map_.floor_m2());
  judge();
}

void GlobalLocalisation::start_at(const Pose2& T_map_robot, double deviation_m, Angle deviation) {
  start_anywhere();
  if (!is_finite(T_map_robot)) return;
  filter_.start_at(T_map_robot, deviation_m, deviation);
  searching_ = false;
  believe(true);
  look();
  judge();
}

void GlobalLocalisation::start_anywhere() {
  filter_.clear();
  jumped_m_ = 0.0;
  silent_m_ = 0.0;
  if (T_odom_robot_) T_odom_step_ = *T_odom_robot_;
  estimate_ = {};
  begin_search("the pose is not known yet");
  judge();
}

void GlobalLocalisation::update(const Pose2& T_odom_robot, std::span<const Reading> readings) {
  if (!take_odometry(T_odom_robot)) return judge();
  keep(readings);
  const Pose2 T_before_now = inverse(T_odom_step_) * T_odom_robot;
  if (norm(T_before_now.position) >= options_.step_m || abs(wrap(T_before_now.heading)) >= options_.step_turn) {
    T_odom_step_ = T_odom_robot;
    if (map_.has_walls() && map_.has_floor()) step({T_before_now.position, wrap(T_before_now.heading)});
    pending_.clear();
    look();
  }
  judge();
}

/// Whether odometry can be used. One that jumps was set anew, or lies: the robot is taken to stand where it stood,
/// until its readings say otherwise.
bool GlobalLocalisation::take_odometry(const Pose2& T_odom_robot) {
  odometry_is_bad_ = !is_finite(T_odom_robot);
  if (odometry_is_bad_) return false;
  if (!T_odom_robot_) T_odom_step_ = T_odom_robot;
  const Pose2 T_before_now = inverse(T_odom_robot_.value_or(T_odom_robot)) * T_odom_robot;
  T_odom_robot_ = T_odom_robot;
  const double length_m = norm(T_before_now.position);
  if (length_m <= options_.jump_m && abs(wrap(T_before_now.heading)) <= options_.jump_turn) return true;
  T_odom_step_ = T_odom_robot;
  jumped_m_ = std::max(length_m, 1e-3);
  believe(false);
  forget();
  return true;
}

void GlobalLocalisation::keep(std::span<const Reading> readings) {
  for (const Reading& reading : readings) {
    const bool tells = is_no_echo(reading.outcome) || echo_range_m(reading.outcome).has_value();
    if (!tells || !is_finite(reading.T_world_tx) || !is_finite(reading.T_world_rx)) continue;
    if (pending_.size() < max_pending) pending_.push_back(reading);
  }
}

void GlobalLocalisation::forget() {
  pending_.clear();
  window_.clear();
  window_way_m_ = 0.0;
}

void GlobalLocalisation::step(const Pose2& T_before_now) {
  const double length_m = norm(T_before_now.position);
  const double way_m = length_m + options_.turn_way_m * abs(T_before_now.heading).rad();
  remember(way_m);
  filter_.move(T_before_now);
  search_.move(T_before_now);
  if (searching_) return search();
  track(length_m, way_m);
  if (!searching_ && !confirmed_) confirm();
}

/// Every so-manyth of the step's readings, for at most `readings_per_m`.
std::size_t GlobalLocalisation::stride_of(double way_m) const {
  const auto wanted = static_cast<std::size_t>(std::clamp(std::round(options_.readings_per_m * way_m), 1.0, 1e6));
  return std::max<std::size_t>(1, (pending_.size() + wanted - 1) / wanted);
}

void GlobalLocalisation::remember(double way_m) {
  window_way_m_ += way_m;
  const std::size_t stride = stride_of(way_m);
  for (std::size_t n = heard_ % stride; n < pending_.size(); n += stride) window_.push_back(pending_[n]);
  while (window_.size() > static_cast<std::size_t>(options_.search.window)) window_.pop_front();
}

/// At most about `most` of the window's readings.
ReadingProbes GlobalLocalisation::window_probes(double sigma_m, std::size_t most) const {
  ReadingModelOptions model = options_.model;
  model.sigma_m = sigma_m;
  ReadingProbes probes(map_, model);
  const std::size_t stride = std::max<std::size_t>(1, window_.size() / most);
  for (std::size_t n = 0; n < window_.size(); n += stride) probes.add(window_[n], T_odom_step_);
  return probes;
}

void GlobalLocalisation::begin_search(std::string why) {
  searching_ = true;
  search_reason_ = std::move(why);
  forget();
  fit_slow_ = 0.0;
  fit_fast_ = 0.0;
  fit_way_m_ = 0.0;
  search_.begin(map_.floor_m2());
  for (const PoseCluster& cluster : estimate_.clusters) search_.add(cluster.T_map_robot);
}

void GlobalLocalisation::search() {
  heard_ += pending_.size();
  const bool moved = window_way_m_ >= options_.search.least_way_m;
  const ReadingProbes fine = window_probes(options_.model.sigma_m, window_.size());
  if (!moved || fine.echoes() < static_cast<std::size_t>(options_.search.least_echoes)) return;
  search_.step(map_, window_probes(options_.search.coarse_sigma_m, coarse_probes),
               window_probes(options_.model.sigma_m, fine_probes), filter_.rng());
  if (!search_.done()) return;
  search_.judge(map_, window_probes(options_.model.sigma_m, quick_probes), fine, filter_.rng());
  const std::span<const PoseHypothesis> found = search_.hypotheses();
  const double exponent = options_.window_readings / static_cast<double>(fine.size());
  std::vector<Particle> poses;
  for (const PoseHypothesis& h : found) {
    poses.push_back({h.T_map_robot, std::exp(exponent * (h.log_likelihood - found.front().log_likelihood))});
  }
  believe(false);
  filter_.start_around(poses, around_m, around);
  searching_ = false;
  silent_m_ = 0.0;
}

/// A pose that is not confirmed has to be watched on its way, and the map looked over for others.
void GlobalLocalisation::believe(bool confirmed) {
  const bool already_looking = !confirmed && !confirmed_ && !searching_;
  if (!confirmed && !already_looking) search_.begin(map_.floor_m2());
  confirmed_ = confirmed;
  unconfirmed_m_ = confirmed ? 0.0 : confirm_way_m();
  filter_.keep_at_least(confirmed ? options_.filter.particles : options_.unconfirmed_particles);
}

/// On a small floor there are few places that could look alike.
double GlobalLocalisation::confirm_way_m() const {
  return std::min(options_.confirm_m, std::sqrt(map_.floor_m2()));
}

void GlobalLocalisation::track(double length_m, double way_m) {
  ReadingProbes probes(map_, options_.model);
  const std::size_t stride = std::max(static_cast<std::size_t>(options_.reading_stride), stride_of(way_m));
  for (const Reading& reading : pending_)
    if (heard_++ % stride == 0) probes.add(reading, T_odom_step_);
  const double fit =
      filter_.weigh(map_, probes, confirmed_ ? options_.filter.dependence_exponent : options_.unconfirmed_exponent);
  silent_m_ = probes.echoes() > 0 ? 0.0 : silent_m_ + length_m;
  unconfirmed_m_ = std::max(0.0, unconfirmed_m_ - length_m);
  const double ratio = probes.echoes() > 0 ? average_fit(fit, way_m) : 1.0;
  const bool known = fit_way_m_ >= options_.fast_m;
  if (known && (ratio < options_.lost_ratio || fit_fast_ < options_.lost_fit))
    return begin_search("the readings no longer fit the map there");
  if (!known || ratio >= options_.newcomer_ratio) {
    filter_.resample();
    return;
  }
  believe(false);
  filter_.resample(newcomers(ratio));
}

/// The short average of the fit as a share of the long one. At first both are plain means.
double GlobalLocalisation::average_fit(double fit, double way_m) {
  fit_way_m_ += way_m;
  const auto rate = [&](double over_m) { return std::max(1.0 - std::exp(-way_m / over_m), way_m / fit_way_m_); };
  fit_slow_ += rate(options_.slow_m) * (fit - fit_slow_);
  fit_fast_ += rate(options_.fast_m) * (fit - fit_fast_);
  return fit_slow_ > 0.0 ? fit_fast_ / fit_slow_ : 1.0;
}

/// Half of them near the pose as it was believed, for wheels slip more often than robots are carried away.
std::vector<Pose2> GlobalLocalisation::newcomers(double ratio) {
  const auto count = static_cast<double>(filter_.particles().size());
  const auto wanted = static_cast<std::size_t>(std::min(100.0, (options_.newcomer_ratio - ratio) * count));
  const Pose2 T_map_believed = moments_of(filter_.particles()).T_map_robot;
  Rng& rng = filter_.rng();
  std::vector<Pose2> candidates;
  for (std::size_t n = 0; n < candidates_each * wanted; ++n) {
    const Vec2 place = map_.any_place(rng);
    const double x = rng.normal(0.0, slip_m);
    const double y = rng.normal(0.0, slip_m);
    const Angle turn = rng.normal(0.0, 1.0) * slip;
    if (n % 2 == 0)
      candidates.push_back({place, degrees(rng.uniform(-180.0, 180.0))});
    else
      candidates.push_back({T_map_believed.position + Vec2{x, y}, T_map_believed.heading + turn});
  }
  const ReadingProbes coarse = window_probes(options_.search.coarse_sigma_m, coarse_probes);
  const ReadingProbes fine = window_probes(options_.model.sigma_m, window_.size());
  std::vector<Pose2> poses;
  for (const PoseHypothesis& found : search_.best_of(candidates, wanted, map_, coarse, fine, rng))
    poses.push_back(found.T_map_robot);
  return poses;
}

/// Looks over the map once more, whether another place fits what was heard since.
void GlobalLocalisation::confirm() {
  if (search_.done() && unconfirmed_m_ == 0.0) {
    believe(true);
    jumped_m_ = 0.0;
    return;
  }
  if (search_.done() && unconfirmed_m_ > next_look_m_) return;
  if (search_.done()) search_.begin(map_.floor_m2());
  const ReadingProbes fine = window_probes(options_.model.sigma_m, window_.size());
  if (fine.echoes() == 0) return;
  search_.step(map_, window_probes(options_.search.coarse_sigma_m, coarse_probes),
               window_probes(options_.model.sigma_m, fine_probes), filter_.rng());
  if (!search_.done()) return;
  challenge(fine);
  next_look_m_ = std::max(0.0, unconfirmed_m_ - look_every_m);
}

void GlobalLocalisation::challenge(const ReadingProbes& fine) {
  const std::vector<PoseCluster> clusters = belief();
  if (clusters.empty()) return;
  for (const PoseCluster& cluster : clusters) search_.add(cluster.T_map_robot);
  search_.judge(map_, window_probes(options_.model.sigma_m, quick_probes), fine, filter_.rng());
  const PoseCluster& best = clusters.front();
  const double exponent = options_.window_readings / static_cast<double>(fine.size());
  double best_log = -std::numeric_limits<double>::infinity();
  for (const PoseHypothesis& h : search_.hypotheses())
    if (same_place(h.T_map_robot, best.T_map_robot)) best_log = std::max(best_log, h.log_likelihood);
  std::vector<Particle> poses(filter_.particles().begin(), filter_.particles().end());
  const std::size_t before = poses.size();
  for (const PoseHypothesis& h : search_.hypotheses()) {
    const double log_ratio = exponent * (h.log_likelihood - best_log);
    if (log_ratio > options_.challenge && !same_place(h.T_map_robot, best.T_map_robot))
      poses.push_back({h.T_map_robot, 0.0});
  }
  if (poses.size() == before) return;
  // Together they weigh as much as all others: what comes next shall decide.
  for (std::size_t n = before; n < poses.size(); ++n)
    poses[n].weight = 1.0 / static_cast<double>(poses.size() - before);
  filter_.start_around(poses, 0.5 * around_m, 0.5 * around);
  unconfirmed_m_ = confirm_way_m();
}

void GlobalLocalisation::correct_heading(Angle seen_by_robot, Angle on_map, Angle deviation) {
  if (!is_finite(seen_by_robot) || !is_finite(on_map) || !(deviation.rad() > 0.0) || !T_odom_robot_) return;
  // The particles are where the robot was at the last step.
  const Angle turned = T_odom_robot_->heading - T_odom_step_.heading;
  filter_.weigh_direction(seen_by_robot + turned, on_map, deviation);
}

}  // namespace echoarc::nav
