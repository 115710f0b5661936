// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/scene_reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/eval/polynomial_fit.hpp"

namespace echoarc::studies {
namespace {

constexpr double reference_step_m = 0.002;
// Reference points a little outside the region are still the nearest ones to points inside it.
constexpr double region_margin_m = 0.5;
const Angle polar_step = degrees(0.25);

Error refused(std::string cause, const std::string& where, std::string remedy) {
  return {ErrorCode::bad_value, std::move(cause), where, std::move(remedy)};
}

void add_wall(std::vector<Vec2>& points, Vec2 a, Vec2 b, double spacing_m) {
  const double steps = std::max(1.0, std::ceil(norm(b - a) / spacing_m));
  for (double k = 0.0; k <= steps; k += 1.0) points.push_back(a + (k / steps) * (b - a));
}

void add_disc(std::vector<Vec2>& points, const sim::Disc& disc, double spacing_m) {
  const double around_rad = 2.0 * std::numbers::pi;
  const double steps = std::max(3.0, std::ceil(around_rad * disc.radius_m / spacing_m));
  for (double k = 0.0; k < steps; k += 1.0)
    points.push_back(disc.centre + disc.radius_m * unit(radians(around_rad * k / steps)));
}

/// The true path where there is one.
PoseTrack track_of(const Log& log) {
  PoseTrack track;
  for (const Odometry& sample : log.truth.empty() ? log.odometry : log.truth) (void)track.push(sample);
  return track;
}

std::vector<Vec2> near_region(const std::vector<Vec2>& points, const Box& region) {
  std::vector<Vec2> near;
  std::ranges::copy_if(points, std::back_inserter(near), [&](Vec2 p) {
    return p.x >= region.low.x - region_margin_m && p.x <= region.high.x + region_margin_m &&
           p.y >= region.low.y - region_margin_m && p.y <= region.high.y + region_margin_m;
  });
  return near;
}

}  // namespace

std::vector<Vec2> surface_points(const sim::WorldDescription& world, double spacing_m) {
  std::vector<Vec2> points;
  for (const sim::Wall& wall : world.walls) add_wall(points, wall.a, wall.b, spacing_m);
  for (const sim::Disc& disc : world.discs) add_disc(points, disc, spacing_m);
  for (const sim::SmoothCurve& curve : world.curves)
    points.insert(points.end(), curve.points.begin(), curve.points.end());
  return points;
}

std::vector<Vec2> visible_points(const sim::World& world, std::span<const Vec2> points, std::span<const Vec2> path) {
  std::vector<Vec2> seen;
  std::size_t eye = 0;
  for (const Vec2 p : points)
    for (std::size_t asked = 0; asked < path.size(); ++asked, eye = eye + 1 == path.size() ? 0 : eye + 1)
      if (world.visible(path[eye], p)) {
        seen.push_back(p);
        break;
      }
  return seen;
}

std::vector<Vec2> path_positions(const Log& log, double step_m) {
  std::vector<Vec2> path;
  for (const Odometry& sample : log.truth.empty() ? log.odometry : log.truth) {
    const Vec2 p = sample.T_world_robot.position;
    if (path.empty() || norm(p - path.back()) >= step_m) path.push_back(p);
  }
  return path;
}

Result<std::vector<Vec2>> laser_points(const Log& log) {
  if (log.robot.lasers.empty())
    return refused("the scene has no laser to measure its reference with", log.source,
                   "add one, or set reference = \"truth\"");
  const LaserMount& laser = log.robot.lasers.front();
  const PoseTrack track = track_of(log);
  std::vector<Vec2> points;
  for (const Scan& scan : log.scans) {
    if (scan.laser != laser.id) continue;
    const auto pose = track.at(scan.time_s);
    const Pose2* T_world_robot = std::get_if<Pose2>(&pose);
    if (T_world_robot == nullptr) continue;
    const Pose2 T_world_laser = *T_world_robot * laser.mount.T_robot_sensor();
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
      const double range_m = scan.ranges_m[beam];
      if (!(range_m >= laser.range_min_m && range_m <= laser.range_max_m)) continue;
      points.push_back(T_world_laser * (range_m * unit(scan.angle_min + double(beam) * scan.angle_step)));
    }
  }
  if (points.empty())
    return refused("the scene's laser has no return", log.source, "turn it towards a surface it can see");
  return points;
}

Result<Reference> scene_reference(const sim::World& world, const Log& log, const SceneScoring& scoring) {
  const bool from_laser = scoring.reference == ReferenceSource::structured_light;
  Result<std::vector<Vec2>> points =
      from_laser ? laser_points(log)
                 : visible_points(world, surface_points(world.description(), reference_step_m), path_positions(log));
  if (!points) return points.error();
  std::string provenance = from_laser ? "structured light" : "surfaces visible from the path";
  std::vector<Vec2> kept = near_region(*points, scoring.region);
  if (kept.empty())
    return refused("nothing in the judged region is visible from the path", log.source,
                   "check [scoring] region and the drive");
  if (scoring.polynomial_degree > 0) {
    const Result<PolynomialFit> fit = PolynomialFit::make(kept, scoring.polynomial_degree);
    if (!fit) return fit.error();
    kept = fit->sample(reference_step_m);
    provenance += ", polynomial of degree " + std::to_string(scoring.polynomial_degree);
  }
  Result<PointSet> set = PointSet::make(std::move(kept));
  if (!set) return set.error();
  return Reference{std::move(*set), reference_step_m, std::move(provenance)};
}

DirectionSet scene_directions(const SceneScoring& scoring) {
  DirectionSet all = wall_directions(scoring.walls, scoring.region, scoring.cell_m);
  if (scoring.axis) {
    // The middle of a cell is the middle of a line, so that columns of cells are lines.
    const Vec2 middle = scoring.region.low + 0.5 * scoring.cell_m * Vec2{1.0, 1.0};
    const DirectionSet lines = axis_directions(scoring.region, middle, *scoring.axis, scoring.cell_m);
    all.families.insert(all.families.end(), lines.families.begin(), lines.families.end());
  }
  if (scoring.polar_centre) all.fans = polar_directions(scoring.region, *scoring.polar_centre, polar_step).fans;
  return all;
}

}  // namespace echoarc::studies
