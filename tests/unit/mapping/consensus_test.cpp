// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/consensus.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mapping/consensus/posterior_kernels.hpp"
#include "mapping/consensus/read_out.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

Consensus mapped(const std::vector<Reading>& readings, const ConsensusOptions& options = {}) {
  Consensus method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

/// A drive along +x past a wall on the left, which answers like a mirror: from where the sound meets it at a right
/// angle, with 5 mm of noise. Five sensors look at it, 8 degrees apart.
std::vector<Reading> wall(int stops) {
  Rng rng(1);
  std::vector<Reading> readings;
  for (int stop = 0; stop < stops; ++stop)
    for (int k = -2; k <= 2; ++k) {
      Reading reading;
      reading.ping = readings.size();
      reading.time_s = 0.1 * stop + 0.01 * k;
      reading.tx = reading.rx = SensorId(k + 2);
      reading.T_world_robot = {{0.0231 * stop, 0.0117}, Angle{}};
      const Angle yaw = degrees(90.0 + 8.0 * k);
      reading.T_world_tx = reading.T_world_rx = reading.T_world_robot * Pose2{0.23 * unit(yaw), yaw};
      reading.outcome = Echo{test::wall_y_m - reading.T_world_tx.position.y + rng.normal(0.0, 0.005)};
      readings.push_back(reading);
    }
  return readings;
}

/// A sensor on a quarter circle around a pole at (1, 1), which it looks at slightly askew.
std::vector<Reading> around_a_pole() {
  std::vector<Reading> readings;
  for (int k = 0; k < 45; ++k) {
    const Angle from_pole = degrees(200.0 + 2.0 * k);
    const Vec2 sensor = Vec2{1.0, 1.0} + (1.0 + 0.1 * std::sin(0.3 * k)) * unit(from_pole);
    const Angle heading = from_pole + degrees(180.0 + 4.0 * std::sin(1.7 * k));
    readings.push_back(test::monostatic_reading({sensor, heading}, Echo{norm(Vec2{1.0, 1.0} - sensor)}));
    readings.back().ping = PingId(k);
  }
  return readings;
}

TEST(Consensus, PlacesAWallWhereItTouchesTheArcs) {
  const Consensus method = mapped(wall(30));
  std::size_t walls = 0;
  for (std::size_t k = 0; k < method.map().size(); ++k) {
    const MapPoint& point = method.map().points()[k];
    const PointBelief& belief = method.map().beliefs()[k];
    if (point.label != PointLabel::wall) continue;
    ++walls;
    EXPECT_NEAR(point.position.y, test::wall_y_m, 0.05);
    EXPECT_GT(dot(belief.normal, {0.0, -1.0}), std::cos(0.2)) << "normals point to the sensors";
    EXPECT_GT(belief.probability, 0.4);
    EXPECT_LE(belief.probability, 1.0);
    EXPECT_GE(point.bound_m, 0.05);
    EXPECT_EQ(method.map().support(point)[0], point.ping);
  }
  EXPECT_GT(walls, 30U);
}

TEST(Consensus, TellsAPoleFromAWall) {
  const Consensus method = mapped(around_a_pole());
  std::size_t points = 0;
  for (const MapPoint& point : method.map().points()) {
    if (point.label == PointLabel::link) continue;
    if (point.label == PointLabel::zone) {
      EXPECT_LT(norm(point.position - Vec2{1.0, 1.0}), 0.10);
      continue;
    }
    EXPECT_EQ(point.label, PointLabel::point);
    EXPECT_LT(norm(point.position - Vec2{1.0, 1.0}), 0.03);
    ++points;
  }
  EXPECT_GT(points, 30U);
}

/// The prior alone, sigma 8 degrees on -19 ... 19 in steps of 1, at 1 m: +-6 bins lie within 12 cm and hold
/// erf(6.5/8/sqrt 2)/erf(19.5/8/sqrt 2) = 0.592; 13 degrees to either side hold 90 %: 2 sin 6.5 degrees.
TEST(Consensus, ReadsAKnownPosterior) {
  const ConsensusOptions options;
  consensus::ArcTable arcs(options);
  arcs.add({Arc::circular({}, Angle{}, 1.0, degrees(20.0)), {}, 0, degrees(20.0), 0});
  const consensus::BeamBins& bins = arcs.bins(0);
  ASSERT_EQ(bins.count(), 39);
  const auto prior = std::span(bins.prior).first(39);
  const consensus::EchoEstimate estimate = read_out(arcs[0], bins, options, {prior, prior, 0.5F, 0.0F});
  EXPECT_NEAR(estimate.t.rad(), 0.0, 1e-6);
  EXPECT_NEAR(estimate.p, 0.592, 0.002);
  EXPECT_NEAR(estimate.bound_m, 2.0 * sin(degrees(6.5)), 1e-6);
}

TEST(Consensus, AnEllipseIsTouchedWhereItReachesFarthest) {
  const Pose2 tx{{0.1, 0.2}, degrees(40.0)};
  const Pose2 rx{{-0.2, 0.5}, degrees(55.0)};
  const Arc arc = Arc::elliptical(tx, rx, 1.3, degrees(25.0)).value();
  for (int k = 0; k < 36; ++k) {
    const Vec2 n = unit(degrees(10.0 * k));
    const Vec2 touch = consensus::touch_point(arc, n);
    EXPECT_NEAR(arc.half_path_m(touch), 1.3, 1e-12);
    EXPECT_NEAR(norm(consensus::normal_through(arc, touch) - n), 0.0, 1e-9);
    double farthest = -10.0;
    for (int m = 0; m < 720; ++m) farthest = std::max(farthest, dot(n, arc.point_at(degrees(0.5 * m))));
    EXPECT_NEAR(dot(n, touch), farthest, 1e-4);
    EXPECT_GE(dot(n, touch), farthest - 1e-12);
  }
}

/// Foci a micrometre apart make an ellipse of every circle: the slow form of the sums against the kernels.
TEST(Consensus, BistaticReadingsOfOnePlaceAreMonostaticOnes) {
  const std::vector<Reading> circles = wall(16);
  std::vector<Reading> ellipses = circles;
  for (Reading& reading : ellipses) {
    reading.rx = reading.tx + 100;
    reading.T_world_rx.position = reading.T_world_rx.position + Vec2{1e-6, 0.0};
  }
  const PointMap a = mapped(circles).map();
  const PointMap b = mapped(ellipses).map();
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 20U);
  for (std::size_t k = 0; k < a.size(); ++k) {  // points of nearly one certainty may come in another order
    const MapPoint& point = a.points()[k];
    const auto same = std::ranges::find_if(b.points(), [&](const MapPoint& other) {
      return other.label == point.label && norm(other.position - point.position) < 1e-4;
    });
    ASSERT_NE(same, b.points().end()) << k;
    EXPECT_NEAR(a.beliefs()[k].probability, b.beliefs()[std::size_t(same - b.points().begin())].probability, 1e-3);
  }
}

TEST(Consensus, BistaticReadingsFindTheWall) {
  std::vector<Reading> readings = wall(20);
  for (std::size_t k = 0; k + 1 < readings.size(); ++k) {
    Reading& r = readings[k];
    if (r.rx == 4) continue;
    const Reading& next = readings[k + 1];
    const Vec2 image{next.T_world_tx.position.x, 2.0 * test::wall_y_m - next.T_world_tx.position.y};
    r.rx = next.tx;
    r.T_world_rx = next.T_world_tx;
    r.outcome = Echo{0.5 * norm(image - r.T_world_tx.position)};
  }
  std::size_t walls = 0;
  const PointMap map = mapped(readings).map();
  for (const MapPoint& point : map.points()) {
    EXPECT_NEAR(point.position.y, test::wall_y_m, 0.1);
    walls += point.label == PointLabel::wall ? 1 : 0;
  }
  EXPECT_GT(walls, 20U);
}

TEST(Consensus, ModesShowMoreAndMore) {
  const std::vector<Reading> readings = wall(30);
  std::size_t before = 0;
  for (const ConsensusMode mode : {ConsensusMode::strict, ConsensusMode::balanced, ConsensusMode::complete}) {
    ConsensusOptions options;
    options.mode = mode;
    const PointMap map = mapped(readings, options).map();
    EXPECT_GE(map.size(), before);
    before = map.size();
    const bool zones = std::ranges::count(map.points(), PointLabel::zone, &MapPoint::label) > 0;
    EXPECT_EQ(zones, mode != ConsensusMode::strict);
  }
}

/// Five readings of a wall every 30 cm: without its links the picture would be dots.
TEST(Consensus, DrawsLinksAsLines) {
  std::vector<Reading> readings = wall(80);
  std::erase_if(readings, [](const Reading& reading) { return reading.ping / 5 % 13 != 0; });
  ConsensusOptions options;
  options.zone = 0.0;
  const Consensus method = mapped(readings, options);
  const MapExport map = method.export_map().value();
  ASSERT_FALSE(map.points.segments().empty());
  double from = 10.0;
  double to = -10.0;
  for (const MapSegment& link : map.points.segments()) {
    EXPECT_EQ(link.label, PointLabel::link);
    EXPECT_LE(norm(link.end - link.begin), method.options().link_m);
    from = std::min({from, link.begin.x, link.end.x});
    to = std::max({to, link.begin.x, link.end.x});
  }
  for (double x = from + 0.01; x < to; x += 0.01) {
    const std::int32_t column = map.states.geometry().cell_of({x, test::wall_y_m}).i;
    bool occupied = false;
    for (std::int32_t row = 0; row < map.states.height(); ++row)
      occupied = occupied || map.states.at({column, row}) == CellState::occupied;
    EXPECT_TRUE(occupied) << x;
  }
}

/// A wall with a gap of 45 cm, past which a sensor that looks at it squarely drives in silence.
TEST(Consensus, SilenceBeforeAGapKeepsItOpen) {
  std::vector<Reading> readings = wall(80);
  const auto before_gap = [](const Reading& reading) { return std::abs(reading.T_world_tx.position.x - 0.9) < 0.22; };
  std::vector<Reading> unheard = readings;
  std::erase_if(unheard, before_gap);
  for (Reading& reading : readings)
    if (before_gap(reading)) reading.outcome = NoEcho{};
  const auto crosses_gap = [](const MapSegment& link) {
    return std::min(link.begin.x, link.end.x) < 0.88 && std::max(link.begin.x, link.end.x) > 0.92;
  };
  EXPECT_GT(std::ranges::count_if(mapped(unheard).map().segments(), crosses_gap), 0);
  EXPECT_EQ(std::ranges::count_if(mapped(readings).map().segments(), crosses_gap), 0);
}

TEST(Consensus, NothingIsWhereTheRobotHasBeen) {
  std::vector<Reading> readings = wall(60);
  for (std::size_t k = 0; k < 40; ++k) {
    Reading through = test::monostatic_reading({{0.02 * double(k), test::wall_y_m}, Angle{}}, Echo{4.9});
    through.T_world_robot.position = through.T_world_tx.position;
    through.ping = 1000 + k;
    readings.push_back(through);
  }
  const PointMap map = mapped(readings).map();
  EXPECT_FALSE(map.empty());
  for (const MapPoint& point : map.points())
    EXPECT_TRUE(point.position.x < -0.1 || point.position.x > 0.9) << point.position.x;
}

TEST(Consensus, NewPointsAreProvisional) {
  const PointMap map = mapped(wall(60)).map();
  for (std::size_t k = 0; k < map.size(); ++k)
    if (map.points()[k].label == PointLabel::wall) {
      EXPECT_EQ(map.beliefs()[k].provisional, map.points()[k].ping >= 200) << map.points()[k].ping;
    }
}

/// Estimates that no reading can change any more are not weighed again; the map is the same as if they were.
TEST(Consensus, MapsOfPartsAreThoseOfTheWhole) {
  ConsensusOptions options;
  options.history = 10;
  const std::vector<Reading> readings = wall(900);
  const Consensus whole = mapped(readings, options);
  Consensus parts(options);
  InlineExecutor executor;
  for (std::size_t k = 0; k < readings.size(); k += 500) {
    parts.insert(std::span(readings).subspan(k, std::min<std::size_t>(500, readings.size() - k)), executor);
    parts.finish(executor);
  }
  parts.finish(executor);  // with nothing new, everything open is settled
  ASSERT_GT(whole.counters().used, 4200U);
  ASSERT_EQ(parts.map().size(), whole.map().size());
  for (std::size_t k = 0; k < whole.map().size(); ++k) {
    EXPECT_EQ(parts.map().points()[k].position, whole.map().points()[k].position);
    EXPECT_EQ(parts.map().beliefs()[k], whole.map().beliefs()[k]);
  }
}

TEST(Consensus, TracesAndSupports) {
  std::vector<Reading> readings = wall(30);
  const Reading last = readings.back();
  readings.pop_back();
  const Consensus method = mapped(readings);
  const Trace trace = method.trace(last);
  ASSERT_TRUE(trace.arc);
  ASSERT_EQ(trace.points.size(), 1U);
  EXPECT_NEAR(trace.points[0].y, test::wall_y_m, 0.05);
  EXPECT_TRUE(method.supports(last, trace.points[0]));
  EXPECT_FALSE(method.supports(last, trace.points[0] + Vec2{0.0, 0.001}));
  EXPECT_FALSE(method.supports(last, last.T_world_tx * Vec2{-echo_range_m(last.outcome).value(), 0.0}));
}

TEST(ConsensusKernels, AllGiveTheSameBits) {
  namespace k = kernels;
  const k::PosteriorKernels* sets[2];
  const int available = k::available_posterior_kernels(sets, 2);
  constexpr std::size_t bins = 32;
  Rng rng(3);
  std::vector<float> t(bins), cos_t(bins), sin_t(bins), weights(3 * bins, 0.0F);
  for (std::size_t m = 0; m < bins; ++m) {
    t[m] = 0.01745F * (float(m) - 15.0F);
    cos_t[m] = std::cos(t[m]);
    sin_t[m] = std::sin(t[m]);
    if (m < 31) weights[bins + m] = float(rng.uniform(0, 16));
  }
  const k::PosteriorTerms terms{4.0F,  250.0F, -20.0F, 0.3F,     0.1745F,      0.1F,
                                57.3F, 1.5F,   4,      t.data(), cos_t.data(), sin_t.data()};
  std::vector<k::CirclePair> pairs;
  for (int n = 0; n < 100; ++n) {
    const auto turn = float(rng.uniform(-0.5, 0.5));
    pairs.push_back({float(rng.uniform(-1, 1)), float(rng.uniform(-1, 1)), float(rng.uniform(-0.5, 0.5)),
                     float(rng.uniform(1, 2)), turn, std::cos(turn), std::sin(turn), 25.0F,
                     std::int32_t(std::lround(turn * 57.3F)), 15, weights.data() + bins, weights.data() + bins});
  }
  std::vector<std::vector<float>> results;
  for (int s = 0; s < available; ++s) {
    std::vector<float> sums(4 * bins, 0.0F);
    sets[s]->add_walls(terms, pairs.data(), 100, {sums.data(), sums.data() + bins});
    sets[s]->add_points(terms, pairs.data(), 100, {sums.data() + 2 * bins, sums.data() + 3 * bins});
    float top = sums[0];
    for (int m = 0; m < 31; ++m) top = std::max(top, sums[std::size_t(m)]);
    sums.push_back(sets[s]->normalise(sums.data(), 31, top));
    results.push_back(sums);
  }
  for (const auto& result : results) EXPECT_EQ(result, results.front());
  float sum = 0.0F;
  for (int m = 0; m < 31; ++m) sum += results.front()[std::size_t(m)];
  EXPECT_NEAR(sum, 1.0F, 1e-5F);
}

}  // namespace
}  // namespace echoarc
