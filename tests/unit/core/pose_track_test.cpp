// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/pose_track.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <variant>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Odometry odometry_at(double time_s, double x_m = 0.0, Angle heading = {}) {
  return {time_s, {{x_m, 0.0}, heading}, 0};
}

Pose2 pose_at(const PoseTrack& track, double time_s) {
  return std::get<Pose2>(track.at(time_s));
}

TEST(PoseTrack, InterpolatesOnTheLineAndByTheShortestTurn) {
  PoseTrack track(1.0, 3600.0);
  ASSERT_FALSE(track.push(odometry_at(10.0, 1.0, degrees(170))));
  ASSERT_FALSE(track.push(odometry_at(10.5, 2.0, degrees(-170))));
  EXPECT_NEAR(pose_at(track, 10.25).position.x, 1.5, 1e-12);
  EXPECT_NEAR(wrap(pose_at(track, 10.25).heading).deg(), 180.0, 1e-9) << "20 degrees across the back, not 340";
  EXPECT_NEAR(wrap(pose_at(track, 10.4).heading).deg(), -174.0, 1e-9);
}

TEST(PoseTrack, TheEndsThemselvesAreInside) {
  PoseTrack track(1.0, 3600.0);
  EXPECT_EQ(std::get<PoseTrack::Missing>(track.at(0.0)), PoseTrack::Missing::outside);
  ASSERT_FALSE(track.push(odometry_at(1.0, 5.0)));
  EXPECT_EQ(pose_at(track, 1.0).position.x, 5.0) << "a single sample is enough at its own time";
  ASSERT_FALSE(track.push(odometry_at(2.0, 6.0)));
  EXPECT_EQ(pose_at(track, 1.0).position.x, 5.0);
  EXPECT_EQ(pose_at(track, 2.0).position.x, 6.0);
  EXPECT_EQ(std::get<PoseTrack::Missing>(track.at(std::nextafter(1.0, 0.0))), PoseTrack::Missing::outside);
  EXPECT_EQ(std::get<PoseTrack::Missing>(track.at(std::nextafter(2.0, 3.0))), PoseTrack::Missing::outside);
}

TEST(PoseTrack, GapsAreNotBridged) {
  PoseTrack track(1.0, 3600.0);
  for (const double t : {0.0, 1.0, 2.5, 3.0}) ASSERT_FALSE(track.push(odometry_at(t, t)));
  EXPECT_NEAR(pose_at(track, 0.5).position.x, 0.5, 1e-12) << "the limit itself is fine";
  EXPECT_EQ(std::get<PoseTrack::Missing>(track.at(1.5)), PoseTrack::Missing::gap);
  EXPECT_EQ(pose_at(track, 2.5).position.x, 2.5);
  EXPECT_EQ(std::get<PoseTrack::Missing>(track.at(nan)), PoseTrack::Missing::outside);
}

TEST(PoseTrack, RefusesWhatCannotBeUsed) {
  PoseTrack track(1.0, 3600.0);
  ASSERT_FALSE(track.push(odometry_at(1.0)));
  EXPECT_EQ(track.push(odometry_at(nan)), PoseTrack::Refusal::bad_time);
  EXPECT_EQ(track.push(odometry_at(infinity)), PoseTrack::Refusal::bad_time);
  EXPECT_EQ(track.push(odometry_at(1e9)), PoseTrack::Refusal::bad_time) << "a wild stamp must not lock out the rest";
  EXPECT_EQ(track.push(odometry_at(0.9)), PoseTrack::Refusal::backwards);
  EXPECT_EQ(track.push(odometry_at(1.0)), PoseTrack::Refusal::duplicate);
  EXPECT_EQ(track.push(odometry_at(2.0, nan)), PoseTrack::Refusal::bad_pose);
  EXPECT_EQ(track.push(odometry_at(2.0, 1e300)), PoseTrack::Refusal::bad_pose);
  EXPECT_EQ(track.push(odometry_at(2.0, 0.0, radians(infinity))), PoseTrack::Refusal::bad_pose);
  EXPECT_EQ(track.push(odometry_at(2.0)), std::nullopt);
  EXPECT_EQ(track.samples().size(), 2U);
}

/// Obvious twin of `PoseTrack::at`: looks at every pair of neighbours.
std::optional<Pose2> slow_pose(std::span<const Odometry> samples, double time_s) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].time_s == time_s) return samples[i].T_world_robot;
    if (i + 1 < samples.size() && samples[i].time_s < time_s && time_s < samples[i + 1].time_s)
      return interpolate(samples[i].T_world_robot, samples[i + 1].T_world_robot,
                         (time_s - samples[i].time_s) / (samples[i + 1].time_s - samples[i].time_s));
  }
  return std::nullopt;
}

RC_GTEST_PROP(PoseTrack, EqualsTheSlowSearch, (std::uint64_t seed)) {
  Rng rng(seed);
  PoseTrack track(10.0, 3600.0);
  double time_s = rng.uniform(-5, 5);
  for (std::uint64_t k = rng.below(12); k > 0; --k) {
    RC_ASSERT(!track.push(odometry_at(time_s, rng.uniform(-3, 3), radians(rng.uniform(-7, 7)))));
    time_s += rng.uniform(0.1, 2.0);
  }
  for (int k = 0; k < 50; ++k) {
    const bool on_sample = k % 5 == 0 && !track.empty();
    const double at_s = on_sample ? track.samples()[rng.below(track.samples().size())].time_s : rng.uniform(-6, 30);
    const auto slow = slow_pose(track.samples(), at_s);
    const auto fast = track.at(at_s);
    RC_ASSERT(slow.has_value() == std::holds_alternative<Pose2>(fast));
    if (slow) RC_ASSERT(*slow == std::get<Pose2>(fast));
  }
}

}  // namespace
}  // namespace echoarc
