// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/particle_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "nav/pose_bins.hpp"

namespace echoarc::nav {

std::size_t kld_bound(std::size_t bins, double error, double quantile) {
  if (bins < 2) return 1;
  const double k = static_cast<double>(bins) - 1.0;
  const double a = 2.0 / (9.0 * k);  // Wilson and Hilferty's approximation of the chi-square quantile
  const double root = 1.0 - a + std::sqrt(a) * quantile;
  return static_cast<std::size_t>(std::ceil(k / (2.0 * error) * root * root * root));
}

std::vector<std::size_t> low_variance_draws(std::span<const Particle> weights, std::size_t count, double uniform) {
  assert(!weights.empty());
  std::vector<std::size_t> drawn;
  drawn.reserve(count);
  double cumulated = weights[0].weight;
  std::size_t i = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double u = (static_cast<double>(n) + uniform) / static_cast<double>(count);
    while (u >= cumulated && i + 1 < weights.size()) cumulated += weights[++i].weight;
    drawn.push_back(i);
  }
  return drawn;
}

ParticleFilter::ParticleFilter(const ParticleFilterOptions& options, const MotionNoiseOptions& noise,
                               std::uint64_t seed)
    : options_(options), noise_(noise), fewest_(options.particles), rng_(seed) {
  options_.max_particles = std::max(options_.max_particles, options_.particles);
}

void ParticleFilter::start_at(const Pose2& T_map_robot, double deviation_m, Angle deviation) {
  particles_.clear();
  for (int n = 0; n < options_.particles; ++n) particles_.push_back({near(T_map_robot, deviation_m, deviation), 1.0});
  normalise();
}

void ParticleFilter::start_anywhere(const LikelihoodMap& map) {
  particles_.clear();
  for (int n = 0; n < options_.max_particles; ++n) {
    const Vec2 place = map.any_place(rng_);
    particles_.push_back({{place, degrees(rng_.uniform(-180.0, 180.0))}, 1.0});
  }
  normalise();
}

void ParticleFilter::start_around(std::span<const Particle> poses, double deviation_m, Angle deviation) {
  if (poses.empty()) return;
  particles_.assign(poses.begin(), poses.end());
  normalise();
  const double uniform = rng_.uniform();
  std::vector<Particle> drawn;
  for (const std::size_t n : low_variance_draws(particles_, wanted_count(uniform), uniform))
    drawn.push_back({near(particles_[n].T_map_robot, deviation_m, deviation), 1.0});
  particles_ = std::move(drawn);
  normalise();
}

Pose2 ParticleFilter::near(const Pose2& T_map_robot, double deviation_m, Angle deviation) {
  const double x = rng_.normal(T_map_robot.position.x, deviation_m);
  const double y = rng_.normal(T_map_robot.position.y, deviation_m);
  return {{x, y}, wrap(radians(rng_.normal(T_map_robot.heading.rad(), deviation.rad())))};
}

void ParticleFilter::move(const Pose2& T_before_now) {
  const StepDeviation deviation = step_deviation(noise_, T_before_now);
  for (Particle& particle : particles_) {
    particle.T_map_robot = particle.T_map_robot * sample_step(deviation, T_before_now, rng_);
    particle.T_map_robot.heading = wrap(particle.T_map_robot.heading);
  }
}

double ParticleFilter::weigh(const LikelihoodMap& map, const ReadingProbes& probes, double exponent) {
  if (particles_.empty() || probes.size() == 0) return 0.0;
  std::vector<ReadingFit> fits;
  fits.reserve(particles_.size());
  double best = -std::numeric_limits<double>::infinity();
  const double off_floor = std::log(options_.off_floor_factor);
  for (const Particle& particle : particles_) {
    ReadingFit fit = probes.fit(particle.T_map_robot);
    fit.log_likelihood *= exponent;
    if (!map.may_stand(particle.T_map_robot.position)) fit.log_likelihood += off_floor;
    best = std::max(best, fit.log_likelihood);
    fits.push_back(fit);
  }
  for (std::size_t n = 0; n < fits.size(); ++n) particles_[n].weight *= std::exp(fits[n].log_likelihood - best);
  normalise();
  double mean = 0.0;
  for (std::size_t n = 0; n < fits.size(); ++n) mean += particles_[n].weight * fits[n].mean_echo;
  return mean;
}

void ParticleFilter::weigh_direction(Angle robot, Angle on_map, Angle deviation) {
  for (Particle& particle : particles_) {
    const double turns = (particle.T_map_robot.heading + robot - on_map) / degrees(90.0);
    const double sigmas = degrees(90.0 * std::remainder(turns, 1.0)) / deviation;
    particle.weight *= std::exp(-0.5 * sigmas * sigmas) + 1e-3;  // the line may be no wall of the map at all
  }
  normalise();
}

double ParticleFilter::effective_count() const {
  double squares = 0.0;
  for (const Particle& particle : particles_) squares += particle.weight * particle.weight;
  return squares > 0.0 ? 1.0 / squares : 0.0;
}

std::size_t ParticleFilter::wanted_count(double uniform) const {
  std::vector<PoseBin> bins;
  for (const std::size_t n : low_variance_draws(particles_, particles_.size(), uniform))
    bins.push_back(bin_of(particles_[n].T_map_robot, options_.bin_m, options_.bin_turn));
  std::sort(bins.begin(), bins.end());
  const auto occupied = static_cast<std::size_t>(std::unique(bins.begin(), bins.end()) - bins.begin());
  return std::clamp(kld_bound(occupied, options_.kld_error, options_.kld_quantile), static_cast<std::size_t>(fewest_),
                    static_cast<std::size_t>(options_.max_particles));
}

bool ParticleFilter::resample(std::span<const Pose2> newcomers) {
  const auto count = static_cast<double>(particles_.size());
  if (particles_.empty()) return false;
  if (newcomers.empty() && effective_count() >= options_.resample_below * count) return false;
  const double uniform = rng_.uniform();
  const std::size_t wanted = wanted_count(uniform);
  const std::size_t strangers = std::min(newcomers.size(), wanted);
  std::vector<Particle> drawn;
  drawn.reserve(wanted);
  for (const std::size_t n : low_variance_draws(particles_, wanted - strangers, uniform))
    drawn.push_back({particles_[n].T_map_robot, 1.0});
  for (const Pose2& T_map_robot : newcomers.first(strangers)) drawn.push_back({T_map_robot, 1.0});
  particles_ = std::move(drawn);
  normalise();
  return true;
}

void ParticleFilter::normalise() {
  double sum = 0.0;
  for (const Particle& particle : particles_) sum += particle.weight;
  // Weights so small that their sum is none tell nothing: all alike again.
  const bool useless = !(sum > 0.0) || !std::isfinite(sum);
  for (Particle& particle : particles_)
    particle.weight = useless ? 1.0 / static_cast<double>(particles_.size()) : particle.weight / sum;
}

}  // namespace echoarc::nav
