// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/polynomial_fit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace echoarc {
namespace {

Error refused(std::string cause, std::string remedy) {
  return {ErrorCode::bad_value, std::move(cause), "polynomial_degree", std::move(remedy)};
}

/// T_0(u) ... T_(count-1)(u).
void chebyshev(double u, std::span<double> row) {
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = k == 0 ? 1.0 : k == 1 ? u : 2.0 * u * row[k - 1] - row[k - 2];
}

/// A matrix of `columns` columns held column by column, and a right-hand side.
struct LeastSquares {
  std::size_t rows;
  std::size_t columns;
  std::vector<double> matrix;
  std::vector<double> side;

  [[nodiscard]] std::span<double> column(std::size_t k) { return std::span<double>(matrix).subspan(k * rows, rows); }
};

/// x <- x - v (v . x) 2 / (v . v), over the entries from `first` on.
void reflect(std::span<double> x, std::span<const double> v, std::size_t first, double two_over_square) {
  double along = 0.0;
  for (std::size_t i = first; i < x.size(); ++i) along += v[i] * x[i];
  for (std::size_t i = first; i < x.size(); ++i) x[i] -= along * two_over_square * v[i];
}

/// Householder's triangulation, then back substitution. Requires full rank.
std::vector<double> solve(LeastSquares problem) {
  std::vector<double> diagonal(problem.columns);
  std::vector<double> v(problem.rows);
  for (std::size_t k = 0; k < problem.columns; ++k) {
    const std::span<double> column = problem.column(k);
    double square = 0.0;
    for (std::size_t i = k; i < problem.rows; ++i) square += column[i] * column[i];
    diagonal[k] = column[k] > 0.0 ? -std::sqrt(square) : std::sqrt(square);
    std::copy(column.begin() + std::ptrdiff_t(k), column.end(), v.begin() + std::ptrdiff_t(k));
    v[k] -= diagonal[k];
    const double two_over_square = 1.0 / (diagonal[k] * (diagonal[k] - column[k]));
    for (std::size_t other = k + 1; other < problem.columns; ++other)
      reflect(problem.column(other), v, k, two_over_square);
    reflect(problem.side, v, k, two_over_square);
  }
  std::vector<double> solution(problem.columns);
  for (std::size_t k = problem.columns; k-- > 0;) {
    double rest = problem.side[k];
    for (std::size_t other = k + 1; other < problem.columns; ++other)
      rest -= problem.column(other)[k] * solution[other];
    solution[k] = rest / diagonal[k];
  }
  return solution;
}

}  // namespace

Result<PolynomialFit> PolynomialFit::make(std::span<const Vec2> points, int degree) {
  if (degree < 0 || degree > max_degree)
    return refused("a polynomial of degree " + std::to_string(degree),
                   "give a degree from 0 to " + std::to_string(max_degree));
  std::set<double> places;
  for (const Vec2 p : points) {
    if (!is_finite(p)) return refused("a point to fit is not finite", "leave it out");
    if (places.size() <= std::size_t(degree)) places.insert(p.x);
  }
  if (places.size() <= std::size_t(degree))
    return refused("too few points for a polynomial of degree " + std::to_string(degree),
                   "give a lower degree, or let the robot see more of the surface");
  const auto [left, right] = std::ranges::minmax_element(points, {}, &Vec2::x);
  PolynomialFit fit;
  fit.middle_ = 0.5 * (left->x + right->x);
  fit.half_width_ = 0.5 * (right->x - left->x);
  const std::size_t columns = std::size_t(degree) + 1;
  LeastSquares problem{points.size(), columns, std::vector<double>(points.size() * columns), {}};
  std::vector<double> row(columns);
  for (std::size_t i = 0; i < points.size(); ++i) {
    chebyshev(fit.half_width_ > 0.0 ? (points[i].x - fit.middle_) / fit.half_width_ : 0.0, row);
    for (std::size_t k = 0; k < columns; ++k) problem.column(k)[i] = row[k];
    problem.side.push_back(points[i].y);
  }
  fit.coefficients_ = solve(std::move(problem));
  return fit;
}

double PolynomialFit::operator()(double x) const {
  assert(std::isfinite(x));
  std::vector<double> row(coefficients_.size());
  chebyshev(half_width_ > 0.0 ? (x - middle_) / half_width_ : 0.0, row);
  double y = 0.0;
  for (std::size_t k = 0; k < row.size(); ++k) y += coefficients_[k] * row[k];
  return y;
}

std::vector<Vec2> PolynomialFit::sample(double step_m) const {
  assert(step_m > 0.0);
  const auto steps = std::max<std::int64_t>(1, std::int64_t(std::ceil((x_max() - x_min()) / step_m)));
  std::vector<Vec2> points;
  for (std::int64_t k = 0; k <= steps; ++k) {
    const double x = k == steps ? x_max() : x_min() + (x_max() - x_min()) * double(k) / double(steps);
    points.push_back({x, (*this)(x)});
  }
  return points;
}

}  // namespace echoarc
