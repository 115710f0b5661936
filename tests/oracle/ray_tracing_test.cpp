// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Images against rays: thousands are shot all around and mirrored on what they hit. Where of two neighbours that met
// the same walls one passes the listener on its left and the other on its right, a path lies between them.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/sim/echo_paths.hpp"

namespace echoarc::sim {
namespace {

constexpr int rays = 40'000;
constexpr int max_order = 3;

struct Pass {
  std::vector<std::size_t> walls;
  double miss_m = 0.0;  ///< positive: the listener lies to the left
  double length_m = 0.0;
};

/// After every reflection of a ray: how it passes the listener, if it does so before the next wall.
std::vector<std::optional<Pass>> trace(const std::vector<Wall>& walls, Vec2 origin, Vec2 direction, Vec2 listener) {
  std::vector<std::optional<Pass>> passes;
  std::vector<std::size_t> met;
  double gone_m = 0.0;
  while (true) {
    double nearest_m = 1e9;
    std::size_t hit = walls.size();
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const Vec2 along = walls[w].b - walls[w].a;
      const double den = cross(direction, along);
      const double t = cross(walls[w].a - origin, along) / den;
      const double s = cross(walls[w].a - origin, direction) / den;
      if (t > 1e-9 && t < nearest_m && s >= 0.0 && s <= 1.0) {
        nearest_m = t;
        hit = w;
      }
    }
    const double ahead_m = dot(listener - origin, direction);
    passes.emplace_back();
    if (ahead_m > 0.0 && ahead_m < nearest_m)
      passes.back() = Pass{met, cross(direction, listener - origin), gone_m + ahead_m};
    if (hit == walls.size() || met.size() == max_order) return passes;
    met.push_back(hit);
    gone_m += nearest_m;
    origin = origin + nearest_m * direction;
    const Vec2 along = walls[hit].b - walls[hit].a;
    direction = 2.0 * dot(direction, along) / dot(along, along) * along - direction;
  }
}

std::vector<Pass> traced_paths(const std::vector<Wall>& walls, Vec2 sender, Vec2 listener) {
  std::vector<Pass> found;
  auto before = trace(walls, sender, unit(Angle{}), listener);
  for (int i = 1; i <= rays; ++i) {
    auto here = trace(walls, sender, unit(radians(2.0 * std::numbers::pi * i / rays)), listener);
    for (std::size_t k = 1; k < std::min(before.size(), here.size()); ++k) {
      if (!before[k] || !here[k] || before[k]->walls != here[k]->walls || before[k]->miss_m * here[k]->miss_m > 0.0)
        continue;
      const double share = before[k]->miss_m / (before[k]->miss_m - here[k]->miss_m);
      found.push_back({here[k]->walls, 0.0, before[k]->length_m + share * (here[k]->length_m - before[k]->length_m)});
    }
    before = std::move(here);
  }
  return found;
}

TEST(RayTracing, FindsTheSamePaths) {
  Rng rng(21);
  std::size_t in_both = 0;
  std::size_t by_images = 0;
  for (int round = 0; round < 8; ++round) {
    std::vector<Wall> walls{
        {{-4.0, -3.0}, {4.0, -3.0}}, {{4.0, -3.0}, {4.0, 3.0}}, {{4.0, 3.0}, {-4.0, 3.0}}, {{-4.0, 3.0}, {-4.0, -3.0}}};
    for (int i = 0; i < 4; ++i) {
      const Vec2 a{rng.uniform(-3.5, 3.5), rng.uniform(-2.5, 2.5)};
      walls.push_back({a, a + rng.uniform(0.3, 2.0) * unit(degrees(rng.uniform(0.0, 360.0)))});
    }
    const Vec2 sender{rng.uniform(-3.0, 3.0), rng.uniform(-2.0, 2.0)};
    const Vec2 listener{rng.uniform(-3.0, 3.0), rng.uniform(-2.0, 2.0)};
    const auto traced = traced_paths(walls, sender, listener);
    const World world = World::make({.walls = walls}).value();
    PathFinder finder(world);
    const Angle all_round = degrees(180.0);
    const auto found = finder.find({sender, {}, all_round}, {listener, {}, all_round},
                                   {.max_order = max_order, .max_length_m = 100.0});
    const auto same = [](const EchoPath& path, const Pass& pass) {
      const bool planes =
          path.cause == EchoCause::wall || path.cause == EchoCause::corner || path.cause == EchoCause::multiple;
      return planes && path.reflections == pass.walls.size() && std::abs(path.length_m - pass.length_m) < 1e-5;
    };
    for (const Pass& pass : traced)
      EXPECT_TRUE(std::ranges::any_of(found, [&](const EchoPath& path) { return same(path, pass); }))
          << "order " << pass.walls.size() << ", " << pass.length_m << " m, round " << round;
    for (const EchoPath& path : found) {
      if (path.cause == EchoCause::edge || path.cause == EchoCause::wall_edge) continue;
      ++by_images;
      in_both += std::ranges::any_of(traced, [&](const Pass& pass) { return same(path, pass); }) ? 1 : 0;
    }
  }
  EXPECT_GT(by_images, 100);
  // Rays miss a path that fits between two of them.
  EXPECT_GE(static_cast<double>(in_both), 0.98 * static_cast<double>(by_images));
}

}  // namespace
}  // namespace echoarc::sim
