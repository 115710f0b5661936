// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/obstacle_distances.hpp"
#include "echoarc/nav/voronoi_graph.hpp"

namespace echoarc::nav {

struct TracerOptions {
  double speed_m_s = 0.25;
  double correction_per_s = 1.0;
  double correction_limit_m_s = 0.2;
  double equidistance_m = 0.03;
  double meet_m = 0.06;
  double node_band_m = 0.15;
  double margin_m = 0.10;
  int confirmations = 3;
  double smoothing_m = 0.10;
  double leave_m = 0.40;
  double patience_s = 3.0;

  static constexpr auto fields() {
    using O = TracerOptions;
    return std::tuple{
        field("speed_m_s", &O::speed_m_s, {.unit = "m/s", .min = 0.01, .max = 2.0, .doc = "along an edge"}),
        field("correction_per_s", &O::correction_per_s,
              {.unit = "1/s", .min = 0.1, .max = 10.0, .doc = "gain back to the edge", .source = "[Choset03] V"}),
        field("correction_limit_m_s", &O::correction_limit_m_s,
              {.unit = "m/s", .min = 0.01, .max = 100.0, .doc = "of the way back to the edge"}),
        field("equidistance_m", &O::equidistance_m,
              {.unit = "m", .min = 0.005, .max = 0.5, .doc = "the edge is reached when two distances differ by less"}),
        field("meet_m", &O::meet_m,
              {.unit = "m", .min = 0.005, .max = 0.5, .doc = "a third obstacle so little further makes a meet point"}),
        field("node_band_m", &O::node_band_m,
              {.unit = "m", .min = 0.01, .max = 1.0, .doc = "obstacles so little further belong to a meet point"}),
        field("margin_m", &O::margin_m,
              {.unit = "m", .min = 0.0, .max = 1.0, .doc = "beside the body, in the narrowest place it enters"}),
        field("confirmations", &O::confirmations,
              {.min = 1, .max = 100, .doc = "so many views in a row make a meet or boundary point"}),
        field("smoothing_m", &O::smoothing_m,
              {.unit = "m", .min = 0.001, .max = 2.0, .doc = "of travel, over which the direction is smoothed"}),
        field("leave_m", &O::leave_m,
              {.unit = "m", .min = 0.05, .max = 2.0, .doc = "of travel, before the next node can be met"}),
        field("patience_s", &O::patience_s,
              {.unit = "s", .min = 0.1, .max = 60.0, .doc = "without two obstacles in view, then the edge is lost"})};
  }
};

/// The parts of the control law at one place, for closest points c1 and c2 of two obstacles: G = d1 - d2,
/// velocity = speed * tangent + correction, correction = -gain * G * grad G / |grad G|^2, cut to its limit.
struct TraceControl {
  double difference_m = 0.0;  ///< G
  Vec2 gradient;              ///< of G; no unit
  Vec2 tangent;               ///< unit vector across the gradient, along the previous direction rather than against it
  Vec2 correction_m_s;
};
[[nodiscard]] TraceControl trace_control(Vec2 place, Vec2 closest_1, Vec2 closest_2, Vec2 previous_direction,
                                         const TracerOptions& options = {});

/// Where |d1 - d2| and |d1 - d3| vanish, by Newton's method from a place nearby; obstacles are looked at anew in every
/// step. None if it does not settle within a metre.
[[nodiscard]] std::optional<Vec2> refine_meet(std::span<const Vec2> points, Vec2 place,
                                              const std::array<NearObstacle, 3>& obstacles,
                                              const ObstacleOptions& options = {});

/// The node at a place: ways out along the bisectors between neighbouring obstacles, without those that are narrower
/// than `gap_m` between their two closest points.
[[nodiscard]] NodeSight node_sight(std::span<const Vec2> points, Vec2 place, double gap_m,
                                   const TracerOptions& options = {}, const ObstacleOptions& obstacles = {});

enum class TraceEvent {
  none,
  meet,      ///< three obstacles are equally far: a node may be here
  boundary,  ///< too narrow, or a dead end
  lost       ///< no two obstacles were seen for long
};

struct TraceStep {
  Vec2 velocity_m_s;  ///< wanted, world
  TraceEvent event = TraceEvent::none;
};

struct AccessStep {
  Vec2 velocity_m_s;        ///< wanted, world
  bool reached = false;     ///< the place lies on an edge of the graph
  double distance_m = 0.0;  ///< to the nearest obstacle; 0: none is seen
  Angle direction;          ///< of the edge, once it is reached: the one nearer to the heading
};

/// Drives a disc along one edge of the generalised Voronoi graph, by the obstacles in view alone. An obstacle that
/// leaves no gap for the body beside one of the traced pair takes its place when it is nearer; one that leaves gaps on
/// both sides makes a meet point.
class VoronoiTracer {
 public:
  explicit VoronoiTracer(double body_radius_m, const TracerOptions& options = {},
                         const ObstacleOptions& obstacles = {});

  /// A new edge, from a place in a direction (world).
  void begin(Vec2 place, Angle direction);
  /// Goes on after a meet point that turned out to be none.
  void resume();
  /// To be called at a steady rate; `place` of the body's centre and obstacle points in world, m.
  [[nodiscard]] TraceStep update(Vec2 place, double passed_s, std::span<const Vec2> points);

  /// Away from the nearest obstacle towards the graph, until a second one with a gap between them is equally far.
  [[nodiscard]] AccessStep access(Vec2 place, Angle heading, std::span<const Vec2> points) const;

  /// The node where the last meet point was seen, refined; none if it has fewer than three ways out.
  [[nodiscard]] std::optional<NodeSight> meet(Vec2 place, std::span<const Vec2> points) const;

  /// The node at a place, which may have any number of ways.
  [[nodiscard]] NodeSight node_at(Vec2 place, std::span<const Vec2> points) const {
    return node_sight(points, place, 2.0 * least_distance_m_, options_, obstacle_options_);
  }

  /// Whether it can be believed to be a meet point.
  [[nodiscard]] static bool is_node(const NodeSight& sight);

  [[nodiscard]] Angle direction() const { return bearing(direction_); }
  [[nodiscard]] const std::vector<Vec2>& polyline() const { return polyline_; }
  [[nodiscard]] double length_m() const { return travelled_m_; }
  [[nodiscard]] double min_clearance_m() const { return min_clearance_m_; }
  [[nodiscard]] double least_distance_m() const { return least_distance_m_; }  ///< narrowest half-width that is entered

 private:
  using Pair = std::array<NearObstacle, 2>;
  void record(Vec2 place);
  bool track(std::span<const NearObstacle> obstacles);
  void hand_over(std::span<const NearObstacle> obstacles);
  [[nodiscard]] bool is_gap(const NearObstacle& a, const NearObstacle& b) const;
  [[nodiscard]] const NearObstacle* third(std::span<const NearObstacle> obstacles) const;
  [[nodiscard]] bool is_off_edge(std::span<const NearObstacle> obstacles) const;
  [[nodiscard]] bool is_narrow(Vec2 place) const;
  [[nodiscard]] bool is_closed_ahead(std::span<const NearObstacle> obstacles, Vec2 place) const;
  [[nodiscard]] TraceStep go_blind(std::span<const NearObstacle> obstacles, Vec2 place, double passed_s);
  [[nodiscard]] std::optional<Pair> first_pair(std::span<const NearObstacle> obstacles) const;
  [[nodiscard]] std::optional<Pair> next_pair(std::span<const NearObstacle> obstacles) const;
  [[nodiscard]] double speed_m_s(std::span<const NearObstacle> obstacles, Vec2 place, double third_gap_m) const;
  [[nodiscard]] std::optional<NodeSight> node_around(Vec2 place, std::span<const Vec2> points) const;
  TraceEvent count(bool meets, bool ends);

  TracerOptions options_;
  ObstacleOptions obstacle_options_;
  double least_distance_m_;
  std::optional<Pair> pair_;
  Vec2 direction_{1.0, 0.0};
  Vec2 last_place_;
  std::vector<Vec2> polyline_;
  double travelled_m_ = 0.0;
  double since_node_m_ = 0.0;
  double min_clearance_m_ = 0.0;
  double blind_s_ = 0.0;
  int meets_ = 0;
  int ends_ = 0;
  bool is_new_ = true;  // no pair was chosen since the edge began
  bool armed_for_meet_ = false;
  bool armed_for_boundary_ = false;
};

}  // namespace echoarc::nav
