// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/ping_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace echoarc::sim {

namespace {

constexpr double touch_m = 1e-9;

bool same_path(const EchoPath& a, const EchoPath& b) {
  const auto near = [](Angle x, Angle y) { return abs(wrap(x - y)).rad() <= 1e-9; };
  return a.cause == b.cause && near(a.departure, b.departure) && near(a.arrival, b.arrival);
}

}  // namespace

Ear::Ear(const Transducer& transducer)
    : position(transducer.position),
      axis(unit(transducer.axis)),
      cos_window(transducer.half_window.rad() >= std::numbers::pi ? -2.0 : cos(transducer.half_window)) {}

bool Ear::hears(Vec2 point) const {
  const Vec2 way = point - position;
  const double distance_m = std::sqrt(squared_norm(way));
  return distance_m > touch_m && dot(way, axis) >= cos_window * distance_m;
}

void PingSearch::add(Vec2 first, Vec2 last, double length_m, double gain_db, EchoCause cause, std::size_t reflections) {
  paths.push_back({length_m, bearing(first - sender.position), bearing(last - listener.position), gain_db, cause,
                   static_cast<std::uint8_t>(reflections)});
}

Mirror::Mirror(const Wall& wall) : a(wall.a), direction(wall.b - wall.a), one_sided(wall.one_sided) {
  length_m = norm(direction);
  direction = direction / length_m;
}

bool Mirror::reflects(Vec2 source) const {
  const double s = side(source);
  return one_sided ? s > touch_m : std::abs(s) > touch_m;
}

bool Mirror::bounce(Vec2 target, Vec2 image, Vec2& point) const {
  const double behind = side(image);
  const double before = side(target);
  // In an apex the target lies on the wall itself, give or take the rounding.
  if ((behind < 0.0 ? before : -before) < -touch_m) return false;
  point = target + before / (before - behind) * (image - target);
  const double along = dot(point - a, direction);
  return along >= -touch_m && along <= length_m + touch_m;
}

void order_paths(std::vector<EchoPath>& paths) {
  std::ranges::sort(paths, {}, [](const EchoPath& p) {
    return std::tuple(p.length_m, p.cause, p.departure.rad(), p.arrival.rad(), -p.gain_db);
  });
  std::size_t kept = 0;
  for (const EchoPath& path : paths) {
    std::size_t other = kept;
    while (other > 0 && path.length_m - paths[other - 1].length_m <= touch_m && !same_path(path, paths[other - 1]))
      --other;
    if (other > 0 && path.length_m - paths[other - 1].length_m <= touch_m)
      paths[other - 1].gain_db = std::max(paths[other - 1].gain_db, path.gain_db);
    else
      paths[kept++] = path;
  }
  paths.resize(kept);
}

}  // namespace echoarc::sim
