// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"

namespace echoarc {

/// y as a polynomial of x, least squares over points ([Barshan07] 4.2 fits one of degree 9 to a laser's profile).
/// Worked out in x scaled to [-1, 1] and in Chebyshev's polynomials, where degree 9 costs no digits.
class PolynomialFit {
 public:
  static constexpr int max_degree = 30;

  /// Errors: a degree outside 0 ... `max_degree`, coordinates that are not finite, fewer than degree + 1 different x.
  [[nodiscard]] static Result<PolynomialFit> make(std::span<const Vec2> points, int degree);

  /// Requires a finite x; far outside [x_min, x_max] the value means nothing.
  [[nodiscard]] double operator()(double x) const;
  [[nodiscard]] double x_min() const { return middle_ - half_width_; }
  [[nodiscard]] double x_max() const { return middle_ + half_width_; }
  /// (x, y) from x_min to x_max, both included, at steps of at most `step_m` in x. Requires step_m > 0.
  [[nodiscard]] std::vector<Vec2> sample(double step_m) const;

 private:
  double middle_ = 0.0;
  double half_width_ = 0.0;
  std::vector<double> coefficients_;  // of T_0, T_1, ...
};

}  // namespace echoarc
