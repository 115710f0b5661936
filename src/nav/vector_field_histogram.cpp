// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/vector_field_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echoarc::nav {
namespace {

constexpr std::size_t sectors = VectorFieldHistogram::sector_count;
constexpr double sector_rad = 2.0 * std::numbers::pi / double(sectors);

Angle middle_of(std::size_t sector) {
  return radians((double(sector) + 0.5) * sector_rad);
}

std::array<Vec2, sectors> directions_of_middles() {
  std::array<Vec2, sectors> made;
  for (std::size_t k = 0; k < sectors; ++k) made[k] = unit(middle_of(k));
  return made;
}

/// The sector of a bearing, wrong by one at the most, an order faster than atan2 tells it: 11 degrees' worth of error
/// would be two sectors, the parabola's is 0.3 degrees.
std::size_t sector_near(Vec2 seen) {
  const double x = std::abs(seen.x);
  const double y = std::abs(seen.y);
  const double slope = std::min(x, y) / std::max(x, y);
  double turn = slope * (0.25 * std::numbers::pi + 0.273 * (1.0 - slope));  // atan on [0, 1] to 0.004
  if (y > x) turn = 0.5 * std::numbers::pi - turn;
  if (seen.x < 0.0) turn = std::numbers::pi - turn;
  if (seen.y < 0.0) turn = 2.0 * std::numbers::pi - turn;
  constexpr double per_rad = 1.0 / sector_rad;
  const int sector = static_cast<int>(turn * per_rad);
  return sector < int(sectors) ? static_cast<std::size_t>(sector) : 0;
}

}  // namespace

VectorFieldHistogram::VectorFieldHistogram(const RobotBody& body, const HistogramOptions& options)
    : options_(options),
      body_(body),
      middles_(directions_of_middles()),
      half_sector_sine_(std::sin(0.5 * sector_rad)) {}

void VectorFieldHistogram::reset() {
  closed_.fill(false);
  last_.reset();
}

/// Closes every sector down whose middle the enlarged robot would touch the point: all within +-asin(r / d) of its
/// bearing, and half the circle if the point is within the robot already. A cross product tells as much. The sector of
/// the point itself closes however far it is.
void VectorFieldHistogram::close_around(Vec2 seen, double distance_m, double nearness) {
  const double radius_m = std::max(body_.radius_m + options_.enlarge_m, half_sector_sine_ * distance_m);
  const auto close = [&](std::size_t sector) {
    const Vec2 way = middles_[sector];
    const bool touches = std::abs(cross(way, seen)) <= radius_m && dot(way, seen) > 0.0;
    if (touches && nearness_[sector] < nearness) nearness_[sector] = nearness;
    return touches;
  };
  const std::size_t at = sector_near(seen);
  std::size_t up = at;
  // The first to either side may be the neighbour of the point's own.
  for (bool first = true; close(up) || first; first = false) up = up + 1 == sectors ? 0 : up + 1;
  std::size_t down = at == 0 ? sectors - 1 : at - 1;
  for (bool first = true; close(down) || first; first = false) down = down == 0 ? sectors - 1 : down - 1;
}

void VectorFieldHistogram::weigh(Vec2 position, double heeded_m, std::span<const Vec2> points) {
  nearness_.fill(0.0);
  const double reach_m = std::numbers::sqrt2 * 0.5 * options_.window_m;
  const double far_m = std::min(reach_m, heeded_m);
  for (const Vec2 point : points) {
    const Vec2 seen = point - position;
    const double squared = squared_norm(seen);
    if (!(squared < far_m * far_m) || squared == 0.0) continue;
    const double distance_m = std::sqrt(squared);
    close_around(seen, distance_m, 1.0 - distance_m / reach_m);
  }
}

void VectorFieldHistogram::smooth() {
  const auto reach = static_cast<std::size_t>(std::clamp(options_.smoothing_sectors, 1, 15) / 2);
  const double most = double((reach + 1) * (reach + 1));
  for (std::size_t k = 0; k < sectors; ++k) {
    double sum = double(reach + 1) * nearness_[k];
    for (std::size_t aside = 1; aside <= reach; ++aside)
      sum +=
          double(reach + 1 - aside) * (nearness_[(k + aside) % sectors] + nearness_[(k + sectors - aside) % sectors]);
    smoothed_[k] = sum / most;
  }
}

void VectorFieldHistogram::threshold() {
  for (std::size_t k = 0; k < sectors; ++k) {
    if (smoothed_[k] > options_.close_above) closed_[k] = true;
    if (smoothed_[k] < options_.open_below) closed_[k] = false;
  }
}

/// The direction nearest to `wanted` that keeps off the valley's rims: by half of what is wide, in a narrow one its
/// middle.
Angle VectorFieldHistogram::way_through(const Valley& valley, Angle wanted) const {
  if (valley.size >= sectors) return wanted;
  const Angle middle = radians((double(valley.first) + 0.5 * double(valley.size)) * sector_rad);
  const double wide = double(std::min<std::size_t>(valley.size, std::size_t(std::max(1, options_.wide_sectors))));
  const double aside_most = 0.5 * (double(valley.size) - wide) * sector_rad;
  return wrap(middle + radians(std::clamp(wrap(wanted - middle).rad(), -aside_most, aside_most)));
}

std::optional<Angle> VectorFieldHistogram::choose(Angle wanted) const {
  const auto first_closed = std::ranges::find(closed_, true);
  if (first_closed == closed_.end()) return wanted;
  std::optional<Angle> best;
  double least = 0.0;
  const auto consider = [&](const Valley& valley) {
    const Angle way = way_through(valley, wanted);
    double cost = std::abs(wrap(way - wanted).rad());
    if (last_) cost += options_.keep_way * std::abs(wrap(way - *last_).rad());
    if (best && cost >= least) return;
    best = way;
    least = cost;
  };
  const auto begin = static_cast<std::size_t>(first_closed - closed_.begin());
  Valley valley;
  for (std::size_t k = begin + 1; k <= begin + sectors; ++k) {  // ends on a closed one
    if (!closed_[k % sectors]) {
      if (valley.size++ == 0) valley.first = k;
    } else if (valley.size > 0) {
      consider(valley);
      valley = {};
    }
  }
  return best;
}

std::optional<Heading> VectorFieldHistogram::steer(const Pose2& T_world_base, Vec2 goal, std::span<const Vec2> points) {
  if (!is_finite(T_world_base) || !is_finite(goal)) return {};
  const Vec2 way = goal - T_world_base.position;
  const double radius_m = body_.radius_m + options_.enlarge_m;
  weigh(T_world_base.position, norm(way) + radius_m, points);
  smooth();
  threshold();
  const std::optional<Angle> direction = choose(bearing(way));
  last_ = direction;
  if (!direction) return {};
  return Heading{*direction, std::min(options_.cruise_m_s, body_.limits.speed_m_s)};
}

RobotVelocity VectorFieldHistogram::velocity(const Pose2& T_world_base, const Heading& heading) const {
  const double aside = wrap(heading.direction - T_world_base.heading).rad();
  const double most = body_.limits.turn_rate_per_s.rad();
  const double rate = std::clamp(options_.turn_gain_per_s * aside, -most, most);
  const double share = std::max(0.0, 1.0 - std::abs(aside) / options_.turn_on_spot.rad());
  return {heading.speed_m_s * share, radians(rate)};
}

}  // namespace echoarc::nav
