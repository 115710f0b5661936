// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/nav/voronoi_exploration.hpp"
#include "nav/near_points.hpp"
#include "nav/node_memory.hpp"
#include "nav/voronoi_driving.hpp"

namespace echoarc::nav {

/// Holds every moment against the one before: what no robot can do is a fault of its pose.
class MomentGuard {
 public:
  /// Why this moment cannot follow the last one; empty if it can.
  [[nodiscard]] std::string check(const Surroundings& now, const RobotLimits& limits);
  [[nodiscard]] double passed_s() const { return passed_s_; }

 private:
  std::optional<Pose2> T_world_last_;
  double last_s_ = 0.0;
  double passed_s_ = 0.0;
};

/// Says when a robot has not left a circle of a decimetre for long.
class StandstillWatch {
 public:
  void restart(Vec2 place) { anchor_ = place, still_s_ = 0.0; }
  [[nodiscard]] bool is_stuck(Vec2 place, double passed_s, double patience_s);

 private:
  Vec2 anchor_;
  double still_s_ = 0.0;
};

/// The states of VoronoiExploration.
class VoronoiExploration::Explorer {
 public:
  Explorer(const RobotBody& body, const VoronoiExplorationOptions& options, const TracerOptions& tracer,
           const ObstacleOptions& obstacles);
  [[nodiscard]] Steering update(const Surroundings& now);
  [[nodiscard]] Sketch sketch() const;
  [[nodiscard]] const VoronoiGraph& graph() const { return graph_; }

 private:
  enum class State { look, access, trace, settle, go };
  struct Departure {
    int node = 0;
    Angle way;
  };

  // One step in each state: the wanted velocity.
  RobotVelocity act(const Surroundings& now);
  RobotVelocity look(const Surroundings& now);
  RobotVelocity access(const Surroundings& now);
  RobotVelocity trace(const Surroundings& now);
  RobotVelocity settle(const Surroundings& now);
  RobotVelocity go(const Surroundings& now);

  void enter(State state, Vec2 place);
  void depart(int node, const Pose2& T_world_base);
  void arrive(const NodeSight& sight, const Pose2& T_world_base);  // at a meet point
  void end_edge(const Pose2& T_world_base);                        // at a boundary point
  void link(int node);
  void miss();
  void look_at_node(const Surroundings& now);
  [[nodiscard]] bool is_known_end(Vec2 place) const;
  bool close_loop(const Pose2& T_world_base);
  void next(int node, const Pose2& T_world_base);
  void retreat(const Pose2& T_world_base);
  void abandon(const std::string& why, const Pose2& T_world_base);
  void unstick(const Pose2& T_world_base);
  void finish();
  void fail(const std::string& why) { ended_ = Steering{{}, Status::failed, why}; }
  [[nodiscard]] std::size_t way_index(const Departure& departure) const;
  [[nodiscard]] std::string_view doing() const;

  RobotBody body_;
  VoronoiExplorationOptions options_;
  VoronoiTracer tracer_;
  VoronoiGraph graph_;
  MomentGuard guard_;
  StandstillWatch watch_;
  LineFollower follower_;
  NearPoints near_points_;
  NodeMemory memory_;
  std::map<std::pair<int, double>, int> misses_;  // of ways: node and bearing
  State state_ = State::look;
  State after_look_ = State::access;
  std::optional<Departure> departure_;  // none while no node is known behind
  std::optional<Steering> ended_;
  std::optional<Pose2> T_world_trace_;  // where the trace without a node behind it began
  std::optional<Angle> last_heading_;
  Angle turned_;
  int target_ = 0;
  bool look_first_ = false;  // before the next departure
  int reversals_ = 0;
  int stuck_ = 0;
  int given_up_ = 0;
  double settled_s_ = 0.0;
  double silent_s_ = 0.0;
  double passed_s_ = 0.0;
  double total_s_ = 0.0;
};

}  // namespace echoarc::nav
