// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/local_maps.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

// A sonar that looks at a post from a straight drive past it, 0.05 m apart: its arcs cross in the post.
std::vector<Reading> drive_past_a_post() {
  const Vec2 post{0.5, 1.0};
  std::vector<Reading> readings;
  for (int k = 0; k <= 20; ++k) {
    Reading reading;
    reading.ping = PingId(k);
    reading.time_s = 0.1 * k;
    reading.T_world_robot = {{0.05 * k, 0.0}, radians(0.0)};
    reading.T_world_tx = {reading.T_world_robot.position, bearing(post - reading.T_world_robot.position)};
    reading.T_world_rx = reading.T_world_tx;
    reading.outcome = Echo{norm(post - reading.T_world_robot.position)};
    readings.push_back(reading);
  }
  return readings;
}

TEST(LocalMaps, EveryViewOfTheSameEchoes) {
  const std::vector<Reading> readings = drive_past_a_post();
  LocalMapper mapper({.min_neighbours = 0});
  mapper.insert(readings);
  const LocalMaps maps = mapper.maps();
  EXPECT_EQ(maps.centerline.size(), readings.size());
  EXPECT_FALSE(maps.atm.empty());
  EXPECT_EQ(maps.atm_centerline.size(), readings.size());
  EXPECT_FALSE(maps.carved.empty());
  EXPECT_GE(maps.carved_centerline.size(), maps.carved.size());
  for (const MapPoint& point : maps.atm) EXPECT_NEAR(norm(point.position - Vec2{0.5, 1.0}), 0.0, 1e-6);
  for (const MapPoint& point : maps.atm_carved) EXPECT_NE(point.label, PointLabel::centerline);
}

TEST(LocalMaps, LonelyPointsAreLeftOut) {
  std::vector<Reading> readings = drive_past_a_post();
  readings.back().outcome = Echo{3.0};
  LocalMapper mapper;
  mapper.insert(readings);
  EXPECT_EQ(mapper.maps().centerline.size(), readings.size() - 1);
}

TEST(LocalMaps, LooksAfterEveryStep) {
  const std::vector<Reading> readings = drive_past_a_post();
  LocalMapper mapper;
  std::vector<double> places;
  look_along(readings, 0.249, mapper, [&](const Reading& r) { places.push_back(r.T_world_robot.position.x); });
  ASSERT_EQ(places.size(), 4U);
  EXPECT_NEAR(places[0], 0.25, 1e-12);
  EXPECT_NEAR(places[3], 1.0, 1e-12);
}

}  // namespace
}  // namespace echoarc::studies
