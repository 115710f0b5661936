// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "echoarc/core/arc.hpp"

namespace echoarc {
namespace {

enum class Verdict { unknown, wall, point };

constexpr Angle same_bearing = degrees(0.25);
constexpr double least_rms_m = 1e-6;  // below this a fit is perfect, and no better one leaves less over

Verdict verdict_of(std::span<const DepthRegion> regions, const DepthRegionOptions& options) {
  if (regions.size() < std::size_t(options.positions_min)) return Verdict::unknown;
  const double wall_m = std::max(fit_wall(regions).rms_m, least_rms_m);
  const double point_m = std::max(fit_point(regions).rms_m, least_rms_m);
  if (point_m >= options.vote_ratio * wall_m) return Verdict::wall;
  if (wall_m >= options.vote_ratio * point_m) return Verdict::point;
  return Verdict::unknown;
}

Verdict majority(const LandmarkTrack& track) {
  if (track.wall_votes == track.point_votes) return Verdict::unknown;
  return track.wall_votes > track.point_votes ? Verdict::wall : Verdict::point;
}

/// How badly a region fits to the newest of a track, as a share of what is allowed; above 1 it does not belong to it.
double misfit(const LandmarkTrack& track, const DepthRegion& region, const DepthRegionOptions& options) {
  const DepthRegion& last = track.regions.back();
  const double as_point = norm(region.echo_point() - last.echo_point()) / std::max(options.point_m, eps_length_m);
  const Angle turn = abs(wrap(region.bearing - last.bearing));
  if (turn >= options.line_turn) return as_point;
  const Vec2 normal = unit(last.bearing + 0.5 * wrap(region.bearing - last.bearing));
  const double off_m = dot(normal, region.position - last.position) - (last.depth_m - region.depth_m);
  return std::min(as_point, std::abs(off_m) / std::max(options.line_m, eps_length_m));
}

struct Wall {
  WallFit fit;
  Vec2 begin;  ///< first and last place of the wall that answered
  Vec2 end;
};

Wall wall_of(const LandmarkTrack& track) {
  Wall wall{fit_wall(track.regions), {}, {}};
  double low_m = 0.0;
  double high_m = 0.0;
  const Vec2 along = perpendicular(wall.fit.normal);
  const Vec2 foot = track.regions.front().position +
                    (wall.fit.distance_m - dot(wall.fit.normal, track.regions.front().position)) * wall.fit.normal;
  for (const DepthRegion& region : track.regions) {
    const double at_m = dot(region.position - foot, along);
    low_m = std::min(low_m, at_m);
    high_m = std::max(high_m, at_m);
  }
  wall.begin = foot + low_m * along;
  wall.end = foot + high_m * along;
  return wall;
}

/// Whether the way from `s` to `p` passes through a wall, well before its end.
bool crosses(const Wall& wall, Vec2 s, Vec2 p) {
  constexpr double clearance_m = 0.10;
  const double before_m = wall.fit.distance_m - dot(wall.fit.normal, s);
  const double behind_m = dot(wall.fit.normal, p) - wall.fit.distance_m;
  if (before_m <= 0.0 || behind_m <= clearance_m) return false;
  const Vec2 at = s + before_m / (before_m + behind_m) * (p - s);
  return dot(at - wall.begin, at - wall.end) <= 0.0;
}

/// Whether two walls meet at `p` around the robot: it stands between the rays from `p` to their middles.
bool in_wedge(const Wall& a, const Wall& b, Vec2 p, Vec2 robot) {
  const Vec2 u = 0.5 * (a.begin + a.end) - p;
  const Vec2 v = 0.5 * (b.begin + b.end) - p;
  const Vec2 s = robot - p;
  const double turn = cross(u, v);
  return turn != 0.0 && cross(s, v) / turn > 0.0 && cross(u, s) / turn > 0.0;
}

FeatureKind kind_of_point(const LandmarkTrack& track, Vec2 p, std::span<const Wall> walls,
                          const DepthRegionOptions& options) {
  std::vector<Wall> near;
  for (const Wall& wall : walls)
    if (std::abs(dot(wall.fit.normal, p) - wall.fit.distance_m) <= options.point_m) near.push_back(wall);
  const Vec2 robot = track.regions.back().position;
  for (std::size_t a = 0; a < near.size(); ++a)
    for (std::size_t b = a + 1; b < near.size(); ++b)
      if (in_wedge(near[a], near[b], p, robot)) return FeatureKind::corner;
  if (walls.size() >= 2) return FeatureKind::edge;
  Angle extent;
  for (const DepthRegion& region : track.regions) extent += region.extent / double(track.regions.size());
  return extent < options.edge_extent ? FeatureKind::edge : FeatureKind::corner;
}

Feature feature_of(const LandmarkTrack& track, FeatureKind kind, Vec2 begin, Vec2 end, double rms_m) {
  Feature feature{kind, begin, end, rms_m, static_cast<std::uint32_t>(track.regions.size()), {}};
  for (const DepthRegion& region : track.regions)
    feature.pings.insert(feature.pings.end(), region.pings.begin(), region.pings.end());
  return feature;
}

}  // namespace

void Landmarks::insert(std::span<const Reading> readings) {
  for (const Reading& reading : readings) {
    if (!reading.monostatic() || !is_finite(reading.T_world_robot) || !is_finite(reading.T_world_tx)) continue;
    const Vec2 robot = reading.T_world_robot.position;
    if (place_ && norm(robot - *place_) > options_.stop_m) end_sweep();
    if (!place_) place_ = robot;
    DepthReturn heard{reading.T_world_tx.heading, std::numeric_limits<double>::infinity(), reading.ping};
    const auto range_m = echo_range_m(reading.outcome);
    if (range_m && std::isfinite(*range_m) && *range_m > 0.0 && *range_m <= options_.range_max_m) {
      const Vec2 middle = reading.T_world_tx * Vec2{*range_m, 0.0} - robot;
      heard.bearing = bearing(middle);
      heard.depth_m = norm(middle);
    } else if (!range_m && !is_no_echo(reading.outcome)) {
      continue;  // a failed measurement says nothing, not even that there is silence
    }
    hear(heard);
  }
}

void Landmarks::hear(const DepthReturn& heard) {
  // However long the robot stays, a sweep holds no more than there are bearings.
  const auto same = [&](const DepthReturn& known) { return abs(wrap(known.bearing - heard.bearing)) < same_bearing; };
  if (const auto known = std::ranges::find_if(sweep_, same); known != sweep_.end())
    *known = heard;
  else
    sweep_.push_back(heard);
}

void Landmarks::end_sweep() {
  ++sweeps_;
  insert(depth_regions(*place_, std::move(sweep_), options_));
  sweep_.clear();
  place_.reset();
}

void Landmarks::insert(const std::vector<DepthRegion>& regions) {
  // Regions of one position never join each other: each is held against the landmarks known before.
  const std::size_t known = tracks_.size();
  for (const DepthRegion& region : regions) follow(region, known);
}

void Landmarks::follow(const DepthRegion& region, std::size_t known) {
  LandmarkTrack* best = nullptr;
  double least = 1.0;
  for (std::size_t k = 0; k < known; ++k) {
    if (tracks_[k].regions.back().position == region.position) continue;
    const double off = misfit(tracks_[k], region, options_);
    if (off > least || (off == least && best != nullptr)) continue;
    least = off;
    best = &tracks_[k];
  }
  if (best == nullptr) {
    tracks_.push_back({{region}, 0, 0});
    return;
  }
  best->regions.push_back(region);
  if (best->regions.size() > max_regions) best->regions.erase(best->regions.begin());
  switch (verdict_of(best->regions, options_)) {
    case Verdict::wall: ++best->wall_votes; break;
    case Verdict::point: ++best->point_votes; break;
    case Verdict::unknown: break;
  }
}

std::vector<Feature> Landmarks::features() const {
  if (place_) {
    Landmarks finished = *this;
    finished.end_sweep();
    return finished.features();
  }
  std::vector<Wall> walls;
  for (const LandmarkTrack& track : tracks_)
    if (majority(track) == Verdict::wall) walls.push_back(wall_of(track));
  const auto hidden = [&](const LandmarkTrack& track) {  // behind a wall: an echo of echoes
    const DepthRegion& last = track.regions.back();
    return std::ranges::any_of(walls, [&](const Wall& w) { return crosses(w, last.position, last.echo_point()); });
  };
  std::vector<Feature> found;
  for (const LandmarkTrack& track : tracks_) {
    if (hidden(track)) continue;
    const Verdict verdict = majority(track);
    if (verdict == Verdict::wall) {
      const Wall wall = wall_of(track);
      found.push_back(feature_of(track, FeatureKind::wall, wall.begin, wall.end, wall.fit.rms_m));
    } else if (verdict == Verdict::point) {
      const PointFit fit = fit_point(track.regions);
      const FeatureKind kind = kind_of_point(track, fit.position, walls, options_);
      found.push_back(feature_of(track, kind, fit.position, fit.position, fit.rms_m));
    } else {
      const Vec2 p = track.regions.back().echo_point();
      found.push_back(feature_of(track, FeatureKind::region, p, p, 0.0));
    }
  }
  return found;
}

}  // namespace echoarc
