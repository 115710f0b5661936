// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/atm.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

using test::monostatic_reading;

/// Five sensors around a point at (0, 2.5), ranges in whole inches.
std::vector<Reading> v316_readings() {
  constexpr std::array<double, 5> x_m = {-1.0, -0.5, 0.0, 0.5, 1.0};
  constexpr std::array<double, 5> axis_deg = {67.5, 90.0, 90.0, 90.0, 112.5};
  constexpr std::array<double, 5> range_m = {2.6924, 2.54, 2.4892, 2.54, 2.6924};
  std::vector<Reading> readings;
  for (std::size_t k = 0; k < x_m.size(); ++k) {
    readings.push_back(monostatic_reading({{x_m[k], 0.0}, degrees(axis_deg[k])}, Echo{range_m[k]}, degrees(22.5)));
    readings.back().ping = k;
    readings.back().time_s = 0.1 * double(k);
  }
  return readings;
}

template <class Method>
Method mapped(const std::vector<Reading>& readings, typename Method::Options options = {}) {
  Method method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

struct Expected {
  double bearing_deg;
  Vec2 position;
  PointLabel label;
};

constexpr double printed_deg = 1e-4;

/// The points of the example in the order of its arcs; each lies on the arc of its first supporting ping.
template <class Method>
void expect_points(const Method& method, const std::vector<Reading>& readings,
                   const std::vector<std::pair<PingId, double>>& bearings_deg) {
  ASSERT_EQ(method.map().size(), bearings_deg.size());
  for (std::size_t k = 0; k < bearings_deg.size(); ++k) {
    const MapPoint& point = method.map().points()[k];
    const auto [ping, bearing_deg] = bearings_deg[k];
    EXPECT_EQ(method.map().support(point)[0], ping);
    EXPECT_NEAR(bearing(point.position - readings[ping].T_world_tx.position).deg(), bearing_deg, printed_deg) << k;
  }
}

template <class Method>
typename Method::Options with_angle(double theta_t_deg) {
  typename Method::Options options;
  options.theta_t = degrees(theta_t_deg);
  return options;
}

TEST(Atm, V316AtZeroAndThirteenDegrees) {
  const std::vector<Reading> readings = v316_readings();
  for (const double theta_t : {0.0, 13.0}) {
    const auto mod = mapped<AtmMod>(readings, with_angle<AtmMod>(theta_t));
    expect_points(mod, readings, {{0, 67.8343}, {1, 79.0106}, {2, 90.0}, {3, 100.9894}, {4, 112.1657}});
    EXPECT_NEAR(norm(mod.map().points()[0].position - Vec2{0.0158, 2.4934}), 0.0, 1e-4);
    EXPECT_NEAR(norm(mod.map().points()[1].position - Vec2{-0.0158, 2.4934}), 0.0, 1e-4);
    EXPECT_NEAR(norm(mod.map().points()[2].position - Vec2{0.0, 2.4892}), 0.0, 1e-12);
    const auto org = mapped<AtmOrg>(readings, with_angle<AtmOrg>(theta_t));
    expect_points(org, readings, {{0, 67.8343}, {1, 79.0106}, {3, 100.9894}, {4, 112.1657}});
    const auto silver = mapped<AtmSilver>(readings, with_angle<AtmSilver>(theta_t));
    expect_points(silver, readings, {{0, 67.8343}, {1, 79.0106}, {2, 90.0}, {3, 100.9894}, {4, 112.1657}});
  }
}

TEST(Atm, V316AtThirtyDegrees) {
  const std::vector<Reading> readings = v316_readings();
  // Arc 2 crosses none at 30 degrees; arcs 0 and 4 cross two others, arcs 1 and 3 one.
  const auto org = mapped<AtmOrg>(readings);
  expect_points(org, readings, {{1, 79.0106}, {2, 90.0}, {3, 100.9894}});
  EXPECT_EQ(org.map().points()[1].label, PointLabel::centerline);
  EXPECT_NEAR(norm(org.map().points()[1].position - Vec2{0.0, 2.4892}), 0.0, 1e-12);
  const auto mod = mapped<AtmMod>(readings, with_angle<AtmMod>(30.0));
  expect_points(mod, readings, {{0, 68.0157}, {1, 79.0106}, {3, 100.9894}, {4, 111.9843}});
  const auto silver = mapped<AtmSilver>(readings, with_angle<AtmSilver>(30.0));
  expect_points(silver, readings, {{0, 68.0157}, {1, 79.0106}, {2, 90.0}, {3, 100.9894}, {4, 111.9843}});
}

TEST(Atm, PointsKnowTheirPartnersTimeAndBound) {
  const std::vector<Reading> readings = v316_readings();
  const auto mod = mapped<AtmMod>(readings, with_angle<AtmMod>(13.0));
  const MapPoint& odd = mod.map().points()[0];  // crossings with arcs 4, 3, 2 from 67.59 to 68.20 degrees
  EXPECT_EQ(odd.label, PointLabel::atm);
  EXPECT_EQ(odd.support_count, 2U);
  EXPECT_EQ(odd.ping, mod.map().support(odd)[1]);
  EXPECT_EQ(odd.time_s, readings[odd.ping].time_s);
  EXPECT_NEAR(odd.bound_m, 0.222933 / 2.0, 1e-6);  // V3.14
  const MapPoint& even = mod.map().points()[2];
  EXPECT_EQ(even.support_count, 3U);
  const auto flat = mapped<AtmMod>(readings, with_angle<AtmMod>(0.0));
  EXPECT_NEAR(flat.map().points()[2].bound_m, 0.5 * 2.4892 * degrees(22.5).rad(), 1e-12) << "half the arc";
}

TEST(Atm, SmallDistancesTakeTheMiddle) {
  // V3.12: at 0.241391 m a crossing at 30 degrees leaves as much as the arc is long.
  for (const double scale : {0.99, 1.01}) {
    const double range_m = 0.241391 * scale;
    std::vector<Reading> readings;
    for (const double side : {-1.0, 1.0}) {  // both hear (0, 0) at the edge of the beam, 11 degrees off the axis
      const Angle at = degrees(-90.0 + side * 20.0);
      readings.push_back(
          monostatic_reading({range_m * unit(at), at + degrees(180.0 - side * 11.0)}, Echo{range_m}, degrees(22.5)));
      readings.back().ping = readings.size() - 1;
    }
    AtmSilver::Options options;
    EXPECT_EQ(mapped<AtmSilver>(readings, options).map().points()[0].label, PointLabel::atm);
    options.small_d_center = true;
    EXPECT_EQ(mapped<AtmSilver>(readings, options).map().points()[0].label,
              scale < 1.0 ? PointLabel::centerline : PointLabel::atm);
  }
}

TEST(Atm, ArcsThatLeaveTakeTheirCrossingsAlong) {
  Rng rng(1);
  std::vector<Reading> readings = test::random_readings(rng, 400);
  for (const HistoryScope scope : {HistoryScope::total, HistoryScope::per_sensor}) {
    AtmSilver::Options options;
    options.history = scope;
    options.history_arcs = scope == HistoryScope::total ? 60 : 5;
    options.theta_t = degrees(5.0);
    options.archive = false;
    AtmSilver method(options);
    InlineExecutor executor;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      method.insert(std::span(&readings[k], 1), executor);
      if (k % 50 != 49) continue;
      method.finish(executor);
      // The arcs now in the history, as if no others had ever been.
      std::vector<Reading> kept;
      for (const ArcSlot slot : method.history().in_time_order())
        kept.push_back(readings[method.history().source(slot).ping]);
      AtmSilver::Options all = options;
      all.history = HistoryScope::all;
      const auto fresh = mapped<AtmSilver>(kept, all);
      ASSERT_EQ(method.map().size(), fresh.map().size());
      for (std::size_t n = 0; n < fresh.map().size(); ++n) {
        EXPECT_EQ(method.map().points()[n].position, fresh.map().points()[n].position);
        EXPECT_EQ(method.map().points()[n].label, fresh.map().points()[n].label);
      }
    }
  }
}

TEST(Atm, ArchiveKeepsTheFinalPoints) {
  Rng rng(2);
  const std::vector<Reading> readings = test::wall_drive(rng, 30);
  AtmOrg::Options options;
  const auto global = mapped<AtmOrg>(readings, options);
  options.archive = false;
  const auto local = mapped<AtmOrg>(readings, options);
  EXPECT_EQ(local.history().size(), 50U);
  EXPECT_LE(local.map().size(), 50U);
  EXPECT_GT(global.map().size(), local.map().size());
  const auto tail = global.map().points().last(local.map().size());
  for (std::size_t k = 0; k < tail.size(); ++k) EXPECT_EQ(tail[k].position, local.map().points()[k].position);
}

TEST(Atm, GainGivesEachArcItsOwnAngle) {
  std::vector<Reading> readings = v316_readings();
  AtmMod::Options options;
  options.angle = TransversalAngle::from_gain;
  options.gain = 10.0;  // at 2.5 m about 29 degrees (V3.15)
  const auto method = mapped<AtmMod>(readings, options);
  EXPECT_NEAR(method.medians().least_angle(method.history().arc(2)).deg(), 29.1, 0.1);
  options.gain = 100.0;  // not to be had: no crossing counts
  EXPECT_TRUE(mapped<AtmMod>(readings, options).map().empty());
  EXPECT_EQ(mapped<AtmOrg>(readings,
                           [] {
                             AtmOrg::Options o;
                             o.angle = TransversalAngle::from_gain;
                             o.gain = 100.0;
                             return o;
                           }())
                .map()
                .size(),
            readings.size());
}

TEST(Atm, HistogramGivesACentralAngle) {
  const std::vector<Reading> readings = v316_readings();
  AtmMod::Options options;
  options.angle = TransversalAngle::from_histogram;
  const auto method = mapped<AtmMod>(readings, options);
  const Angle chosen = method.medians().histogram().value(HistogramStatistic::median);
  EXPECT_GT(chosen, degrees(13.0));
  const auto given = mapped<AtmMod>(readings, with_angle<AtmMod>(chosen.deg()));
  ASSERT_EQ(method.map().size(), given.map().size());
  for (std::size_t k = 0; k < given.map().size(); ++k)
    EXPECT_EQ(method.map().points()[k].position, given.map().points()[k].position);
}

TEST(Atm, HistogramStatistics) {
  AngleHistogram histogram;
  EXPECT_EQ(histogram.value(HistogramStatistic::median).deg(), 0.0);
  for (const double deg : {1.2, 1.7, 5.5, 20.5, 21.5, 22.5, 90.0}) histogram.add(degrees(deg).rad());
  EXPECT_NEAR(histogram.value(HistogramStatistic::median).deg(), 20.5, 1e-12);
  EXPECT_NEAR(histogram.value(HistogramStatistic::mean).deg(), (1.5 + 1.5 + 5.5 + 20.5 + 21.5 + 22.5 + 89.5) / 7,
              1e-12);
  EXPECT_NEAR(histogram.value(HistogramStatistic::mode).deg(), 21.5, 1e-12);
  histogram.remove(degrees(20.5).rad());
  EXPECT_NEAR(histogram.value(HistogramStatistic::mode).deg(), 0.5, 1e-12) << "two and two: the lower";
}

TEST(Atm, V317MedianOfAnEvenNumberIsTheMeanOfTheMiddleOnes) {
  // One arc crossed at 1, 4, 6 and 10 degrees by circles of 1 m about points on a normal to it: the median is at 5.
  std::vector<Reading> readings = {monostatic_reading({{0, 0}, Angle{}}, Echo{2.0}, degrees(40.0))};
  for (const double at : {1.0, 4.0, 6.0, 10.0}) {
    const Angle along = degrees(at + 90.0);
    readings.push_back(monostatic_reading({2.0 * unit(degrees(at)) + 5.0 * unit(along), along + degrees(180.0)},
                                          Echo{5.0}, degrees(2.0)));
    readings.back().ping = readings.size() - 1;
  }
  const auto method = mapped<AtmMod>(readings, with_angle<AtmMod>(80.0));
  ASSERT_FALSE(method.map().empty());
  EXPECT_NEAR(bearing(method.map().points()[0].position).deg(), 5.0, 1e-9);
}

}  // namespace
}  // namespace echoarc
