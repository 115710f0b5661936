// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/motion_noise.hpp"
#include "echoarc/nav/particle_filter.hpp"

namespace echoarc::nav {

/// A 3 x 3 matrix, row by row; x and y in m, heading in rad.
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// A point landmark as the robot sees it: the mean of a triangulation in its own frame.
struct LandmarkSighting {
  double range_m = 0.0;  ///< from the origin of the robot's frame
  Angle bearing;         ///< from its x axis
  int supports = 1;      ///< readings that met there (n_t)
};

/// The sighting of a triangulated point of the frame in which odometry gives the robot's pose.
[[nodiscard]] LandmarkSighting sighting_of(const Pose2& T_odom_robot, Vec2 point_odom, int supports);

struct LandmarkFilterOptions {
  MotionNoiseOptions noise;
  double gate = 9.21;
  double range_deviation_m = 0.10;
  Angle bearing_deviation = degrees(6.0);
  double least_range_deviation_m = 0.02;
  Angle least_bearing_deviation = degrees(1.0);
  double landmark_deviation_m = 0.03;
  double rival_ratio = 2.0;

  static constexpr auto fields() {
    using O = LandmarkFilterOptions;
    return std::tuple{
        field("gate", &O::gate,
              {.min = 0.0, .max = 1000.0, .doc = "largest squared Mahalanobis distance: 9.21 holds 99 % of sightings"}),
        field("range_deviation_m", &O::range_deviation_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "of the range of one reading's triangulation"}),
        field("bearing_deviation_deg", &O::bearing_deviation,
              {.unit = "deg", .min = 0.0, .max = 90.0, .doc = "of its bearing"}),
        field("least_range_deviation_m", &O::least_range_deviation_m,
              {.unit = "m", .min = 1e-4, .max = 10.0, .doc = "that remains however many readings support it"}),
        field("least_bearing_deviation_deg", &O::least_bearing_deviation,
              {.unit = "deg", .min = 0.01, .max = 90.0, .doc = "likewise of the bearing"}),
        field("landmark_deviation_m", &O::landmark_deviation_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "of the landmarks on the map, along each axis"}),
        field("rival_ratio", &O::rival_ratio,
              {.min = 1.0,
               .max = 100.0,
               .doc = "a sighting is passed over when a second landmark is less than so many times farther"})};
  }
};

/// What became of a sighting.
enum class Association : std::uint8_t {
  matched,    ///< it moved the estimate
  no_match,   ///< no landmark within the gate
  ambiguous,  ///< two landmarks explain it nearly as well
  invalid,    ///< not finite, no range, no support
};
[[nodiscard]] std::string_view name(Association association);  ///< "matched", "no_match", "ambiguous", "invalid"

/// Extended Kalman filter for the pose on a map of point landmarks, as triangulation-based fusion gives them: what Wijk
/// and Christensen (2000) made it for. A sighting is matched to the nearest landmark within a chi-square gate; its
/// noise falls with the readings that support it, sigma^2 = least^2 + sigma_1^2 / n_t. Meant for tracking: starts from
/// a pose that is known roughly.
class LandmarkFilter {
 public:
  /// Landmarks in the map's frame, m; those that are not finite are left out.
  explicit LandmarkFilter(std::span<const Vec2> landmarks, const LandmarkFilterOptions& options = {});

  void start_at(const Pose2& T_map_robot, double deviation_m, Angle deviation);
  /// The step as odometry measured it; one that is not finite is passed over.
  void move(const Pose2& T_before_now);
  Association observe(const LandmarkSighting& sighting);

  [[nodiscard]] const Pose2& T_map_robot() const { return T_map_robot_; }
  [[nodiscard]] const Matrix3& covariance() const { return covariance_; }
  /// To be drawn.
  [[nodiscard]] Sketch::Spread spread() const;

 private:
  struct Innovation {
    Vec2 difference;               // range, bearing
    std::array<double, 3> s{};     // its covariance: range, mixed, bearing
    std::array<double, 3> r{};     // the part of it that is measurement noise
    std::array<Vec2, 3> jacobian;  // column by column: d(range, bearing) / d(x, y, heading)
    double distance = 0.0;         // squared, Mahalanobis
  };
  [[nodiscard]] std::optional<Innovation> innovation(const LandmarkSighting& sighting, Vec2 landmark) const;
  void correct(const Innovation& innovation);

  LandmarkFilterOptions options_;
  std::vector<Vec2> landmarks_;
  Pose2 T_map_robot_;
  Matrix3 covariance_{};
};

}  // namespace echoarc::nav
