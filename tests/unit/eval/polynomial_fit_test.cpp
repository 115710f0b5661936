// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/polynomial_fit.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

// The curve of the curved-surface scene.
double curve(double x) {
  return 1.0 + 0.16 * std::cos(2.6 * x + 0.5) - 0.07 * std::sin(4.3 * x);
}

std::vector<Vec2> samples(double from, double to, int count) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) {
    const double x = from + (to - from) * k / (count - 1);
    points.push_back({x, curve(x)});
  }
  return points;
}

TEST(PolynomialFit, IsExactForAPolynomialOfItsDegree) {
  std::vector<Vec2> points;
  for (int k = 0; k <= 40; ++k) {
    const double x = 1000.0 + 0.1 * k;
    const double u = x - 1002.0;
    points.push_back({x, 3.0 - 2.0 * u + 0.25 * u * u * u});
  }
  const auto fit = PolynomialFit::make(points, 3);
  ASSERT_TRUE(fit);
  for (const Vec2 p : points) EXPECT_NEAR((*fit)(p.x), p.y, 1e-12);
  EXPECT_NEAR(fit->x_min(), 1000.0, 1e-9);
  EXPECT_NEAR(fit->x_max(), 1004.0, 1e-9);
}

TEST(PolynomialFit, DegreeNineBridgesAGap) {
  std::vector<Vec2> points = samples(-1.0, -0.1, 300);
  const std::vector<Vec2> right = samples(0.15, 1.0, 300);
  points.insert(points.end(), right.begin(), right.end());
  const auto fit = PolynomialFit::make(points, 9);
  ASSERT_TRUE(fit);
  for (double x = -1.0; x <= 1.0; x += 0.01) EXPECT_NEAR((*fit)(x), curve(x), 0.002);
}

TEST(PolynomialFit, AgreesWithTheNormalEquations) {
  // Twin: Gauss on the normal equations of the monomials, degree 2.
  Rng rng(7);
  std::vector<Vec2> points;
  for (int k = 0; k < 50; ++k) points.push_back({rng.uniform(-1.0, 1.0), rng.normal(0.0, 1.0)});
  double a[3][4] = {};
  for (const Vec2 p : points) {
    const double m[3] = {1.0, p.x, p.x * p.x};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) a[i][j] += m[i] * m[j];
      a[i][3] += m[i] * p.y;
    }
  }
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      if (i != k) {
        const double factor = a[i][k] / a[k][k];
        for (int j = 0; j < 4; ++j) a[i][j] -= factor * a[k][j];
      }
  const auto fit = PolynomialFit::make(points, 2);
  ASSERT_TRUE(fit);
  for (const double x : {-0.9, 0.0, 0.4})
    EXPECT_NEAR((*fit)(x), a[0][3] / a[0][0] + a[1][3] / a[1][1] * x + a[2][3] / a[2][2] * x * x, 1e-9);
}

TEST(PolynomialFit, SamplesFromEndToEnd) {
  const auto fit = PolynomialFit::make(samples(-1.0, 1.0, 30), 5);
  ASSERT_TRUE(fit);
  const std::vector<Vec2> points = fit->sample(0.3);
  ASSERT_EQ(points.size(), 8u);
  EXPECT_EQ(points.front().x, -1.0);
  EXPECT_EQ(points.back().x, 1.0);
}

TEST(PolynomialFit, RefusesWhatHasNoFit) {
  EXPECT_FALSE(PolynomialFit::make({}, 0));
  EXPECT_FALSE(PolynomialFit::make(samples(-1.0, 1.0, 9), 9));
  EXPECT_FALSE(PolynomialFit::make(samples(-1.0, 1.0, 9), -1));
  EXPECT_FALSE(PolynomialFit::make(samples(-1.0, 1.0, 90), 31));
  EXPECT_FALSE(PolynomialFit::make(std::vector<Vec2>(20, {1.0, 2.0}), 1));
  EXPECT_FALSE(PolynomialFit::make(std::vector<Vec2>{{std::numeric_limits<double>::quiet_NaN(), 0.0}}, 0));
}

TEST(PolynomialFit, OnePlaceHasAConstant) {
  const auto fit = PolynomialFit::make(std::vector<Vec2>{{1.0, 2.0}, {1.0, 4.0}}, 0);
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ((*fit)(1.0), 3.0);
}

}  // namespace
}  // namespace echoarc
