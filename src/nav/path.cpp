// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "nav/cells_on_way.hpp"

namespace echoarc::nav {
namespace {

constexpr double look_ahead_m = 8.0;
// Beyond a point that cannot be reached straight, another one often can; so many are tried.
constexpr int tries = 8;
// A sum of lengths over cells errs by less, relatively.
constexpr double rounding = 1e-9;

}  // namespace

double length_m(std::span<const Vec2> path) {
  double sum_m = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) sum_m += norm(path[k] - path[k - 1]);
  return sum_m;
}

bool in_sight(const DenseGrid<CellState>& map, Vec2 a, Vec2 b) {
  if (!is_finite(a) || !is_finite(b)) return false;
  return for_cells_on_way(map.geometry(), a, b,
                          [&](Cell c, double) { return map.box().contains(c) && map.at(c) != CellState::occupied; });
}

std::optional<double> straight_cost(const DenseGrid<float>& cost_per_m, Vec2 a, Vec2 b) {
  if (!is_finite(a) || !is_finite(b)) return std::nullopt;
  double cost = 0.0;
  const bool clear = for_cells_on_way(cost_per_m.geometry(), a, b, [&](Cell c, double length_m) {
    if (!cost_per_m.box().contains(c) || cost_per_m.at(c) <= 0.0F) return false;
    cost += length_m * double(cost_per_m.at(c));
    return true;
  });
  return clear ? std::optional(cost) : std::nullopt;
}

std::optional<double> path_cost(const DenseGrid<float>& cost_per_m, std::span<const Vec2> path) {
  double sum = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const std::optional<double> cost = straight_cost(cost_per_m, path[k - 1], path[k]);
    if (!cost) return std::nullopt;
    sum += *cost;
  }
  return sum;
}

std::vector<Vec2> shortcut(const DenseGrid<float>& cost_per_m, std::span<const Vec2> path) {
  std::vector<Vec2> shorter;
  if (path.empty()) return shorter;
  shorter.push_back(path.front());
  for (std::size_t anchor = 0; anchor + 1 < path.size();) {
    std::size_t best = anchor + 1;
    double cost = straight_cost(cost_per_m, path[anchor], path[best]).value_or(0.0);
    int failures = 0;
    for (std::size_t k = anchor + 2; k < path.size() && failures < tries; ++k) {
      if (norm(path[k] - path[anchor]) > look_ahead_m) break;
      const std::optional<double> leg = straight_cost(cost_per_m, path[k - 1], path[k]);
      if (!leg) break;
      cost += *leg;
      const std::optional<double> straight = straight_cost(cost_per_m, path[anchor], path[k]);
      if (straight && *straight <= cost * (1.0 + rounding))
        best = k, failures = 0;
      else
        ++failures;
    }
    shorter.push_back(path[best]);
    anchor = best;
  }
  return shorter;
}

std::optional<PathPlace> nearest_place(std::span<const Vec2> path, Vec2 p, double begin_m, double end_m) {
  if (path.empty()) return std::nullopt;
  std::optional<PathPlace> nearest;
  double along_m = 0.0;
  for (std::size_t k = 0; k + 1 < path.size() && (along_m <= end_m || !nearest); ++k) {
    const Vec2 leg = path[k + 1] - path[k];
    const double leg_m = norm(leg);
    const double low_m = std::clamp(begin_m - along_m, 0.0, leg_m);
    const double high_m = std::clamp(end_m - along_m, low_m, leg_m);
    const bool within = along_m + leg_m >= begin_m || k + 2 == path.size();
    if (within) {
      const Vec2 direction = leg_m > 0.0 ? leg / leg_m : Vec2{};
      const double t_m = std::clamp(dot(p - path[k], direction), low_m, high_m);
      const Vec2 place = path[k] + t_m * direction;
      const double distance_m = norm(p - place);
      if (!nearest || distance_m < nearest->distance_m) nearest = PathPlace{k, along_m + t_m, place, distance_m};
    }
    along_m += leg_m;
  }
  if (!nearest) nearest = PathPlace{0, 0.0, path.front(), norm(p - path.front())};
  return nearest;
}

Vec2 point_at(std::span<const Vec2> path, double along_m) {
  assert(!path.empty());
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const double leg_m = norm(path[k + 1] - path[k]);
    if (along_m <= leg_m && leg_m > 0.0) return path[k] + std::max(along_m, 0.0) / leg_m * (path[k + 1] - path[k]);
    along_m -= leg_m;
  }
  return path.back();
}

}  // namespace echoarc::nav
