// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/triangulation_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc {

ArcMeetings meetings_of(const WindowArc& own, const WindowArc& other, double baseline_min_m) {
  ArcMeetings found;
  const Vec2 between = other.midpoint - own.midpoint;
  const double reach_m = own.reach_m + other.reach_m + eps_length_m;
  if (squared_norm(between) > reach_m * reach_m) return found;  // most pairs end here
  const Vec2 baseline = other.sensor - own.sensor;
  const double distance2 = squared_norm(baseline);
  const double least_m = std::max(baseline_min_m, eps_length_m);
  if (distance2 < least_m * least_m) return found;
  const double along_m2 = 0.5 * (distance2 + own.range_m * own.range_m - other.range_m * other.range_m);
  const double beside2 = own.range_m * own.range_m - along_m2 * along_m2 / distance2;
  if (!(beside2 > eps_length_m * eps_length_m)) return found;
  const Vec2 foot = own.sensor + (along_m2 / distance2) * baseline;
  const Vec2 beside = std::sqrt(beside2 / distance2) * perpendicular(baseline);
  for (const Vec2 p : {foot + beside, foot - beside})
    if (own.contains(p) && other.contains(p)) found.points[std::size_t(found.count++)] = p;
  return found;
}

double TriangulationHypotheses::Hypothesis::max_deviation_m() const {
  double worst_m = 0.0;
  for (const Meeting& meeting : meetings) worst_m = std::max(worst_m, norm(meeting.position - mean()));
  return worst_m;
}

Vec2 TriangulationHypotheses::choose(const ArcMeetings& meetings, const WindowArc& own, const WindowArc& other) const {
  if (meetings.count == 1) return meetings.points[0];
  const auto cost = [&](Vec2 p) {
    if (hypotheses_.empty()) return own.off_axis_rad(p) + other.off_axis_rad(p);
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const Hypothesis& hypothesis : hypotheses_) nearest_m = std::min(nearest_m, norm(p - hypothesis.mean()));
    return nearest_m;
  };
  return cost(meetings.points[1]) < cost(meetings.points[0]) ? meetings.points[1] : meetings.points[0];
}

void TriangulationHypotheses::add(Vec2 position, const WindowArc& other) {
  const auto takes = [&](const Hypothesis& h) { return squared_norm(position - h.mean()) <= gate_m_ * gate_m_; };
  auto found = std::ranges::find_if(hypotheses_, takes);
  if (found == hypotheses_.end()) {
    if (hypotheses_.size() >= most_) return;
    found = hypotheses_.insert(hypotheses_.end(), Hypothesis{});
  }
  found->sum = found->sum + position;
  found->meetings.push_back({position, &other});
}

const TriangulationHypotheses::Hypothesis* TriangulationHypotheses::best() const {
  const Hypothesis* best = nullptr;
  for (const Hypothesis& hypothesis : hypotheses_) {
    const bool more = best == nullptr || hypothesis.meetings.size() > best->meetings.size();
    const bool sharper = best != nullptr && hypothesis.meetings.size() == best->meetings.size() &&
                         hypothesis.max_deviation_m() < best->max_deviation_m();
    if (more || sharper) best = &hypothesis;
  }
  return best;
}

Vec2 refined_position(Vec2 start, const WindowArc& own, const TriangulationHypotheses::Hypothesis& hypothesis,
                      double sigma_m) {
  constexpr int half_cells = 15;  // a square of 0.30 m
  constexpr double cell_m = 0.01;
  constexpr double share_of_max = 0.9;
  const auto agreement = [&](const WindowArc& arc, Vec2 p) {
    const double off = (norm(p - arc.sensor) - arc.range_m) / sigma_m;
    return arc.off_axis_rad(p) <= arc.half_width_rad ? std::exp(-0.5 * off * off) : 0.0;
  };
  struct Weighted {
    Vec2 position;
    double weight = 0.0;
  };
  std::vector<Weighted> cells;
  double most = 0.0;
  for (int j = -half_cells; j < half_cells; ++j)
    for (int i = -half_cells; i < half_cells; ++i) {
      const Vec2 p = start + ((i + 0.5) * cell_m) * own.axis + ((j + 0.5) * cell_m) * perpendicular(own.axis);
      double weight = agreement(own, p);
      for (const auto& meeting : hypothesis.meetings) weight += agreement(*meeting.other, p);
      cells.push_back({p, weight});
      most = std::max(most, weight);
    }
  if (most <= 0.0) return start;
  Vec2 sum;
  double weights = 0.0;
  for (const Weighted& cell : cells) {
    if (cell.weight < share_of_max * most) continue;
    sum = sum + cell.weight * (cell.position - start);
    weights += cell.weight;
  }
  return start + sum / weights;
}

}  // namespace echoarc
