// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "echoarc/nav/likelihood_map.hpp"

namespace echoarc::nav {
namespace {

constexpr int max_samples = 512;  // of one arc: wider spacing beyond
constexpr double far_sigmas = 4.0;

bool usable(const Reading& reading) {
  return is_finite(reading.T_world_tx) && is_finite(reading.T_world_rx) && reading.beam_width.rad() > 0.0 &&
         reading.beam_width < degrees(180.0);
}

}  // namespace

ReadingProbes::ReadingProbes(const LikelihoodMap& map, const ReadingModelOptions& options)
    : map_(&map),
      options_(options),
      log_through_wall_(std::log(options.through_wall_factor)),
      log_silent_wall_(std::log(options.silent_wall_factor)),
      start_level_(static_cast<int>(
          std::min(LikelihoodMap::cap_level * 1.0, std::ceil(far_sigmas * options.sigma_m / LikelihoodMap::step_m)))),
      slack_level_(static_cast<int>(std::min(1e6, std::ceil(1.4143 * map.cell_m() / LikelihoodMap::step_m))) + 1) {
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const double sigmas = static_cast<double>(k) * LikelihoodMap::step_m / options.sigma_m;
    weights_[k] = options.hit_share * std::exp(-0.5 * sigmas * sigmas) + options.random_share;
    log_weights_[k] = std::log(weights_[k]);
  }
}

bool ReadingProbes::add(const Reading& reading, const Pose2& T_world_now) {
  if (!usable(reading) || !is_finite(T_world_now)) return false;
  const Pose2 T_now_world = inverse(T_world_now);
  if (is_no_echo(reading.outcome)) {
    const double reach_m = std::min({reading.trusted_range_m, reading.range_max_m, options_.range_max_m});
    return add_axis({}, T_now_world * reading.T_world_tx, reach_m);
  }
  const double range_m = echo_range_m(reading.outcome).value_or(0.0);
  if (!(range_m > eps_length_m && range_m <= options_.range_max_m)) return false;
  const std::optional<Arc> arc = arc_of(reading);
  if (!arc) return false;

  Probe probe;
  probe.begin = samples_.size();
  const double length_m = arc->length_m();
  const int pieces = std::clamp(static_cast<int>(std::ceil(length_m / options_.spacing_m)), 1, max_samples);
  const double cell_m = map_->cell_m();
  for (int k = 0; k <= pieces; ++k) {
    const Angle t = arc->t_begin() + (static_cast<double>(k) / pieces) * (arc->t_end() - arc->t_begin());
    const Vec2 p = T_now_world * arc->point_at(t);
    samples_.push_back({static_cast<float>(p.x / cell_m), static_cast<float>(p.y / cell_m)});
  }
  probe.end = samples_.size();
  // The bearing steps are equal, those along an ellipse are not quite: half as long again holds for every arc in use.
  const double step_m = (arc->is_circular() ? 1.0 : 1.5) * length_m / pieces;
  probe.skip_per_level = static_cast<float>(LikelihoodMap::step_m / std::max(step_m, 1e-6));
  ++echoes_;
  const Vec2 middle = arc->midpoint();
  const double reach_m = norm(middle - arc->centre()) - options_.through_wall_margin_m;
  return add_axis(probe, T_now_world * Pose2{arc->centre(), bearing(middle - arc->centre())}, reach_m);
}

bool ReadingProbes::add_axis(Probe probe, const Pose2& T_now_eye, double reach_m) {
  const double cell_m = map_->cell_m();
  const Vec2 axis = unit(T_now_eye.heading);
  probe.eye = {static_cast<float>(T_now_eye.position.x / cell_m), static_cast<float>(T_now_eye.position.y / cell_m)};
  probe.axis = {static_cast<float>(axis.x), static_cast<float>(axis.y)};
  probe.reach = static_cast<float>(reach_m / cell_m);
  probes_.push_back(probe);
  return true;
}

int ReadingProbes::nearest_level(const Probe& probe, const Heading& robot) const {
  int least = start_level_;
  for (std::size_t k = probe.begin; k < probe.end; ++k) {
    const int here = map_->level(robot.place(samples_[k]));
    if (here < least) {
      least = here;
      if (least == 0) break;
      continue;
    }
    // Distances change along the arc no faster than the arc is long: samples that cannot be nearer are left out.
    const int spare = here - least - slack_level_;
    if (spare > 0) k += static_cast<std::size_t>(static_cast<float>(spare) * probe.skip_per_level);
  }
  return least;
}

bool ReadingProbes::wall_in_the_way(const Probe& probe, const Heading& robot) const {
  const LikelihoodMap::Place axis = {robot.c * probe.axis.i - robot.s * probe.axis.j,
                                     robot.s * probe.axis.i + robot.c * probe.axis.j};
  return map_->blocked(robot.place(probe.eye), axis.i, axis.j, probe.reach);
}

ReadingFit ReadingProbes::fit(const Pose2& T_map_robot) const {
  const Vec2 direction = unit(T_map_robot.heading);
  const Heading robot{map_->to_cells(T_map_robot.position), static_cast<float>(direction.x),
                      static_cast<float>(direction.y)};
  ReadingFit sum;
  for (const Probe& probe : probes_) {
    const bool through_wall = wall_in_the_way(probe, robot);
    if (probe.begin == probe.end) {
      sum.log_likelihood += through_wall ? log_silent_wall_ : 0.0;
      continue;
    }
    const auto level = static_cast<std::size_t>(nearest_level(probe, robot));
    sum.log_likelihood += log_weights_[level] + (through_wall ? log_through_wall_ : 0.0);
    sum.mean_echo += weights_[level] * (through_wall ? options_.through_wall_factor : 1.0);
  }
  if (echoes_ > 0) sum.mean_echo /= static_cast<double>(echoes_);
  return sum;
}

}  // namespace echoarc::nav
