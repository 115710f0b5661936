// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/loop_watch.hpp"
#include "echoarc/nav/recovery.hpp"
#include "echoarc/nav/side_wall.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

struct SurfaceFollowerOptions {
  bool left = true;
  double distance_m = 1.0;
  double within_m = 2.0;
  double turn_away_m = 0.8;
  double cruise_m_s = 0.2;
  Angle turn_per_s = radians(0.6);
  double distance_gain_per_m = 1.5;
  double direction_gain_per_s = 1.2;
  double end_m = 0.5;
  double close_m = 0.3;
  double least_loop_m = 3.0;
  double longest_m = 2000.0;
  double patience_s = 5.0;

  static constexpr auto fields() {
    using O = SurfaceFollowerOptions;
    return std::tuple{
        field("left", &O::left, {.doc = "keep the surface on the left; no: on the right"}),
        field("distance_m", &O::distance_m,
              {.unit = "m", .min = 0.1, .max = 5.0, .doc = "kept between robot's centre and surface"}),
        field("within_m", &O::within_m,
              {.unit = "m", .min = 0.1, .max = 10.0, .doc = "what is further away is not the surface"}),
        field("turn_away_m", &O::turn_away_m,
              {.unit = "m", .min = 0.0, .max = 5.0, .doc = "something ahead is so near: turn away on the spot"}),
        field("cruise_m_s", &O::cruise_m_s, {.unit = "m/s", .min = 0.01, .max = 10.0, .doc = "speed"}),
        field("turn_rate_deg", &O::turn_per_s,
              {.unit = "deg/s", .min = 1.0, .max = 360.0, .doc = "largest turning rate"}),
        field("distance_gain_per_m", &O::distance_gain_per_m,
              {.unit = "rad/m", .min = 0.0, .max = 100.0, .doc = "angle to the tangent over error of distance"}),
        field("direction_gain_per_s", &O::direction_gain_per_s,
              {.unit = "1/s", .min = 0.0, .max = 100.0, .doc = "turning rate over error of direction"}),
        field("end_m", &O::end_m, {.unit = "m", .min = 0.0, .max = 10.0, .doc = "way beyond the surface's end"}),
        field("close_m", &O::close_m,
              {.unit = "m", .min = 0.01, .max = 10.0, .doc = "so near to its start the robot is round"}),
        field("least_loop_m", &O::least_loop_m,
              {.unit = "m", .min = 0.0, .max = 1e4, .doc = "way before it may be round"}),
        field("longest_m", &O::longest_m, {.unit = "m", .min = 1.0, .max = 1e6, .doc = "way after which it gives up"}),
        field("patience_s", &O::patience_s,
              {.unit = "s", .min = 0.0, .max = 600.0, .doc = "time to wait for an echo of the surface"})};
  }
};

/// Follows a surface of any curvature for mapping it: keeps its distance to the nearest point abreast, its heading
/// along the tangent through the half metre of points around it, until the surface ends or the robot is round it. The
/// directions of interest of such a drive are the normals of its path. [Barshan07] 5 suggests surface following; the
/// control is this library's.
class SurfaceFollower final : public Strategy {
 public:
  explicit SurfaceFollower(const RobotBody& body, const SurfaceFollowerOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "surface"; }
  [[nodiscard]] Steering update(const Surroundings& surroundings) override;
  [[nodiscard]] Sketch sketch() const override;

 private:
  [[nodiscard]] Steering steer(const Surroundings& surroundings);
  [[nodiscard]] Steering turn_beside(const Surroundings& surroundings, const std::optional<Vec2>& nearest);
  [[nodiscard]] Steering along_surface(const Surroundings& surroundings, const SectorMinima& minima);
  [[nodiscard]] std::optional<Angle> tangent(const Surroundings& surroundings, const SectorMinima& minima,
                                             bool abreast) const;
  [[nodiscard]] Steering turning(double rate_rad_s, std::string reason) const;
  [[nodiscard]] Steering end(Status status, std::string reason);

  RobotBody body_;
  SurfaceFollowerOptions options_;
  WallSide side_;
  PoseWatch watch_;
  Recovery recovery_;
  SideWall surface_;
  LoopWatch loop_;
  std::optional<double> silent_since_s_;
  std::optional<Steering> ended_;
  double past_end_m_ = 0.0;  // way since the surface was abreast
  bool beside_ = false;      // the surface has been abreast
};

}  // namespace echoarc::nav
