// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/mapping/triangulation_fusion.hpp"

/// Triangulation-based fusion as a plain triple loop over columns, rows and hypotheses, straight from the formulae:
/// no pair is skipped but by the baseline, circles meet by the law of cosines, beams compare bearings.
/// For testing purposes only.
namespace echoarc::oracle {

struct FusedPoint {
  Vec2 position;
  int successes = 0;
  double max_deviation_m = 0.0;
};

inline std::vector<Vec2> circles_meet(const Arc& a, const Arc& b) {
  const Vec2 baseline = b.centre() - a.centre();
  const double d = norm(baseline);
  const double cosine = (d * d + a.range_m() * a.range_m() - b.range_m() * b.range_m()) / (2.0 * d * a.range_m());
  if (std::abs(cosine) >= 1.0) return {};
  std::vector<Vec2> points;
  for (const double side : {1.0, -1.0}) {
    const Angle at = bearing(baseline) + radians(side * std::acos(cosine));
    const Vec2 p = a.centre() + a.range_m() * unit(at);
    if (a.contains_bearing(at) && b.contains_bearing(bearing(p - b.centre()))) points.push_back(p);
  }
  return points;
}

using Group = std::vector<Vec2>;

inline Vec2 mean_of(const Group& group) {
  Vec2 sum;
  for (const Vec2 p : group) sum = sum + p;
  return sum / double(group.size());
}

inline double deviation_of(const Group& group) {
  double worst = 0.0;
  for (const Vec2 p : group) worst = std::max(worst, norm(p - mean_of(group)));
  return worst;
}

inline double off_axis(const Arc& arc, Vec2 p) {
  return abs(wrap(bearing(p - arc.centre()) - arc.axis())).rad();
}

inline Vec2 nearer_of(const std::vector<Vec2>& points, const std::vector<Group>& groups, const Arc& a, const Arc& b) {
  const auto cost = [&](Vec2 p) {
    if (groups.empty()) return off_axis(a, p) + off_axis(b, p);
    double least = 1e300;
    for (const Group& group : groups) least = std::min(least, norm(p - mean_of(group)));
    return least;
  };
  return points.size() == 2 && cost(points[1]) < cost(points[0]) ? points[1] : points[0];
}

/// One column of the window: its first robot pose and the readings in it.
struct Column {
  Pose2 T_world_robot;
  std::vector<Reading> readings;
};

inline std::vector<FusedPoint> fused_points(std::span<const Reading> readings, const TriangulationOptions& options) {
  std::vector<FusedPoint> fused;
  std::vector<Column> columns;  // oldest first, never forgotten
  for (const Reading& reading : readings) {
    const auto range_m = echo_range_m(reading.outcome);
    if (!range_m || reading.tx != reading.rx || *range_m > options.range_max_m) continue;
    const bool begins =
        columns.empty() ||
        norm(reading.T_world_robot.position - columns.back().T_world_robot.position) >= options.column_m - 1e-9 ||
        abs(wrap(reading.T_world_robot.heading - columns.back().T_world_robot.heading)) >=
            options.column_turn - radians(1e-9);
    if (begins) columns.push_back({reading.T_world_robot, {}});
    std::vector<Reading>& own = columns.back().readings;
    if (std::ranges::find(own, reading.rx, &Reading::rx) != own.end()) continue;
    own.push_back(reading);

    std::vector<Group> groups;
    const Arc arc = *arc_of(reading);
    for (std::size_t k = columns.size() - 1; k-- > 0 && k + std::size_t(options.columns) >= columns.size();)
      for (const Reading& older : columns[k].readings) {
        const Arc other = *arc_of(older);
        if (norm(other.centre() - arc.centre()) < options.baseline_min_m) continue;
        const std::vector<Vec2> points = circles_meet(arc, other);
        if (points.empty()) continue;
        const Vec2 p = nearer_of(points, groups, arc, other);
        const auto near = [&](const Group& group) { return norm(p - mean_of(group)) <= options.gate_m; };
        const auto home = std::ranges::find_if(groups, near);
        if (home != groups.end())
          home->push_back(p);
        else if (groups.size() < 3)
          groups.push_back({p});
      }
    const Group* best = nullptr;
    for (const Group& group : groups)
      if (best == nullptr || group.size() > best->size() ||
          (group.size() == best->size() && deviation_of(group) < deviation_of(*best)))
        best = &group;
    if (best != nullptr && int(best->size()) >= options.threshold)
      fused.push_back({mean_of(*best), int(best->size()), deviation_of(*best)});
  }
  return fused;
}

}  // namespace echoarc::oracle
