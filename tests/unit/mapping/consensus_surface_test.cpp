// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Steps D and F of tangent consensus: what echoes say of places, and the zones that grow from them.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/consensus.hpp"
#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "mapping/consensus/surface_evidence.hpp"
#include "mapping/consensus/zones.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

/// One echo at 2 m straight ahead of a sensor at the origin, read out at `t` with p.
struct OneEcho {
  OneEcho(Angle t, double p, double wall_share = 0.95) {
    arcs.add({Arc::circular({}, Angle{}, 2.0, degrees(20.0)), {}, 0, degrees(20.0), 0});
    estimates.push_back({.t = t, .p = p, .bound_m = 0.05, .wall_share = wall_share, .evidence = 5.0});
    elements.push_back(element_of(arcs, 0, t));
  }
  [[nodiscard]] double evidence(Vec2 place) const {
    return surface_evidence(arcs, options, estimates, elements, std::vector{place}).front();
  }

  ConsensusOptions options;
  consensus::ArcTable arcs{options};
  std::vector<consensus::EchoEstimate> estimates;
  std::vector<consensus::Element> elements;
};

/// ln(.85/.15) = 1.7346 where it certainly came from; at one sigma of the band, 2 cm, p is .5 + .35 exp(-1/2); what it
/// passed loses ln(.75/.25) = 1.0986; 12 cm beside it at 2 m are 3.44 degrees.
TEST(ConsensusSurface, AnEchoSpeaksOfItsEndAndItsWay) {
  const OneEcho echo(degrees(5.0), 1.0);
  const auto at = [&](double range_m, double bearing_deg) {
    return echo.evidence(range_m * unit(degrees(bearing_deg)));
  };
  EXPECT_NEAR(at(2.0, 5.0), 1.7346, 1e-4);
  const double p = 0.5 + 0.35 * std::exp(-0.5);
  EXPECT_NEAR(at(2.02, 5.0), std::log(p / (1.0 - p)), 1e-9);
  EXPECT_NEAR(at(2.0, 8.4), 1.7346, 1e-4);
  EXPECT_NEAR(at(1.2, 5.0), -1.0986, 1e-4);
  EXPECT_NEAR(at(1.2, 8.4), -1.0986, 1e-4);
  for (const double beside : {8.5, 1.5, 0.0}) {
    EXPECT_EQ(at(2.0, beside), 0.0);
    EXPECT_EQ(at(1.2, beside), 0.0);
  }
  EXPECT_EQ(at(1.95, 5.0), 0.0) << "between the way and the end lies a margin";
  EXPECT_EQ(at(2.05, 5.0), 0.0);
  EXPECT_EQ(at(2.0, 185.0), 0.0);
  EXPECT_NEAR(OneEcho(Angle{}, 0.5).evidence({2.0, 0.0}), std::log(0.675 / 0.325), 1e-9) << "half as sure";
}

/// Foci a micrometre apart make an ellipse of the circle; both of its legs are looked at, and count once.
TEST(ConsensusSurface, BistaticEchoesSpeakOfTheSame) {
  const OneEcho circle(degrees(5.0), 0.9);
  OneEcho ellipse(degrees(5.0), 0.9);
  consensus::ArcTable arcs(ellipse.options);
  const Pose2 tx{{-5e-7, 0.0}, Angle{}};
  const Pose2 rx{{5e-7, 0.0}, Angle{}};
  arcs.add({Arc::elliptical(tx, rx, 2.0, degrees(20.0)).value(), {}, 0, degrees(20.0), 0});
  ASSERT_FALSE(arcs[0].arc.is_circular());
  std::vector<Vec2> places;
  Rng rng(2);
  for (int k = 0; k < 2000; ++k) places.push_back(Vec2{rng.uniform(-0.2, 2.2), rng.uniform(-0.5, 0.5)});
  const auto expected = surface_evidence(circle.arcs, circle.options, circle.estimates, circle.elements, places);
  const auto found = surface_evidence(arcs, circle.options, circle.estimates, circle.elements, places);
  int told = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_NEAR(found[k], expected[k], 1e-3) << places[k].x << ' ' << places[k].y;
    told += expected[k] != 0.0 ? 1 : 0;
  }
  EXPECT_GT(told, 50);
}

/// Zones of the echo as distances along its surface, to the left.
std::vector<double> zones_along_m(const OneEcho& echo, const std::vector<double>& shown_along_m) {
  const consensus::Element& from = echo.elements.front();
  std::vector<Vec2> shown;
  for (const double s : shown_along_m) shown.push_back(from.position + s * perpendicular(from.normal));
  std::vector<double> along_m;
  for (const consensus::Element& zone :
       find_zones(echo.arcs, echo.options, echo.estimates, echo.elements, shown, 0.9)) {
    EXPECT_EQ(zone.echo, 0U);
    const Vec2 apart = zone.position - from.position;
    if (echo.estimates[0].wall_share > 0.5) {
      EXPECT_NEAR(dot(from.normal, apart), 0.0, 1e-12) << "a wall goes on along its tangent";
    } else {
      EXPECT_NEAR(norm(zone.position), echo.arcs[0].arc.range_m(), 1e-12) << "a pole stands on the arc";
    }
    along_m.push_back(cross(from.normal, apart));
  }
  std::ranges::sort(along_m);
  return along_m;
}

/// At 2 m the first Fresnel zone of 7 mm waves has a radius of sqrt(.007 m * 2 m / 2) = 8.37 cm, 1.2 of it are 10.04
/// cm.
TEST(ConsensusZones, GrowAsFarAsAnEchoAsks) {
  for (const double wall_share : {0.95, 0.05}) {
    const auto ends = zones_along_m(OneEcho(degrees(5.0), 0.95, wall_share), {0.0});
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR(ends[0], -0.1004, 1e-4);
    EXPECT_NEAR(ends[1], 0.1004, 1e-4);
  }
}

TEST(ConsensusZones, LeaveOutWhatIsUnsureShownOrPassed) {
  EXPECT_TRUE(zones_along_m(OneEcho(Angle{}, 0.9), {}).empty()) << "unsure";
  const auto one_side = zones_along_m(OneEcho(Angle{}, 0.95), {0.06});
  ASSERT_EQ(one_side.size(), 1U) << "to the left something else is shown within 5 cm";
  EXPECT_NEAR(one_side[0], -0.1004, 1e-4);

  // Two sure echoes from 3 m pass where the zone to the right would be.
  OneEcho passed(Angle{}, 0.95);
  for (int k = 0; k < 2; ++k) {
    passed.arcs.add({Arc::circular({0.0, -0.1}, Angle{}, 3.0, degrees(20.0)), {}, 0, degrees(20.0), 0});
    passed.estimates.push_back({.t = Angle{}, .p = 1.0, .bound_m = 0.05, .wall_share = 0.95, .evidence = 5.0});
    passed.elements.push_back(element_of(passed.arcs, passed.arcs.size() - 1, Angle{}));
  }
  for (const consensus::Element& zone :
       find_zones(passed.arcs, passed.options, passed.estimates, passed.elements, positions_of(passed.elements), 0.9))
    EXPECT_TRUE(zone.position.x > 2.5 || zone.position.y > 0.0) << zone.position.x << ' ' << zone.position.y;
}

/// A pole, and a wall behind it that is heard past it. Neither step B nor the vote, whose limits are out of reach,
/// speak against the pole: what is left is the evidence of all echoes together.
TEST(ConsensusSurface, WhatEchoesPassIsNotShown) {
  const auto points_at_the_pole = [](int echoes_past_it) {
    std::vector<Reading> readings;
    const auto look = [&](Vec2 from, Vec2 at) {
      readings.push_back(test::monostatic_reading({from, bearing(at - from)}, Echo{norm(at - from)}));
      readings.back().ping = readings.size() - 1;
      readings.back().tx = readings.back().rx = SensorId(readings.size());
    };
    for (int k = 0; k < 4; ++k) look({0.03 * k, 0.0}, {0.05, 1.0});
    for (int k = 0; k < echoes_past_it; ++k) {
      const double x = 0.05 + 0.022 * (k - echoes_past_it / 2);
      look({x, -0.3}, {x, 2.0});
    }
    ConsensusOptions options;
    options.facing = 0.0;
    options.passed = 1e6;
    options.blocked = 1e6;
    Consensus method(options);
    InlineExecutor here;
    method.insert(readings, here);
    method.finish(here);
    return std::ranges::count_if(method.map().points(),
                                 [](const MapPoint& point) { return norm(point.position - Vec2{0.05, 1.0}) < 0.1; });
  };
  EXPECT_GE(points_at_the_pole(0), 4);
  EXPECT_EQ(points_at_the_pole(20), 0);
}

}  // namespace
}  // namespace echoarc
