// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <bit>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/particle_filter.hpp"
#include "localise_ray_world.hpp"

namespace echoarc::nav {
namespace {

using testing::grid_of;
using testing::odd_room;
using testing::Wanderer;

double weight_sum(const ParticleFilter& filter) {
  double sum = 0.0;
  for (const Particle& particle : filter.particles()) sum += particle.weight;
  return sum;
}

ReadingProbes heard(const LikelihoodMap& map, Wanderer& robot) {
  ReadingProbes probes(map, {});
  for (const Reading& reading : robot.listen()) probes.add(reading, robot.T_odom_robot());
  return probes;
}

TEST(KldBound, WorkedNumbers) {
  // (k-1)/(2 e) (1 - 2/(9(k-1)) + sqrt(2/(9(k-1))) z)^3 with e = 0.05, z = 2.33.
  EXPECT_EQ(kld_bound(0, 0.05, 2.33), 1U);
  EXPECT_EQ(kld_bound(1, 0.05, 2.33), 1U);
  EXPECT_EQ(kld_bound(2, 0.05, 2.33), 67U);        // 10 * 1.876152^3
  EXPECT_EQ(kld_bound(101, 0.05, 2.33), 1359U);    // 1000 * 1.107615^3
  EXPECT_EQ(kld_bound(1001, 0.05, 2.33), 11072U);  // 10000 * 1.034511^3
}

RC_GTEST_PROP(LowVarianceDraws, EveryIndexIsDrawnAsOftenAsItsWeightSays, ()) {
  const auto raw = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 100)));
  const int sum = std::accumulate(raw.begin(), raw.end(), 0);
  RC_PRE(sum > 0);
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(1, 300));
  const double uniform = *rc::gen::inRange(0, 1000) / 1000.0;
  std::vector<Particle> particles(raw.size());
  for (std::size_t n = 0; n < raw.size(); ++n) particles[n].weight = static_cast<double>(raw[n]) / sum;
  std::vector<double> times(raw.size());
  const auto drawn = low_variance_draws(particles, count, uniform);
  RC_ASSERT(drawn.size() == count);
  for (const std::size_t n : drawn) times[n] += 1.0;
  for (std::size_t n = 0; n < raw.size(); ++n)
    RC_ASSERT(std::abs(times[n] - static_cast<double>(count) * particles[n].weight) < 1.0 + 1e-6);
}

TEST(LowVarianceDraws, AreUnbiased) {
  std::vector<Particle> particles(5);
  const std::vector<double> weights = {0.07, 0.23, 0.0, 0.37, 0.33};
  for (std::size_t n = 0; n < 5; ++n) particles[n].weight = weights[n];
  std::vector<double> times(5);
  constexpr int rounds = 1000;
  for (int k = 0; k < rounds; ++k)
    for (const std::size_t n : low_variance_draws(particles, 7, (k + 0.5) / rounds)) times[n] += 1.0;
  for (std::size_t n = 0; n < 5; ++n) EXPECT_NEAR(times[n] / rounds, 7.0 * weights[n], 2e-3);
}

TEST(ParticleFilter, WeightsSumToOneWhateverHappens) {
  const LikelihoodMap map(grid_of(odd_room()));
  ParticleFilter filter({}, {}, 5);
  Wanderer robot(odd_room(), {{0.7, 0.7}, {}}, 5);
  filter.start_at(robot.T_world_robot(), 0.3, degrees(20.0));
  EXPECT_NEAR(weight_sum(filter), 1.0, 1e-12);
  for (int n = 0; n < 15; ++n) {
    robot.step({{0.1, 0.0}, degrees(3.0)});
    filter.move({{0.1, 0.0}, degrees(3.0)});
    const double fit = filter.weigh(map, heard(map, robot));
    EXPECT_GT(fit, 0.0);
    EXPECT_LE(fit, 1.0);
    EXPECT_NEAR(weight_sum(filter), 1.0, 1e-12);
    filter.weigh_direction({}, {}, degrees(3.0));
    EXPECT_NEAR(weight_sum(filter), 1.0, 1e-12);
    const std::vector<Pose2> newcomers(n % 3 == 0 ? 20 : 0, robot.T_world_robot());
    filter.resample(newcomers);
    EXPECT_NEAR(weight_sum(filter), 1.0, 1e-12);
    EXPECT_GE(filter.particles().size(), 500U);
  }
}

TEST(ParticleFilter, OneSeedGivesTheSameParticlesBitForBit) {
  const LikelihoodMap map(grid_of(odd_room()));
  const auto run = [&](std::uint64_t seed) {
    ParticleFilter filter({.max_particles = 3000}, {}, seed);
    Wanderer robot(odd_room(), {{0.7, 0.7}, {}}, 5);
    filter.start_anywhere(map);
    for (int n = 0; n < 5; ++n) {
      robot.step({{0.1, 0.0}, {}});
      filter.move({{0.1, 0.0}, {}});
      filter.weigh(map, heard(map, robot));
      filter.resample();
    }
    std::vector<std::uint64_t> bits;
    for (const Particle& p : filter.particles())
      for (const double x : {p.T_map_robot.position.x, p.T_map_robot.position.y, p.T_map_robot.heading.rad(), p.weight})
        bits.push_back(std::bit_cast<std::uint64_t>(x));
    return bits;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(ParticleFilter, DrawsAnewWhenFewCarryTheWeight) {
  ParticleFilter filter({}, {}, 1);
  EXPECT_FALSE(filter.resample());
  filter.start_at({}, 0.1, degrees(50.0));
  EXPECT_NEAR(filter.effective_count(), 500.0, 1e-6);
  EXPECT_FALSE(filter.resample());
  filter.weigh_direction({}, {}, degrees(5.0));
  EXPECT_LT(filter.effective_count(), 250.0);
  EXPECT_TRUE(filter.resample());
  EXPECT_NEAR(filter.effective_count(), static_cast<double>(filter.particles().size()), 1e-6);
}

TEST(ParticleFilter, TheNumberOfParticlesFollowsTheirSpread) {
  const LikelihoodMap map(grid_of(odd_room()));
  ParticleFilter filter({}, {}, 1);
  filter.start_anywhere(map);
  EXPECT_EQ(filter.particles().size(), 50'000U);
  std::vector<Particle> places(filter.particles().begin(), filter.particles().begin() + 2000);
  filter.start_around(places, 0.0, {});
  const std::size_t wide = filter.particles().size();
  EXPECT_GT(wide, 5'000U);
  places.resize(2);
  filter.start_around(places, 0.02, degrees(1.0));
  EXPECT_EQ(filter.particles().size(), 500U);
  filter.start_around({}, 0.02, degrees(1.0));
  EXPECT_EQ(filter.particles().size(), 500U);
}

TEST(ParticleFilter, APoseInAWallOrOffTheMapCountsLittle) {
  const LikelihoodMap map(grid_of(odd_room()));
  ParticleFilter filter({.particles = 10}, {}, 1);
  const std::vector<Particle> places = {{{{1.0, 1.0}, {}}, 0.5}, {{{-3.0, 1.0}, {}}, 0.5}};
  filter.start_around(places, 0.0, {});
  ReadingProbes silence(map, {});
  Reading reading;
  reading.trusted_range_m = 0.2;
  ASSERT_TRUE(silence.add(reading, {}));
  filter.weigh(map, silence);
  double on_floor = 0.0;
  for (const Particle& p : filter.particles())
    if (p.T_map_robot.position.x > 0.0) on_floor += p.weight;
  // Half of an even and as good as half of an odd number of particles were there: 1 against 0.1.
  EXPECT_NEAR(on_floor, 1.0 / 1.1, 0.01);
}

TEST(ParticleFilter, MovesAsTheStepAndItsNoiseSay) {
  const MotionNoiseOptions noise{.step_noise_share = 0.1,
                                 .place_noise_m_per_sqrt_m = 0.0,
                                 .heading_noise_per_sqrt_m = degrees(2.0),
                                 .turn_noise_share = 0.0};
  ParticleFilter filter({.particles = 20'000}, noise, 3);
  filter.start_at({{1.0, 2.0}, degrees(90.0)}, 0.0, {});
  filter.move({{4.0, 0.0}, degrees(10.0)});
  const PoseCluster cloud = moments_of(filter.particles());
  EXPECT_NEAR(cloud.T_map_robot.position.x, 1.0, 1e-9);
  EXPECT_NEAR(cloud.T_map_robot.position.y, 6.0, 0.02);
  EXPECT_NEAR(cloud.T_map_robot.heading.deg(), 100.0, 0.2);
  EXPECT_NEAR(std::sqrt(cloud.covariance.yy_m2), 0.4, 0.01);
  EXPECT_NEAR(radians(std::sqrt(cloud.covariance.heading_rad2)).deg(), 4.0, 0.1);
}

TEST(StepDeviation, WorkedNumbers) {
  const StepDeviation deviation = step_deviation({}, {{4.0, 0.0}, degrees(50.0)});
  EXPECT_NEAR(deviation.along_m, std::hypot(0.08, 0.04), 1e-12);
  EXPECT_NEAR(deviation.across_m, 0.04, 1e-12);
  EXPECT_NEAR(deviation.heading.deg(), std::hypot(2.0, 2.0), 1e-12);
  const StepDeviation none = step_deviation({}, {});
  EXPECT_EQ(none.along_m + none.across_m + none.heading.rad(), 0.0);
}

TEST(Moments, HeadingsAreAveragedAcrossTheCut) {
  const std::vector<Particle> particles = {{{{0.0, 0.0}, degrees(170.0)}, 0.5}, {{{2.0, 0.0}, degrees(-170.0)}, 1.5}};
  const PoseCluster mean = moments_of(particles);
  EXPECT_NEAR(mean.share, 2.0, 1e-12);
  EXPECT_NEAR(mean.T_map_robot.position.x, 1.5, 1e-12);
  EXPECT_NEAR(mean.covariance.xx_m2, 0.75, 1e-12);
  EXPECT_NEAR(wrap(mean.T_map_robot.heading).deg(), -175.0, 0.1);
  EXPECT_EQ(moments_of({}).share, 0.0);
}

TEST(Spread, HasTheAxesOfTheEllipse) {
  PoseCluster cluster;
  // Deviations 2 m along 30 degrees and 1 m across.
  cluster.covariance = {.xx_m2 = 3.25, .xy_m2 = 0.75 * std::sqrt(3.0), .yy_m2 = 1.75};
  const Sketch::Spread spread = spread_of(cluster);
  EXPECT_NEAR(spread.T_world_axes.heading.deg(), 30.0, 1e-9);
  EXPECT_NEAR(spread.deviation_m.x, 2.0, 1e-9);
  EXPECT_NEAR(spread.deviation_m.y, 1.0, 1e-9);
}

TEST(Clusters, HoldWhatLiesTogetherByFallingShare) {
  std::vector<Particle> particles;
  for (int n = 0; n < 10; ++n) particles.push_back({{{0.3 * n, 0.0}, degrees(175.0 + n)}, 0.06});
  for (int n = 0; n < 10; ++n) particles.push_back({{{0.3 * n, 0.0}, degrees(0.0)}, 0.03});
  particles.push_back({{{9.0, 9.0}, {}}, 0.1});
  particles.push_back({{{-9.0, 9.0}, {}}, 1e-5});
  const std::vector<PoseCluster> clusters = clusters_of(particles, 0.5, degrees(15.0), 1e-3);
  ASSERT_EQ(clusters.size(), 3U);
  EXPECT_NEAR(clusters[0].share, 0.6, 1e-12);
  EXPECT_NEAR(clusters[0].T_map_robot.position.x, 1.35, 1e-12);
  EXPECT_NEAR(clusters[1].share, 0.3, 1e-12);
  EXPECT_NEAR(clusters[2].share, 0.1, 1e-12);
  EXPECT_TRUE(clusters_of({}, 0.5, degrees(15.0), 1e-3).empty());
}

}  // namespace
}  // namespace echoarc::nav
