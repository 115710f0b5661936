// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "echoarc/core/arc.hpp"
#include "echoarc/mapping/bayes_update.hpp"

namespace echoarc {

/// The square of an angle from its cosine without an inverse function:
///
///     theta^2 = 4 asin^2(sqrt(y)) = sum_n c_n y^n,  y = (1 - cos theta) / 2,  c_1 = 4,  c_n+1 = c_n 4 n^2 /
///     ((2n+1)(2n+2))
///
/// with as many terms as the largest angle needs for `error` (6 for a beam of 25 degrees).
class SquaredAngle {
 public:
  static constexpr double error = 1e-12;  ///< relative to the square of the largest angle

  explicit SquaredAngle(Angle largest) {
    const double y = 0.5 * (1.0 - cos(largest));
    const double target = error * largest.rad() * largest.rad() * (1.0 - y);  // the rest is at most a geometric series
    double term = 4.0 * y;
    coefficients_[0] = 4.0;
    for (terms_ = 1; terms_ < coefficients_.size() && term > target; ++terms_) {
      const double n = double(terms_);
      coefficients_[terms_] = coefficients_[terms_ - 1] * 4.0 * n * n / ((2.0 * n + 1.0) * (2.0 * n + 2.0));
      term = coefficients_[terms_] * std::pow(y, n + 1.0);
    }
  }
  [[nodiscard]] double from_cosine(double cosine) const {
    const double y = 0.5 * (1.0 - cosine);
    double sum = 0.0;
    for (std::size_t n = terms_; n-- > 0;) sum = (sum + coefficients_[n]) * y;
    return std::max(sum, 0.0);
  }

 private:
  std::array<double, 48> coefficients_{};
  std::size_t terms_ = 0;
};

/// What one reading says about one point: [Barshan07] eqs. 1 to 6.
struct BayesTerms {
  double sigma_m = 0.0;         ///< distance from the sensor; half the path for a bistatic reading
  double theta_sq = 0.0;        ///< square of the angle from the axis, rad^2
  double range_empty = 0.0;     ///< E_r
  double range_occupied = 0.0;  ///< O_r
  double angular = 0.0;         ///< E_a = O_a

  [[nodiscard]] double empty() const { return range_empty * angular; }        // eq. 1
  [[nodiscard]] double occupied() const { return range_occupied * angular; }  // eq. 4
};

/// The two densities of one reading.
class BayesDensity {
 public:
  BayesDensity(const Arc& arc, double near_field_m, double range_error_m)
      : centre_(arc.centre()),
        transmitter_(arc.transmitter()),
        receiver_(arc.receiver()),
        axis_(unit(arc.axis())),
        circular_(arc.is_circular()),
        range_m_(arc.range_m()),
        near_field_m_(near_field_m),
        empty_end_m_(arc.range_m() - range_error_m),
        per_empty_depth_(1.0 / (empty_end_m_ - near_field_m)),
        per_range_error_(1.0 / range_error_m),
        per_half_width_sq_(1.0 / (arc.half_width().rad() * arc.half_width().rad())),
        squared_angle_(arc.half_width()) {}

  /// At a point inside the beam, other than the centre of the arc.
  [[nodiscard]] BayesTerms at(Vec2 p) const {
    const Vec2 offset = p - centre_;
    const double distance = std::sqrt(squared_norm(offset));
    BayesTerms terms;
    terms.sigma_m = circular_
                        ? distance
                        : 0.5 * (std::sqrt(squared_norm(p - transmitter_)) + std::sqrt(squared_norm(p - receiver_)));
    terms.theta_sq = squared_angle_.from_cosine(dot(offset, axis_) / distance);
    terms.angular = std::max(0.0, 1.0 - terms.theta_sq * per_half_width_sq_);  // eqs. 3 and 6
    terms.range_empty = range_empty(terms.sigma_m);
    terms.range_occupied = range_occupied(terms.sigma_m);
    return terms;
  }

 private:
  [[nodiscard]] double range_empty(double sigma_m) const {               // eq. 2
    if (sigma_m < near_field_m_ || sigma_m >= empty_end_m_) return 0.0;  // at the end the parabola is 0
    const double x = (sigma_m - near_field_m_) * per_empty_depth_;
    return std::max(0.0, 1.0 - x * x);
  }
  [[nodiscard]] double range_occupied(double sigma_m) const {  // eq. 5
    const double x = (sigma_m - range_m_) * per_range_error_;
    return std::max(0.0, 1.0 - x * x);
  }

  Vec2 centre_;
  Vec2 transmitter_;
  Vec2 receiver_;
  Vec2 axis_;
  bool circular_;
  double range_m_;
  double near_field_m_;
  double empty_end_m_;  // r - r_epsilon
  double per_empty_depth_;
  double per_range_error_;
  double per_half_width_sq_;
  SquaredAngle squared_angle_;
};

/// [Barshan07] eqs. 7 and 8: evidence gathers as the probability of "at least one".
[[nodiscard]] inline BayesCell updated(BayesCell cell, const BayesTerms& terms) {
  const double q_empty = terms.empty();
  const double q_occupied = terms.occupied();
  return {cell.empty + q_empty - cell.empty * q_empty, cell.occupied + q_occupied - cell.occupied * q_occupied};
}

}  // namespace echoarc
