// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/nav/free_way.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

struct HistogramOptions {
  double window_m = 4.0;
  double enlarge_m = 0.05;
  double close_above = 0.3;
  double open_below = 0.2;
  int smoothing_sectors = 5;
  int wide_sectors = 6;
  double keep_way = 0.4;
  double cruise_m_s = 0.25;
  Angle turn_on_spot = degrees(60.0);
  double turn_gain_per_s = 1.5;

  static constexpr auto fields() {
    using O = HistogramOptions;
    return std::tuple{
        field("window_m", &O::window_m, {.unit = "m", .min = 0.5, .max = 20.0, .doc = "side of the active window"}),
        field("enlarge_m", &O::enlarge_m,
              {.unit = "m", .min = 0.0, .max = 1.0, .doc = "obstacles grow by the robot's radius and this"}),
        field("close_above", &O::close_above,
              {.min = 0.0, .max = 1.0, .doc = "a sector closes above this share of the largest magnitude"}),
        field("open_below", &O::open_below,
              {.min = 0.0, .max = 1.0, .doc = "a closed sector opens below this share of the largest magnitude"}),
        field("smoothing_sectors", &O::smoothing_sectors,
              {.unit = "sectors", .min = 1, .max = 15, .doc = "width of the smoothing, odd; 1: none"}),
        field("wide_sectors", &O::wide_sectors,
              {.unit = "sectors", .min = 1, .max = 36, .doc = "a valley so wide is not driven in its middle"}),
        field("keep_way", &O::keep_way,
              {.min = 0.0, .max = 10.0, .doc = "weight of the last direction beside that of the goal"}),
        field("cruise_m_s", &O::cruise_m_s,
              {.unit = "m/s", .min = 0.01, .max = 10.0, .doc = "speed where all is free"}),
        field("turn_on_spot_deg", &O::turn_on_spot,
              {.unit = "deg", .min = 5.0, .max = 180.0, .doc = "for a larger turn the robot stands still"}),
        field("turn_gain_per_s", &O::turn_gain_per_s,
              {.unit = "1/s", .min = 0.1, .max = 10.0, .doc = "turning rate over what is left to turn"})};
  }
};

/// Where to go and how fast.
struct Heading {
  Angle direction;  ///< world
  double speed_m_s = 0.0;
};

/// Obstacle avoidance by a vector field histogram (Borenstein, Koren 1991), with the obstacles enlarged by the robot's
/// radius (VFH+, Ulrich, Borenstein 1998), on points of any source.
///
/// A point at distance d weighs c^2 (a - b d) with c = a = 1, and b such that the weight vanishes at the corner of the
/// active window. It closes the sectors towards which the robot, enlarged, would touch it. The nearest point of a
/// sector makes its magnitude: a sum would depend on how densely the source sets its points. Magnitudes are smoothed by
/// a triangle; sectors close and open with hysteresis; the open valley nearest the goal is taken, in its middle if it
/// is narrow. Sectors are fixed to the world, for the hysteresis to outlast a turn.
class VectorFieldHistogram {
 public:
  static constexpr std::size_t sector_count = 72;

  explicit VectorFieldHistogram(const RobotBody& body, const HistogramOptions& options = {});

  /// The way towards `goal`, world, m; none: blocked, or the pose or the goal is no number. What is further away than
  /// the goal does not count.
  [[nodiscard]] std::optional<Heading> steer(const Pose2& T_world_base, Vec2 goal, std::span<const Vec2> points);
  /// The velocity that follows `heading`: turns first if much is left to turn.
  [[nodiscard]] RobotVelocity velocity(const Pose2& T_world_base, const Heading& heading) const;
  /// Forgets what was closed and where it went.
  void reset();

  /// By sector, of bearings from k 5 to (k + 1) 5 degrees, world, as of the last `steer`.
  [[nodiscard]] std::span<const double> magnitudes() const { return smoothed_; }
  [[nodiscard]] std::span<const bool> closed() const { return closed_; }

 private:
  using Sectors = std::array<double, sector_count>;
  /// Open sectors side by side.
  struct Valley {
    std::size_t first = 0;
    std::size_t size = 0;
  };

  void weigh(Vec2 position, double heeded_m, std::span<const Vec2> points);
  void close_around(Vec2 seen, double distance_m, double nearness);
  void smooth();
  void threshold();
  [[nodiscard]] Angle way_through(const Valley& valley, Angle wanted) const;
  [[nodiscard]] std::optional<Angle> choose(Angle wanted) const;

  HistogramOptions options_;
  RobotBody body_;
  std::array<Vec2, sector_count> middles_;  // unit vectors
  double half_sector_sine_;
  Sectors nearness_{};
  Sectors smoothed_{};
  std::array<bool, sector_count> closed_{};
  std::optional<Angle> last_;
};

}  // namespace echoarc::nav
