// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/sim/echo_paths.hpp"
#include "sim/world_model.hpp"

namespace echoarc::sim {

/// A place of a transducer with the window it hears in.
struct Ear {
  Vec2 position;
  Vec2 axis;
  double cos_window = -1.0;

  explicit Ear(const Transducer& transducer);
  [[nodiscard]] bool hears(Vec2 point) const;
};

/// One ping: who sends, who listens, what is wanted, what was found.
struct PingSearch {
  PingSearch(const WorldModel& world_model, const Transducer& transmitter, const Transducer& receiver,
             const PathLimits& path_limits, std::span<const Disc> moving_discs, std::vector<EchoPath>& found)
      : world(world_model),
        sender(transmitter),
        listener(receiver),
        limits(path_limits),
        moving(moving_discs),
        paths(found) {}

  const WorldModel& world;
  Ear sender;
  Ear listener;
  const PathLimits& limits;
  std::span<const Disc> moving;
  std::vector<EchoPath>& paths;

  [[nodiscard]] bool sees(Vec2 a, Vec2 b) const { return world.visible(a, b, moving); }
  /// Adds sender -> first -> ... -> last -> listener.
  void add(Vec2 first, Vec2 last, double length_m, double gain_db, EchoCause cause, std::size_t reflections);
};

/// A wall that mirrors a source: its image, and where on the wall a listener sees it.
struct Mirror {
  Vec2 a;
  Vec2 direction;  ///< from a to b, unit
  double length_m = 0.0;
  bool one_sided = false;

  explicit Mirror(const Wall& wall);
  /// Distance from the wall's line, positive on the left.
  [[nodiscard]] double side(Vec2 p) const { return cross(direction, p - a); }
  /// Whether a source stands where the wall mirrors it. A source on the wall's line makes no echo.
  [[nodiscard]] bool reflects(Vec2 source) const;
  [[nodiscard]] Vec2 image(Vec2 source) const { return source - 2.0 * side(source) * perpendicular(direction); }
  /// Where a straight line from `target` to the image `image` meets the wall; false: beside it, or from behind.
  [[nodiscard]] bool bounce(Vec2 target, Vec2 image, Vec2& point) const;
};

void find_edge_paths(PingSearch& ping);
void find_wall_edge_paths(PingSearch& ping);
void find_bump_paths(PingSearch& ping);
void find_curve_paths(PingSearch& ping);
void find_disc_paths(PingSearch& ping);
void find_plane_paths(PingSearch& ping);
/// The echo of one disc, if it has one.
void find_disc_path(PingSearch& ping, const Disc& disc);
/// Sorts by length and keeps one of those that are the same path.
void order_paths(std::vector<EchoPath>& paths);

}  // namespace echoarc::sim
