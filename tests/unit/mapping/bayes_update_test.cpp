// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/bayes_update.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mapping/bayes_density.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

constexpr double r_min_m = 0.057;
constexpr double r_epsilon_m = 0.02;

/// The terms at distance sigma and angle theta from a sensor at the origin that looks along +x.
BayesTerms terms_at(double range_m, double sigma_m, double theta_deg) {
  const Arc arc = Arc::circular({0, 0}, Angle{}, range_m, degrees(25.0));
  return BayesDensity(arc, r_min_m, r_epsilon_m).at(sigma_m * unit(degrees(theta_deg)));
}

// V3.4 of the method specification.
TEST(BayesDensity, WorkedNumbers) {
  const struct {
    double sigma_m, theta_deg, empty, occupied;
  } rows[] = {{0.5, 0, 0.769642, 0}, {0.5, 5, 0.646499, 0}, {0.95, 0, 0.063949, 0}, {1.0, 0, 0, 1},   {1.0, 5, 0, 0.84},
              {1.01, 5, 0, 0.63},    {0.99, -10, 0, 0.27},  {0.98, 0, 0, 0},        {1.0, 12.5, 0, 0}};
  for (const auto& row : rows) {
    const BayesTerms terms = terms_at(1.0, row.sigma_m, row.theta_deg);
    EXPECT_NEAR(terms.empty(), row.empty, row.empty > 0 ? 5e-7 : 1e-12) << row.sigma_m << " m " << row.theta_deg;
    EXPECT_NEAR(terms.occupied(), row.occupied, row.occupied > 0 ? 5e-7 : 1e-12)
        << row.sigma_m << " m " << row.theta_deg;
  }
}

// V3.5 of the method specification.
TEST(BayesDensity, UpdateSequence) {
  const struct {
    double range_m, theta_deg, occupied, value;
  } rows[] = {{1.0, 2, 0.9744, 0.9872}, {1.005, -4, 0.995942, 0.997971}, {0.995, 6, 0.998870, 0.999435}};
  BayesCell cell;
  for (const auto& row : rows) {
    cell = updated(cell, terms_at(row.range_m, 1.0, row.theta_deg));
    EXPECT_NEAR(cell.occupied, row.occupied, 5e-7);
    EXPECT_NEAR(bayes_value(cell, BayesCombination::difference), row.value, 5e-7);
  }
  cell = updated(cell, terms_at(2.0, 1.0, 3));
  EXPECT_NEAR(cell.empty, 0.715779, 5e-7);
  EXPECT_NEAR(bayes_value(cell, BayesCombination::difference), 0.641545, 1e-6);
  EXPECT_NEAR(bayes_value(cell, BayesCombination::moravec_elfes), 0.999435, 5e-7);
  EXPECT_NEAR(bayes_value(cell, BayesCombination::ratio), 0.998870 / (0.998870 + 0.715779), 1e-6);
}

TEST(BayesDensity, NothingIsEmptyWhereTheArcIsNearerThanTheNearField) {
  EXPECT_EQ(terms_at(0.07, 0.05, 0).empty(), 0.0);  // r - r_epsilon < r_min: the parabola has no width
  EXPECT_EQ(terms_at(r_min_m + r_epsilon_m, 0.057, 0).empty(), 0.0);
  EXPECT_GT(terms_at(0.07, 0.06, 0).occupied(), 0.0);
}

TEST(SquaredAngle, StaysWithinItsStatedError) {
  for (const double half_deg : {0.5, 5.0, 12.5, 45.0, 80.0}) {
    const SquaredAngle squared_angle(degrees(half_deg));
    for (int k = 0; k <= 100; ++k) {
      const Angle theta = degrees(half_deg * k / 100.0);
      const double expected = theta.rad() * theta.rad();
      // The cosine itself is known to half an ulp: 2.2e-16 of y stands for 4 times as much of theta^2.
      const double tolerance = SquaredAngle::error * std::pow(degrees(half_deg).rad(), 2) + 1e-15;
      EXPECT_NEAR(squared_angle.from_cosine(cos(theta)), expected, tolerance) << half_deg << " " << theta.deg();
    }
  }
}

// V8.2 of the method specification.
TEST(BayesUpdate, OneReading) {
  BayesUpdate method({.cell_m = 0.01, .origin_x_m = -0.5, .origin_y_m = 0.0});
  InlineExecutor executor;
  const Reading reading = test::monostatic_reading({{0.005, 0.005}, degrees(90.0)}, Echo{1.003});
  method.insert(std::span(&reading, 1), executor);
  double empty = 0.0;
  double occupied = 0.0;
  int empty_cells = 0;
  int occupied_cells = 0;
  method.map().for_each_nonzero([&](Cell, const BayesCell& cell) {
    empty += cell.empty;
    occupied += cell.occupied;
    empty_cells += cell.empty > 0.0 ? 1 : 0;
    occupied_cells += cell.occupied > 0.0 ? 1 : 0;
  });
  EXPECT_NEAR(empty, 726.316669, 5e-7);
  EXPECT_EQ(empty_cells, 2099);
  EXPECT_NEAR(occupied, 77.534197, 5e-7);
  EXPECT_EQ(occupied_cells, 174);
}

TEST(BayesUpdate, ThresholdIsStrictAndUntouchedCellsAreUnknown) {
  BayesUpdate method({.threshold = 0.5});
  EXPECT_EQ(method.state({}), CellState::unknown);
  EXPECT_EQ(method.value({3, 4}), 0.5);
  EXPECT_EQ(method.state({.empty = 0.2, .occupied = 0.2}), CellState::unknown);
  EXPECT_EQ(method.state({.empty = 0.2, .occupied = 0.3}), CellState::occupied);
  EXPECT_EQ(method.state({.empty = 0.3, .occupied = 0.2}), CellState::free);
}

TEST(BayesUpdate, TraceTellsTheTermsAndWhatInsertWillDo) {
  BayesUpdate method;
  InlineExecutor executor;
  Reading reading = test::monostatic_reading({{0.1, 0.2}, degrees(31.0)}, Echo{0.9});
  method.insert(std::span(&reading, 1), executor);
  reading.T_world_rx.position = reading.T_world_rx.position + Vec2{0.05, -0.08};
  reading.rx = 1;  // bistatic
  const Trace trace = method.trace(reading);
  ASSERT_FALSE(trace.cells.empty());
  std::vector<double> before;
  for (const CellChange& change : trace.cells) before.push_back(method.value(change.cell));
  method.insert(std::span(&reading, 1), executor);
  for (std::size_t k = 0; k < trace.cells.size(); ++k) {
    const CellChange& change = trace.cells[k];
    EXPECT_EQ(change.before, before[k]);
    EXPECT_EQ(change.after, method.value(change.cell));
    ASSERT_EQ(change.terms.size(), 8U);
    EXPECT_EQ(change.terms[6].name, "p_E");
    EXPECT_DOUBLE_EQ(change.terms[6].value, change.terms[2].value * change.terms[3].value);
    EXPECT_DOUBLE_EQ(change.terms[7].value, change.terms[4].value * change.terms[5].value);
  }
}

TEST(BayesUpdate, SupportIsEvidenceForOccupied) {
  const BayesUpdate method;
  const Reading reading = test::monostatic_reading({{0.0, 0.0}, Angle{}}, Echo{1.0});
  EXPECT_TRUE(method.supports(reading, {1.001, 0.002}));
  EXPECT_FALSE(method.supports(reading, {0.5, 0.0})) << "only empty";
  EXPECT_FALSE(method.supports(reading, {0.0, 1.0})) << "outside the beam";
  EXPECT_FALSE(method.supports(test::monostatic_reading({}, NoEcho{}), {1.0, 0.0}));
}

}  // namespace
}  // namespace echoarc
