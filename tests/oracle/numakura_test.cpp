// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/numakura.hpp"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracle/mapping_oracles.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

constexpr double cell_m = 0.2;
constexpr CellBox region{-35, -35, 35, 35};  // 7 m to all sides: holds every random reading

/// [Numakura] 4 and 5 cell by cell: one whole map per scan, every angle by atan2.
class SlowNumakura {
 public:
  void insert(const Reading& reading) {
    if (scans_ == 0 || reading.scan != scan_) {
      frozen_ = values_;
      scan_ = reading.scan;
      ++scans_;
    }
    const auto arc = arc_of(reading);
    const double d = arc ? arc->range_m() : reading.trusted_range_m;
    const double u = d <= 3.0 ? 1.0 : 3.0 / d;
    if (!arc) return add(reading, std::nullopt, d, 0.5 * u);
    const Vec2 axis = unit(arc->axis());
    const Vec2 surface = arc->midpoint();
    bool outlier = false;
    const auto last = last_.find({reading.tx, reading.rx});
    if (last != last_.end() && last->second.scan + 1 == reading.scan) {
      const Vec2 v = surface - last->second.surface;
      const double theta = std::acos(std::clamp(dot(axis, v) / norm(v), -1.0, 1.0));
      outlier = norm(v) >= 0.0254 && std::abs(theta - degrees(90.0).rad()) >= arc->half_width().rad();
      const double along_m = norm(surface - arc->centre());
      if ((last->second.outlier || std::abs(last->second.along_m - along_m) > 0.3) && scans_ > 10)
        outlier = outlier || blocked(arc->centre() + 0.1 * axis, axis, along_m - 0.1 - 2.0 * cell_m);
    }
    last_[{reading.tx, reading.rx}] = {surface, norm(surface - arc->centre()), reading.scan, outlier};
    add(reading, arc, d, outlier ? 0.1 * u : u);
  }
  [[nodiscard]] double value(Cell cell) const {
    const auto found = values_.find(cell);
    return found == values_.end() ? 0.0 : found->second;
  }

 private:
  struct Last {
    Vec2 surface;
    double along_m;
    std::uint32_t scan;
    bool outlier;
  };

  [[nodiscard]] bool blocked(Vec2 from, Vec2 axis, double length_m) const {
    if (length_m <= 0.0) return false;
    for (const Cell cell : oracle::crossed_cells(from, axis, length_m, region, {cell_m, {}}))
      if (const auto found = frozen_.find(cell); found != frozen_.end() && found->second < -6.0) return true;
    return false;
  }
  void add(const Reading& reading, const std::optional<Arc>& arc, double d, double weight) {
    Reading at_rim = reading;
    at_rim.outcome = Echo{d};
    const auto rim = arc_of(at_rim);
    if (!rim) return;
    std::set<Cell> on_arc;
    if (arc) {
      ArcRaster raster({cell_m, {}});
      const auto cells = raster.cells(*arc);
      on_arc = {cells.begin(), cells.end()};
    }
    // In the fixed point of the map: whether a sum of tenths is below -6 must not hang on the last bit of a double.
    const auto step = [weight](double units) { return std::rint(units * weight / numakura_unit) * numakura_unit; };
    for (const Cell cell : on_arc) values_[cell] = std::max(values_[cell] - step(3.0), -1000.0);
    for (std::int32_t j = region.j_begin; j < region.j_end; ++j)
      for (std::int32_t i = region.i_begin; i < region.i_end; ++i) {
        const Vec2 centre = GridGeometry{cell_m, {}}.centre({i, j});
        const double half_path_m = rim->half_path_m(centre);
        const bool inside = (arc ? half_path_m < d - cell_m : half_path_m <= d) &&
                            abs(wrap(bearing(centre - rim->centre()) - rim->axis())) <= rim->half_width();
        if (inside && !on_arc.contains({i, j})) values_[{i, j}] = std::min(values_[{i, j}] + step(1.0), 1000.0);
      }
  }

  std::map<Cell, double> values_;
  std::map<Cell, double> frozen_;
  std::map<std::pair<SensorId, SensorId>, Last> last_;
  std::uint32_t scan_ = 0;
  int scans_ = 0;
};

RC_GTEST_PROP(NumakuraOracle, ValuesAreEqual, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Reading> readings = test::wall_drive(rng, 14);
  for (Reading& reading : test::random_readings(rng, 24)) {
    reading.scan += 14;
    if (rng.below(4) == 0) reading.outcome = NoEcho{};
    readings.push_back(reading);
  }
  // A sensor that stands still and jumps between ranges meets both tests.
  for (std::uint32_t k = 0; k < 6; ++k) {
    readings.push_back(test::monostatic_reading({{0.3, -0.2}, degrees(40.0)}, Echo{k < 3 ? 1.0 : 2.2}));
    readings.back().scan = 20 + k;
  }
  SlowNumakura slow;
  Numakura fast({.cell_m = cell_m});
  InlineExecutor executor;
  fast.insert(readings, executor);
  fast.finish(executor);
  for (const Reading& reading : readings) slow.insert(reading);
  for (std::int32_t j = region.j_begin; j < region.j_end; ++j)
    for (std::int32_t i = region.i_begin; i < region.i_end; ++i) {
      const double difference = std::abs(fast.cell_value({i, j}) - slow.value({i, j}));
      if (difference > 0.0) RC_LOG() << i << " " << j << ": " << fast.cell_value({i, j}) << " " << slow.value({i, j});
      RC_ASSERT(difference == 0.0);
    }
}

}  // namespace
}  // namespace echoarc
