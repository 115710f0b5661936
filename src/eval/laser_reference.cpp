// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/eval/reference.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {
namespace {

// A surface of a building takes some MiB; more means that the poses are broken.
constexpr std::size_t memory_limit_bytes = std::size_t{256} << 20;
using ReturnCounts = TiledGrid<std::uint16_t>;

Error refused(ErrorCode code, const Log& log, std::string message, std::string remedy) {
  return {code, std::move(message), log.source, std::move(remedy)};
}

const LaserMount* find_laser(const RobotDescription& robot, std::uint32_t id) {
  for (const LaserMount& laser : robot.lasers)
    if (laser.id == id) return &laser;
  return nullptr;
}

/// False when the counts have reached their memory limit.
bool count_return(ReturnCounts& counts, Vec2 p) {
  const Cell cell = counts.geometry().cell_of(p);
  if (!counts.ensure(ReturnCounts::tile_of(cell))) return false;
  std::uint16_t& count = counts.at(cell);
  if (count < UINT16_MAX) ++count;
  return true;
}

/// False when the counts have reached their memory limit.
bool count_scan(ReturnCounts& counts, const Scan& scan, const LaserMount& laser, const Pose2& T_world_laser,
                double range_max_m) {
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    const double range_m = scan.ranges_m[beam];
    const bool is_return =
        range_m > 0.0 && range_m >= laser.range_min_m && range_m <= laser.range_max_m && range_m < range_max_m;
    if (!is_return) continue;  // NaN ends up here, too
    const Angle bearing_in_laser = scan.angle_min + double(beam) * scan.angle_step;
    const Vec2 p = T_world_laser * (range_m * unit(bearing_in_laser));
    if (is_finite(p) && !count_return(counts, p)) return false;
  }
  return true;
}

/// How many scans had a pose.
Result<std::uint64_t> count_scans(ReturnCounts& counts, const Log& log, double range_max_m) {
  PoseTrack track;
  for (const Odometry& sample : log.odometry) (void)track.push(sample);  // sensing reports what it refuses
  if (track.empty())
    return refused(ErrorCode::bad_value, log, "no odometry to place the laser scans with",
                   "give the odometry file, too");
  std::uint64_t placed = 0;
  for (const Scan& scan : log.scans) {
    const LaserMount* laser = find_laser(log.robot, scan.laser);
    if (laser == nullptr)
      return refused(ErrorCode::bad_value, log,
                     "scan of laser " + std::to_string(scan.laser) + ", which nobody described",
                     "add its mount to the robot description");
    const auto pose = track.at(scan.time_s);
    const Pose2* T_world_robot = std::get_if<Pose2>(&pose);
    if (T_world_robot == nullptr) continue;
    ++placed;
    if (!count_scan(counts, scan, *laser, *T_world_robot * laser->mount.T_robot_sensor(), range_max_m))
      return refused(ErrorCode::too_large, log, "laser returns are spread too far for memory",
                     "check the unit of the odometry, or use larger cells");
  }
  return placed;
}

}  // namespace

Result<Reference> laser_reference(const Log& log, const LaserReferenceOptions& options) {
  if (const Result<void> valid = validate(options); !valid) return valid.error();
  if (log.scans.empty())
    return refused(ErrorCode::not_found, log, "no laser scan to make a reference of", "use a truth or a map instead");
  ReturnCounts counts({options.cell_m, {0.0, 0.0}}, memory_limit_bytes);
  const Result<std::uint64_t> placed = count_scans(counts, log, options.range_max_m);
  if (!placed) return placed.error();

  std::vector<Vec2> centres;
  counts.for_each_nonzero([&](Cell cell, std::uint16_t returns) {
    if (returns >= options.min_returns) centres.push_back(counts.geometry().centre(cell));
  });
  if (centres.empty())
    return refused(ErrorCode::bad_value, log, "no cell with " + std::to_string(options.min_returns) + " laser returns",
                   "check that scans and odometry overlap in time and that ranges are in metres");
  Result<PointSet> points = PointSet::of_cells(std::move(centres), options.cell_m);
  if (!points) return points.error();
  return Reference{std::move(*points), options.cell_m,
                   "laser of " + log.source + ", " + std::to_string(*placed) + " of " +
                       std::to_string(log.scans.size()) + " scans placed by odometry"};
}

}  // namespace echoarc
