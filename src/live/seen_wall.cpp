// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/seen_wall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace echoarc::live {
namespace {

Cell cell_at(Vec2 p, double side_m) {
  return GridGeometry{side_m, {}}.cell_of(p);
}

std::uint64_t key_of(Cell cell) {
  return (std::uint64_t(std::uint32_t(cell.i)) << 32) | std::uint32_t(cell.j);
}

}  // namespace

NearPoints::NearPoints(std::span<const MapPoint> points, double distance_m) : distance_m_(distance_m) {
  for (const MapPoint& point : points) {
    std::vector<Vec2>& cell = cells_[key_of(cell_at(point.position, distance_m))];
    // Where a wall is marked a hundred times a few of the marks are enough.
    if (cell.size() < 64) cell.push_back(point.position);
  }
}

bool NearPoints::has(Vec2 p) const {
  const Cell middle = cell_at(p, distance_m_);
  for (std::int32_t j = middle.j - 1; j <= middle.j + 1; ++j)
    for (std::int32_t i = middle.i - 1; i <= middle.i + 1; ++i) {
      const auto found = cells_.find(key_of({i, j}));
      if (found != cells_.end() &&
          std::ranges::any_of(found->second, [&](Vec2 q) { return norm(q - p) <= distance_m_ + eps_length_m; }))
        return true;
    }
  return false;
}

SeenWall::SeenWall(const SourceDescription& source) : world_(source.world) {
  for (const Sensor& sensor : source.robot.sensors.sensors()) reach_m_ = std::max(reach_m_, sensor.model.range_max_m);
  if (!world_ || source.walls.empty()) return;
  const auto reference = polyline_reference(source.walls, "", spacing_m);
  if (reference) unseen_.assign(reference->points.points().begin(), reference->points.points().end());
}

void SeenWall::look_from(Vec2 eye, double step_m) {
  if (last_eye_ && norm(eye - *last_eye_) < step_m) return;
  last_eye_ = eye;
  const auto in_sight = [&](Vec2 wall) {
    const double distance_m = norm(wall - eye);
    if (distance_m > reach_m_) return false;
    // To a millimetre before the wall: the corner behind the sample must not hide it.
    return distance_m < 1e-3 || world_->visible(eye, wall + (1e-3 / distance_m) * (eye - wall));
  };
  const auto rest = std::ranges::partition(unseen_, [&](Vec2 wall) { return !in_sight(wall); });
  seen_.insert(seen_.end(), rest.begin(), rest.end());
  unseen_.erase(rest.begin(), rest.end());
}

std::optional<double> SeenWall::share_found(const NearPoints& points) const {
  if (seen_.empty()) return std::nullopt;
  const auto found = std::ranges::count_if(seen_, [&](Vec2 p) { return points.has(p); });
  return double(found) / double(seen_.size());
}

void LaserCells::add(const Scan& scan, const PoseTrack& track, std::span<const LaserMount> lasers) {
  const auto laser = std::ranges::find(lasers, scan.laser, &LaserMount::id);
  const std::variant<Pose2, PoseTrack::Missing> pose = track.at(scan.time_s);
  const auto* T_world_robot = std::get_if<Pose2>(&pose);
  if (laser == lasers.end() || T_world_robot == nullptr) return;
  const Pose2 T_world_laser = *T_world_robot * laser->mount.T_robot_sensor();
  const double farthest_m = std::min(options_.range_max_m, laser->range_max_m);
  for (std::size_t k = 0; k < scan.ranges_m.size(); ++k) {
    const double range_m = double(scan.ranges_m[k]);
    if (!(range_m >= laser->range_min_m && range_m < farthest_m)) continue;
    const Vec2 p = T_world_laser * (range_m * unit(scan.angle_min + double(k) * scan.angle_step));
    const Cell cell = cell_at(p, options_.cell_m);
    if (++returns_[key_of(cell)] == options_.min_returns)
      surfaces_.push_back(GridGeometry{options_.cell_m, {}}.centre(cell));
  }
}

double LaserCells::distance_m(Vec2 p) {
  if (surfaces_.empty() || !is_finite(p)) return std::numeric_limits<double>::infinity();
  if (!indexed_ || indexed_->size() != surfaces_.size()) {
    auto set = PointSet::make(surfaces_);
    if (!set) return std::numeric_limits<double>::infinity();
    nearest_.reset();
    indexed_ = std::make_unique<PointSet>(std::move(*set));
    nearest_ = std::make_unique<NearestPoints>(*indexed_);
  }
  return nearest_->distance_m(p);
}

std::optional<double> LaserCells::share_found(const NearPoints& points) const {
  if (surfaces_.empty()) return std::nullopt;
  const auto found = std::ranges::count_if(surfaces_, [&](Vec2 p) { return points.has(p); });
  return double(found) / double(surfaces_.size());
}

}  // namespace echoarc::live
