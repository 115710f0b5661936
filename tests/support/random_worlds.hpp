// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/rng.hpp"
#include "echoarc/sim/echo_paths.hpp"

namespace echoarc::sim {

/// Walls at random, in pieces that meet at right angles or not, some of them one-sided; discs; on demand bumps.
inline WorldDescription random_world(Rng& rng, int walls, bool rough, bool one_sided) {
  WorldDescription d{.materials = {{.loss_db = 0.5}, {.loss_db = 1.0}}, .seed = rng.next()};
  if (rough) d.materials[1].rough_db = -18.0;
  if (rough) d.materials[1].rough_pitch_m = 0.2;
  Vec2 pen{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)};
  for (int i = 0; i < walls; ++i) {
    if (rng.uniform() < 0.4) pen = {rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)};
    const Angle heading =
        rng.uniform() < 0.7 ? degrees(90.0 * static_cast<double>(rng.below(4))) : degrees(rng.uniform(0.0, 360.0));
    const Vec2 next = pen + rng.uniform(0.2, 3.0) * unit(heading);
    d.walls.push_back({pen, next, static_cast<MaterialId>(rng.below(2)), one_sided && rng.uniform() < 0.5});
    pen = next;
  }
  for (int i = 0; i < 3; ++i)
    d.discs.push_back({{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)}, rng.uniform(0.05, 0.4)});
  return d;
}

/// Rooms wall to wall with doors, the robot's usual world.
inline WorldDescription random_rooms(Rng& rng) {
  WorldDescription d;
  for (int k = 0; k <= 3; ++k)
    for (int i = 0; i < 3; ++i) {
      const double line = 3.0 * k - 4.5;
      const double from = 3.0 * i - 4.5;
      const double door = rng.uniform(0.3, 1.7);
      const auto put = [&](double a, double b) {
        d.walls.push_back({{line, from + a}, {line, from + b}});
        d.walls.push_back({{from + a, line}, {from + b, line}});
      };
      if (rng.uniform() < 0.5)
        put(0.0, 3.0);
      else {
        put(0.0, door);
        put(door + 0.9, 3.0);
      }
    }
  return d;
}

inline Transducer random_ear(Rng& rng, Angle half_window) {
  return {{rng.uniform(-4.0, 4.0), rng.uniform(-4.0, 4.0)}, degrees(rng.uniform(-180.0, 180.0)), half_window};
}

}  // namespace echoarc::sim
