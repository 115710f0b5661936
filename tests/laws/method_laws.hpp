// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/method.hpp"
#include "support/random_readings.hpp"
#include "support/test_threads.hpp"

/// One suite of laws that every mapping method must keep, applied by one line per method:
///
///     ECHOARC_METHOD_LAWS(Voting);
///
/// A method that cannot keep a law says so as data, with the reason its paper gives (`LawException`); the suite then
/// shows the exception instead of the law.
namespace echoarc::laws {

template <class Method>
struct LawException {
  /// Why what was once free cannot become occupied again; empty: it can.
  static constexpr std::string_view cannot_recover = "";
  /// Why echoes from one position alone place nothing; empty: they do.
  static constexpr std::string_view needs_baseline = "";
};

/// Cells coarse enough for the suite to be quick; everything else as shipped.
template <class Method>
typename Method::Options law_options() {
  typename Method::Options options;
  options.cell_m = 0.02;
  return options;
}

/// Echoes, bistatic ones among them, with some silence in between.
inline std::vector<Reading> law_readings(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Reading> readings = test::wall_drive(rng, 12);
  for (int k = 0; k < 40; ++k) readings.push_back(test::random_reading(rng, readings.size()));
  for (int k = 0; k < 8; ++k) {
    readings.push_back(test::random_reading(rng, readings.size()));
    readings.back().outcome = NoEcho{};
  }
  return readings;
}

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options) {
  Method method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

/// What a method knows of a cell, by the position of its centre.
struct CellView {
  CellState state = CellState::unknown;
  double value = 0.0;
};
using MapView = std::vector<std::pair<Cell, CellView>>;  // by cell

inline double value_at(const MapExport& map, Cell c) {
  if (const auto* grid = std::get_if<DenseGrid<float>>(&map.values)) return double(grid->at(c));
  if (const auto* grid = std::get_if<DenseGrid<std::uint16_t>>(&map.values)) return double(grid->at(c));
  return 0.0;
}

/// All cells of an exported map in cells of `geometry`, each moved by \p T first.
inline MapView view_of(const MapExport& map, const GridGeometry& geometry, const Pose2& T = {}) {
  MapView view;
  for (std::int32_t j = 0; j < map.states.height(); ++j)
    for (std::int32_t i = 0; i < map.states.width(); ++i) {
      const Vec2 centre = T * map.states.geometry().centre({i, j});
      view.emplace_back(geometry.cell_of(centre), CellView{map.states.at({i, j}), value_at(map, {i, j})});
    }
  std::sort(view.begin(), view.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return view;
}

inline CellState state_at(const MapView& view, Cell cell) {
  const auto found =
      std::lower_bound(view.begin(), view.end(), cell, [](const auto& entry, Cell c) { return entry.first < c; });
  return found != view.end() && found->first == cell ? found->second.state : CellState::unknown;
}

inline void expect_same_view(const MapView& a, const MapView& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto& [cell, view] = a[k];
    ASSERT_EQ(cell, b[k].first) << cell.i << " " << cell.j;
    EXPECT_EQ(view.state, b[k].second.state) << cell.i << " " << cell.j;
    EXPECT_NEAR(view.value, b[k].second.value, 1e-6) << cell.i << " " << cell.j;
  }
}

inline Reading moved(const Pose2& T, Reading reading) {
  reading.T_world_robot = T * reading.T_world_robot;
  reading.T_world_tx = T * reading.T_world_tx;
  reading.T_world_rx = T * reading.T_world_rx;
  return reading;
}

/// Points move with the world to 1e-9 m. Grids move with it by whole cells and quarter turns about a cell corner; the
/// shifts are whole windows of methods that look at the map in windows.
template <class Method>
void expect_equivariant(const typename Method::Options& options, const std::vector<Reading>& readings) {
  constexpr double shift_cells = 120.0;
  const bool points_only = std::is_same_v<typename Method::Map, PointMap>;
  const Method here = mapped<Method>(readings, options);
  for (int quarter = 0; quarter < 4; ++quarter) {
    Pose2 T{{shift_cells * options.cell_m, -2.0 * shift_cells * options.cell_m}, degrees(90.0 * quarter)};
    if (points_only) T = {{1.234, -5.678}, degrees(17.0 + 90.0 * quarter)};
    std::vector<Reading> there_readings;
    for (const Reading& reading : readings) there_readings.push_back(moved(T, reading));
    const Method there = mapped<Method>(there_readings, options);
    const Result<MapExport> a = here.export_map();
    const Result<MapExport> b = there.export_map();
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->points.size(), b->points.size());
    if (points_only) {
      for (std::size_t k = 0; k < a->points.size(); ++k)
        EXPECT_LT(norm(T * a->points.points()[k].position - b->points.points()[k].position), 1e-9);
    } else {
      const GridGeometry geometry{options.cell_m, {options.origin_x_m, options.origin_y_m}};
      expect_same_view(view_of(*a, geometry, T), view_of(*b, geometry));
    }
  }
}

/// Echoes of a place one metre ahead of a sensor: all from there, or from an arc around the place for methods that
/// need a baseline.
template <class Method>
std::vector<Reading> hits_of_place(const Pose2& sensor) {
  constexpr int count = 1000;
  if (LawException<Method>::needs_baseline.empty())
    return std::vector<Reading>(count, test::monostatic_reading(sensor, Echo{1.0}));
  std::vector<Reading> hits;
  for (int k = 0; k < count; ++k) {
    const Pose2 T_sensor_other = Pose2{{1.0, 0.0}, degrees(0.04 * (k - count / 2))} * Pose2{{-1.0, 0.0}, {}};
    hits.push_back(test::monostatic_reading(sensor * T_sensor_other, Echo{1.0}));
  }
  return hits;
}

/// Enough readings of enough places to fill a megabyte with any map.
template <class Method>
std::vector<Reading> filling_readings() {
  Rng rng(8);
  std::vector<Reading> readings;
  for (int k = 0; k < 16000; ++k) {
    const Pose2 somewhere{{rng.uniform(-8, 8), rng.uniform(-8, 8)}, degrees(rng.uniform(-180, 180))};
    readings.push_back(test::monostatic_reading(somewhere, Echo{0.5}));
    readings.back().ping = PingId(k);
  }
  return readings;
}

/// Whether an occupied cell or a point lies within two cells of a position.
template <class Method>
bool occupied_near(const Method& method, Vec2 position) {
  const Result<MapExport> map = method.export_map();
  for (const MapPoint& point : map->points.points())
    if (norm(point.position - position) < 2.0 * method.options().cell_m) return true;
  return false;
}

template <class Method>
class MethodLaws : public testing::Test {
 protected:
  using Options = typename Method::Options;
  static constexpr std::array<std::uint64_t, 3> seeds = {1, 2, 3};
};
TYPED_TEST_SUITE_P(MethodLaws);

TYPED_TEST_P(MethodLaws, MovesWithTheWorld) {
  for (const std::uint64_t seed : this->seeds) {
    const std::vector<Reading> readings = law_readings(seed);
    expect_equivariant<TypeParam>(law_options<TypeParam>(), readings);
    for (std::size_t k = 0; k < readings.size(); k += 9)
      expect_equivariant<TypeParam>(law_options<TypeParam>(), {readings[k]});
  }
}

TYPED_TEST_P(MethodLaws, BatchAndIncrementalAgree) {
  for (const std::uint64_t seed : this->seeds) {
    const std::vector<Reading> readings = law_readings(seed);
    const std::vector<std::byte> batch = mapped<TypeParam>(readings, law_options<TypeParam>()).save();
    InlineExecutor executor;
    TypeParam one_by_one(law_options<TypeParam>());
    for (const Reading& reading : readings) one_by_one.insert(std::span(&reading, 1), executor);
    one_by_one.finish(executor);
    EXPECT_EQ(one_by_one.save(), batch);
    TypeParam in_pieces(law_options<TypeParam>());
    for (std::size_t k = 0; k < readings.size(); k += 7) {
      in_pieces.insert(std::span(readings).subspan(k, std::min<std::size_t>(7, readings.size() - k)), executor);
      in_pieces.finish(executor);
    }
    EXPECT_EQ(in_pieces.save(), batch);
  }
}

TYPED_TEST_P(MethodLaws, SilenceNeverAddsOccupancy) {
  for (const std::uint64_t seed : this->seeds) {
    std::vector<Reading> readings = law_readings(seed);
    const auto before = mapped<TypeParam>(readings, law_options<TypeParam>()).export_map();
    Rng rng(seed + 100);
    for (int k = 0; k < 60; ++k) {
      readings.push_back(test::random_reading(rng, readings.size()));
      readings.back().outcome = NoEcho{};
    }
    const auto after = mapped<TypeParam>(readings, law_options<TypeParam>()).export_map();
    ASSERT_TRUE(before && after);
    const GridGeometry geometry{law_options<TypeParam>().cell_m, {}};
    const MapView was = view_of(*before, geometry);
    for (const auto& [cell, view] : view_of(*after, geometry)) {
      if (view.state == CellState::occupied) {
        EXPECT_EQ(state_at(was, cell), CellState::occupied) << cell.i << " " << cell.j;
      }
    }
    EXPECT_LE(after->points.size(), before->points.size());
  }
}

TYPED_TEST_P(MethodLaws, WhatWasFreeCanBecomeOccupied) {
  const Pose2 sensor{{0.0031, 0.0043}, degrees(7.0)};
  const Vec2 place = sensor * Vec2{1.0, 0.0};
  const std::vector<Reading> passing(200, test::monostatic_reading(sensor, Echo{2.0}));
  const std::vector<Reading> hitting = hits_of_place<TypeParam>(sensor);
  EXPECT_TRUE(occupied_near(mapped<TypeParam>(hitting, law_options<TypeParam>()), place)) << "without a past";
  std::vector<Reading> both = passing;
  both.insert(both.end(), hitting.begin(), hitting.end());
  const std::string_view reason = LawException<TypeParam>::cannot_recover;
  this->RecordProperty("cannot_recover", std::string(reason));
  EXPECT_FALSE(occupied_near(mapped<TypeParam>(passing, law_options<TypeParam>()), place));
  EXPECT_EQ(occupied_near(mapped<TypeParam>(both, law_options<TypeParam>()), place), reason.empty()) << reason;
}

TYPED_TEST_P(MethodLaws, ValuesAreFinite) {
  for (const std::uint64_t seed : this->seeds) {
    const auto map = mapped<TypeParam>(law_readings(seed), law_options<TypeParam>()).export_map();
    ASSERT_TRUE(map);
    EXPECT_FALSE(map->states.empty());
    for (const MapPoint& point : map->points.points()) EXPECT_TRUE(is_finite(point.position));
    for (std::int32_t j = 0; j < map->states.height(); ++j)
      for (std::int32_t i = 0; i < map->states.width(); ++i) ASSERT_TRUE(std::isfinite(value_at(*map, {i, j})));
  }
}

TYPED_TEST_P(MethodLaws, RestoredMethodGoesOnEqually) {
  const std::vector<Reading> readings = law_readings(4);
  const auto half = std::span(readings).first(readings.size() / 2);
  const auto rest = std::span(readings).subspan(readings.size() / 2);
  TypeParam original = mapped<TypeParam>(half, law_options<TypeParam>());
  const std::vector<std::byte> bytes = original.save();
  Result<TypeParam> copy = TypeParam::restore(bytes);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(copy->save(), bytes);
  EXPECT_EQ(copy->counters(), original.counters());
  InlineExecutor executor;
  for (TypeParam* method : {&original, &*copy}) {
    method->insert(rest, executor);
    method->finish(executor);
  }
  EXPECT_EQ(copy->save(), original.save());
}

TYPED_TEST_P(MethodLaws, ThreadsDoNotChangeABit) {
  const std::vector<Reading> readings = law_readings(5);
  const std::vector<std::byte> expected = mapped<TypeParam>(readings, law_options<TypeParam>()).save();
  for (const std::size_t count : {1, 2, 8}) {
    test::TestThreads threads(count);
    TypeParam method(law_options<TypeParam>());
    method.insert(readings, threads);
    method.finish(threads);
    EXPECT_EQ(method.save(), expected) << count << " threads";
  }
}

TYPED_TEST_P(MethodLaws, FailedMeasurementsChangeNothing) {
  std::vector<Reading> readings = law_readings(6);
  const auto before = mapped<TypeParam>(readings, law_options<TypeParam>()).export_map();
  Rng rng(7);
  for (int k = 0; k < 20; ++k) {
    readings.push_back(test::random_reading(rng, readings.size()));
    readings.back().outcome = k % 2 == 0 ? Outcome{Invalid{}} : Outcome{TooClose{}};
  }
  const TypeParam method = mapped<TypeParam>(readings, law_options<TypeParam>());
  EXPECT_GE(method.counters().no_information, 20U);
  EXPECT_TRUE(method.trace(readings.back()).cells.empty());
  const auto after = method.export_map();
  ASSERT_TRUE(before && after);
  const GridGeometry geometry{law_options<TypeParam>().cell_m, {}};
  expect_same_view(view_of(*before, geometry), view_of(*after, geometry));
}

TYPED_TEST_P(MethodLaws, MemoryLimitIsKeptAndCounted) {
  typename TestFixture::Options options;
  options.cell_m = 0.01;
  options.max_memory_mib = 1;
  const std::vector<Reading> readings = filling_readings<TypeParam>();
  TypeParam method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  const InsertCounters& counters = method.counters();
  EXPECT_GT(counters.used, 0U);
  EXPECT_GT(counters.memory_limit, 0U);
  EXPECT_EQ(counters.used + counters.no_information + counters.no_arc + counters.bistatic + counters.passed_over +
                counters.memory_limit,
            readings.size());
  EXPECT_LT(method.save().size(), std::size_t{1200} << 10);
}

REGISTER_TYPED_TEST_SUITE_P(MethodLaws, MovesWithTheWorld, BatchAndIncrementalAgree, SilenceNeverAddsOccupancy,
                            WhatWasFreeCanBecomeOccupied, ValuesAreFinite, RestoredMethodGoesOnEqually,
                            ThreadsDoNotChangeABit, FailedMeasurementsChangeNothing, MemoryLimitIsKeptAndCounted);

}  // namespace echoarc::laws

/// Applies the laws to a method.
#define ECHOARC_METHOD_LAWS(Method) INSTANTIATE_TYPED_TEST_SUITE_P(Method, MethodLaws, Method)
