// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/nav/likelihood_map.hpp"
#include "echoarc/nav/motion_noise.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

struct Particle {
  Pose2 T_map_robot;
  double weight = 0.0;  ///< in [0, 1]; those of all particles sum to one
};

/// Symmetric; headings in rad.
struct PoseCovariance {
  double xx_m2 = 0.0;
  double xy_m2 = 0.0;
  double yy_m2 = 0.0;
  double x_heading_m = 0.0;
  double y_heading_m = 0.0;
  double heading_rad2 = 0.0;
};

/// Particles that lie together: neighbours of neighbours in bins of place and heading.
struct PoseCluster {
  double share = 0.0;  ///< of all weight
  Pose2 T_map_robot;   ///< mean
  PoseCovariance covariance;
};

/// The two axes of the place's ellipse of one standard deviation; x is the longer one.
[[nodiscard]] Sketch::Spread spread_of(const PoseCluster& cluster);

/// Mean and covariance of weighted poses; headings by the mean direction. The weights need not sum to one.
[[nodiscard]] PoseCluster moments_of(std::span<const Particle> particles);

/// Clusters by falling share. Bins are cubes of `bin_m` by `bin_m` by `bin_turn`; those that hold less than
/// `least_share` of the weight belong to no cluster.
[[nodiscard]] std::vector<PoseCluster> clusters_of(std::span<const Particle> particles, double bin_m, Angle bin_turn,
                                                   double least_share);

/// So many particles are enough for `bins` occupied bins: with the probability whose upper normal quantile is
/// `quantile`, the Kullback-Leibler distance to the true distribution stays below `error` (Fox 2003, eq. 7).
[[nodiscard]] std::size_t kld_bound(std::size_t bins, double error, double quantile);

/// Indices of `count` draws from `weights` (which sum to one) by one uniform number in [0, 1): low-variance resampling
/// (Thrun, Burgard and Fox, table 4.4). Index i is drawn floor(count w_i) or ceil(count w_i) times.
[[nodiscard]] std::vector<std::size_t> low_variance_draws(std::span<const Particle> weights, std::size_t count,
                                                          double uniform);

struct ParticleFilterOptions {
  int particles = 500;
  int max_particles = 50'000;
  double dependence_exponent = 0.3;
  double resample_below = 0.5;
  double kld_error = 0.05;
  double kld_quantile = 2.33;
  double bin_m = 0.2;
  Angle bin_turn = degrees(10.0);
  double off_floor_factor = 0.1;

  static constexpr auto fields() {
    using O = ParticleFilterOptions;
    return std::tuple{
        field("particles", &O::particles, {.min = 10, .max = 1e6, .doc = "the fewest: those that track a known pose"}),
        field("max_particles", &O::max_particles,
              {.min = 10, .max = 1e6, .doc = "the most, while the pose is unknown"}),
        field("dependence_exponent", &O::dependence_exponent,
              {.min = 0.01,
               .max = 1.0,
               .doc = "power to which the product of a step's readings is taken: they are not independent"}),
        field("resample_below", &O::resample_below,
              {.min = 0.0, .max = 1.0, .doc = "draw anew when the effective number is less than this share of all"}),
        field("kld_error", &O::kld_error,
              {.min = 0.001, .max = 1.0, .doc = "bound of the Kullback-Leibler distance", .source = "Fox 2003"}),
        field("kld_quantile", &O::kld_quantile,
              {.min = 0.0, .max = 10.0, .doc = "normal quantile with which it holds: 2.33 for 99 %"}),
        field("bin_m", &O::bin_m, {.unit = "m", .min = 0.01, .max = 100.0, .doc = "side of the bins of places"}),
        field("bin_turn_deg", &O::bin_turn,
              {.unit = "deg", .min = 1.0, .max = 120.0, .doc = "width of the bins of headings"}),
        field("off_floor_factor", &O::off_floor_factor,
              {.min = 1e-6, .max = 1.0, .doc = "a pose within a wall or off the map counts so much, at every step"})};
  }
};

/// Monte Carlo localisation (Fox, Burgard, Dellaert and Thrun 1999) with sonar arcs on a likelihood field and an
/// adaptive number of particles (Fox 2003). One seed gives the same particles, bit for bit.
class ParticleFilter {
 public:
  ParticleFilter(const ParticleFilterOptions& options, const MotionNoiseOptions& noise, std::uint64_t seed);

  /// `options.particles` around a pose, normally distributed.
  void start_at(const Pose2& T_map_robot, double deviation_m, Angle deviation);
  /// `options.max_particles` on any free place with any heading. Requires `map.has_floor()`.
  void start_anywhere(const LikelihoodMap& map);
  void clear() { particles_.clear(); }
  /// As many as the bins of these poses need, drawn by their weights (which need not sum to one), each displaced at
  /// random. Nothing happens without poses.
  void start_around(std::span<const Particle> poses, double deviation_m, Angle deviation);

  /// Every particle makes a step that may have been the one that odometry measured.
  void move(const Pose2& T_before_now);
  /// Multiplies the weights by the readings' likelihoods. Returns the mean over the particles of `mean_echo`, by their
  /// new weights; 0 without echoes.
  double weigh(const LikelihoodMap& map, const ReadingProbes& probes) {
    return weigh(map, probes, options_.dependence_exponent);
  }
  /// The same with another power in place of `options.dependence_exponent`.
  double weigh(const LikelihoodMap& map, const ReadingProbes& probes, double exponent);
  /// Multiplies the weights by that of a direction which is known modulo a quarter turn: `robot` as seen from the
  /// robot, `on_map` on the map, standard deviation `deviation`.
  void weigh_direction(Angle robot, Angle on_map, Angle deviation);
  /// From the next draw on, so many instead of `options.particles`.
  void keep_at_least(int particles) { fewest_ = std::min(particles, options_.max_particles); }
  /// Draws anew if too few particles carry the weight; says whether it did. The last ones of the new set are
  /// `newcomers`.
  bool resample(std::span<const Pose2> newcomers = {});

  [[nodiscard]] std::span<const Particle> particles() const { return particles_; }
  /// 1 / sum of squared weights.
  [[nodiscard]] double effective_count() const;
  [[nodiscard]] const ParticleFilterOptions& options() const { return options_; }
  [[nodiscard]] Rng& rng() { return rng_; }

 private:
  [[nodiscard]] Pose2 near(const Pose2& T_map_robot, double deviation_m, Angle deviation);
  void normalise();
  [[nodiscard]] std::size_t wanted_count(double uniform) const;

  ParticleFilterOptions options_;
  MotionNoiseOptions noise_;
  int fewest_;
  Rng rng_;
  std::vector<Particle> particles_;
};

}  // namespace echoarc::nav
