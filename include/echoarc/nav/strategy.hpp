// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/core/robot_motion.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::nav {

class VoronoiGraph;

/// The body that is steered: a disc around the origin of its base, whose x axis is the direction of travel.
struct RobotBody {
  double radius_m = 0.225;
  RobotLimits limits;
};

/// What a strategy sees of one moment. Spans and the map belong to the caller and hold during the call alone.
struct Surroundings {
  double time_s = 0.0;
  Pose2 T_world_base;
  RobotVelocity velocity;
  std::span<const Vec2> points;               ///< obstacles near the robot, world, m, as some mapping method gives them
  const DenseGrid<CellState>* map = nullptr;  ///< of the whole place so far; null: none is made
  std::uint64_t map_version = 0;              ///< changes whenever `map` does
};

enum class Status : std::uint8_t { running, finished, failed };
[[nodiscard]] std::string_view name(Status status);  ///< "running", "finished", "failed"

/// What a strategy wants of this moment. Once it has finished or failed it wants a halt for ever after.
struct Steering {
  RobotVelocity wanted;
  Status status = Status::running;
  std::string reason;                  ///< for people: why it ended, or what it is doing ("tracing", "turning away")
  std::optional<WallSide> followed{};  ///< the wall that is followed, if one is
};

/// What a strategy has in mind, to be drawn, world frame, m.
struct Sketch {
  struct Node {
    Vec2 place;
    std::string kind;  ///< "meet", "boundary", "frontier", "goal"
  };
  struct Spread {  ///< an estimate of position: centre and standard deviation along two axes
    Pose2 T_world_axes;
    Vec2 deviation_m;
  };
  std::vector<Node> nodes;
  std::vector<std::vector<Vec2>> edges;
  std::vector<Vec2> path;  ///< planned way from here
  std::optional<Spread> estimate;
};

/// Somebody who drives a robot by what its sonars tell: surroundings in, velocity out. Knows neither robot nor clock;
/// the same surroundings give the same steering. Called at a steady rate, 10 to 20 times a second.
class Strategy {
 public:
  virtual ~Strategy() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual Steering update(const Surroundings& surroundings) = 0;
  [[nodiscard]] virtual Sketch sketch() const { return {}; }
  /// The graph that it makes of the place; null for one that makes none. See nav/voronoi_graph.hpp.
  [[nodiscard]] virtual const VoronoiGraph* voronoi_graph() const { return nullptr; }
};

}  // namespace echoarc::nav
