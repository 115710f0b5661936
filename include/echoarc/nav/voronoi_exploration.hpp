// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <tuple>

#include "echoarc/nav/strategy.hpp"
#include "echoarc/nav/voronoi_graph.hpp"
#include "echoarc/nav/voronoi_tracer.hpp"

namespace echoarc::nav {

struct VoronoiExplorationOptions {
  bool look_around = true;
  double return_speed_m_s = 0.40;
  double settle_s = 1.0;
  double silence_s = 10.0;
  double stuck_s = 20.0;
  double longest_edge_m = 200.0;
  double longest_time_s = 36'000.0;

  static constexpr auto fields() {
    using O = VoronoiExplorationOptions;
    return std::tuple{
        field("look_around", &O::look_around, {.doc = "turn once on the spot before the first motion"}),
        field("return_speed_m_s", &O::return_speed_m_s,
              {.unit = "m/s", .min = 0.01, .max = 2.0, .doc = "along edges that are known"}),
        field("settle_s", &O::settle_s,
              {.unit = "s", .min = 0.0, .max = 60.0, .doc = "of standing at a meet point, to see it well"}),
        field("silence_s", &O::silence_s,
              {.unit = "s", .min = 0.1, .max = 600.0, .doc = "without any obstacle in view, then it fails"}),
        field("stuck_s", &O::stuck_s,
              {.unit = "s", .min = 1.0, .max = 600.0, .doc = "within a decimetre, then it gives up what it tries"}),
        field("longest_edge_m", &O::longest_edge_m,
              {.unit = "m", .min = 1.0, .max = 1e5, .doc = "beyond it an edge is given up"}),
        field("longest_time_s", &O::longest_time_s,
              {.unit = "s", .min = 1.0, .max = 1e7, .doc = "of exploring, then it fails"})};
  }
};

/// Explores a place by constructing its generalised Voronoi graph, [Choset03] V: access the graph, trace an edge to a
/// meet or boundary point, return over known edges to the nearest unexplored one, until none is left. Only the
/// obstacle points near the robot are used, no map. As these come and go with the newest echoes, what was seen close to
/// the body is kept for ten seconds, and of every meet point the places of its obstacles. A way that comes to nothing
/// is tried once more after a look all round, then given up; the reason at the end counts those.
class VoronoiExploration final : public Strategy {
 public:
  explicit VoronoiExploration(const RobotBody& body, const VoronoiExplorationOptions& options = {},
                              const TracerOptions& tracer = {}, const ObstacleOptions& obstacles = {});
  ~VoronoiExploration() override;
  VoronoiExploration(VoronoiExploration&&) noexcept;
  VoronoiExploration& operator=(VoronoiExploration&&) noexcept;

  [[nodiscard]] std::string_view name() const override { return "gvg"; }
  [[nodiscard]] Steering update(const Surroundings& surroundings) override;
  [[nodiscard]] Sketch sketch() const override;
  [[nodiscard]] const VoronoiGraph* voronoi_graph() const override { return &graph(); }
  [[nodiscard]] const VoronoiGraph& graph() const;

 private:
  class Explorer;
  std::unique_ptr<Explorer> explorer_;
};

}  // namespace echoarc::nav
