// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/landmark_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc::nav {
namespace {

constexpr double least_range_m = 1e-3;  // nearer, a bearing means nothing

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  Matrix3 product{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
  return product;
}

/// a p a^T, symmetric to the last bit if `p` is nearly so.
Matrix3 congruent(const Matrix3& a, const Matrix3& p) {
  const Matrix3 left = multiply(a, p);
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += left[i][k] * a[j][k];
      result[j][i] = result[i][j];
    }
  return result;
}

double squared(double x) {
  return x * x;
}

}  // namespace

std::string_view name(Association association) {
  constexpr std::array<std::string_view, 4> names = {"matched", "no_match", "ambiguous", "invalid"};
  return names[static_cast<std::size_t>(association)];
}

LandmarkSighting sighting_of(const Pose2& T_odom_robot, Vec2 point_odom, int supports) {
  const Vec2 seen = inverse(T_odom_robot) * point_odom;
  return {norm(seen), bearing(seen), supports};
}

LandmarkFilter::LandmarkFilter(std::span<const Vec2> landmarks, const LandmarkFilterOptions& options)
    : options_(options) {
  for (const Vec2 landmark : landmarks)
    if (is_finite(landmark)) landmarks_.push_back(landmark);
}

void LandmarkFilter::start_at(const Pose2& T_map_robot, double deviation_m, Angle deviation) {
  if (!is_finite(T_map_robot)) return;
  T_map_robot_ = T_map_robot;
  covariance_ = {};
  covariance_[0][0] = squared(deviation_m);
  covariance_[1][1] = squared(deviation_m);
  covariance_[2][2] = squared(deviation.rad());
}

void LandmarkFilter::move(const Pose2& T_before_now) {
  if (!is_finite(T_before_now)) return;
  const Vec2 step = rotate(T_before_now.position, T_map_robot_.heading);
  const Matrix3 f = {{{1.0, 0.0, -step.y}, {0.0, 1.0, step.x}, {0.0, 0.0, 1.0}}};
  covariance_ = congruent(f, covariance_);
  const StepDeviation deviation = step_deviation(options_.noise, T_before_now);
  const double length_m = norm(step);
  const Vec2 along = length_m > 0.0 ? step / length_m : unit(T_map_robot_.heading);
  const double aa = squared(deviation.along_m);
  const double cc = squared(deviation.across_m);
  covariance_[0][0] += aa * along.x * along.x + cc * along.y * along.y;
  covariance_[1][1] += aa * along.y * along.y + cc * along.x * along.x;
  covariance_[0][1] += (aa - cc) * along.x * along.y;
  covariance_[1][0] = covariance_[0][1];
  covariance_[2][2] += squared(deviation.heading.rad());
  T_map_robot_ = T_map_robot_ * T_before_now;
  T_map_robot_.heading = wrap(T_map_robot_.heading);
}

std::optional<LandmarkFilter::Innovation> LandmarkFilter::innovation(const LandmarkSighting& sighting,
                                                                     Vec2 landmark) const {
  const Vec2 d = landmark - T_map_robot_.position;
  const double range_m = norm(d);
  if (range_m < least_range_m) return std::nullopt;
  const Vec2 u = d / range_m;
  Innovation found;
  found.difference = {sighting.range_m - range_m, wrap(sighting.bearing - (bearing(d) - T_map_robot_.heading)).rad()};
  found.jacobian = {Vec2{-u.x, u.y / range_m}, Vec2{-u.y, -u.x / range_m}, Vec2{0.0, -1.0}};
  // The landmark's own deviation is the same along and across the line of sight.
  const double on_map = squared(options_.landmark_deviation_m);
  found.r = {
      squared(options_.least_range_deviation_m) + squared(options_.range_deviation_m) / sighting.supports + on_map, 0.0,
      squared(options_.least_bearing_deviation.rad()) + squared(options_.bearing_deviation.rad()) / sighting.supports +
          on_map / squared(range_m)};
  found.s = found.r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double p = covariance_[i][j];
      found.s[0] += found.jacobian[i].x * p * found.jacobian[j].x;
      found.s[1] += found.jacobian[i].x * p * found.jacobian[j].y;
      found.s[2] += found.jacobian[i].y * p * found.jacobian[j].y;
    }
  const double determinant = found.s[0] * found.s[2] - squared(found.s[1]);
  if (!(determinant > 0.0)) return std::nullopt;
  found.distance =
      (squared(found.difference.x) * found.s[2] - 2.0 * found.difference.x * found.difference.y * found.s[1] +
       squared(found.difference.y) * found.s[0]) /
      determinant;
  return found;
}

Association LandmarkFilter::observe(const LandmarkSighting& sighting) {
  if (!std::isfinite(sighting.range_m) || sighting.range_m < least_range_m || !is_finite(sighting.bearing) ||
      sighting.supports < 1)
    return Association::invalid;
  std::optional<Innovation> best;
  double rival = std::numeric_limits<double>::infinity();
  for (const Vec2 landmark : landmarks_) {
    const std::optional<Innovation> found = innovation(sighting, landmark);
    if (!found) continue;
    if (!best || found->distance < best->distance) {
      if (best) rival = best->distance;
      best = found;
    } else {
      rival = std::min(rival, found->distance);
    }
  }
  if (!best || best->distance > options_.gate) return Association::no_match;
  if (rival <= options_.gate && rival < options_.rival_ratio * best->distance) return Association::ambiguous;
  correct(*best);
  return Association::matched;
}

void LandmarkFilter::correct(const Innovation& innovation) {
  const auto& [s_rr, s_rb, s_bb] = innovation.s;
  const double determinant = s_rr * s_bb - s_rb * s_rb;
  std::array<Vec2, 3> gain;  // row by row: P H^T S^-1
  for (std::size_t i = 0; i < 3; ++i) {
    Vec2 ph;
    for (std::size_t j = 0; j < 3; ++j) ph = ph + covariance_[i][j] * innovation.jacobian[j];
    gain[i] = Vec2{ph.x * s_bb - ph.y * s_rb, ph.y * s_rr - ph.x * s_rb} / determinant;
  }
  T_map_robot_.position =
      T_map_robot_.position + Vec2{dot(gain[0], innovation.difference), dot(gain[1], innovation.difference)};
  T_map_robot_.heading = wrap(T_map_robot_.heading + radians(dot(gain[2], innovation.difference)));
  // Joseph's form keeps the covariance positive whatever the rounding: (I - K H) P (I - K H)^T + K R K^T.
  Matrix3 keep{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) keep[i][j] = (i == j ? 1.0 : 0.0) - dot(gain[i], innovation.jacobian[j]);
  covariance_ = congruent(keep, covariance_);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      covariance_[i][j] += gain[i].x * innovation.r[0] * gain[j].x + gain[i].y * innovation.r[2] * gain[j].y;
      covariance_[j][i] = covariance_[i][j];
    }
}

Sketch::Spread LandmarkFilter::spread() const {
  PoseCluster cluster;
  cluster.T_map_robot = T_map_robot_;
  cluster.covariance.xx_m2 = covariance_[0][0];
  cluster.covariance.xy_m2 = covariance_[0][1];
  cluster.covariance.yy_m2 = covariance_[1][1];
  return spread_of(cluster);
}

}  // namespace echoarc::nav
