// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "echoarc/mapping/triangulation_window.hpp"

namespace echoarc {

/// The points, none to two, where two circular arcs meet.
struct ArcMeetings {
  std::array<Vec2, 2> points;
  int count = 0;
};

/// Closed form: a = (D^2 + r1^2 - r2^2) / (2 D) along the baseline, +-sqrt(r1^2 - a^2) beside it, then both beams.
/// Touching circles do not meet: the crossing would have no direction.
[[nodiscard]] ArcMeetings meetings_of(const WindowArc& own, const WindowArc& other, double baseline_min_m);

/// Of the meetings of one pair of arcs, and of the places that came out of the pairs before it.
class TriangulationHypotheses {
 public:
  struct Meeting {
    Vec2 position;
    const WindowArc* other = nullptr;
  };
  struct Hypothesis {
    Vec2 sum;
    std::vector<Meeting> meetings;
    [[nodiscard]] Vec2 mean() const { return sum / double(meetings.size()); }
    [[nodiscard]] double max_deviation_m() const;
  };

  TriangulationHypotheses(double gate_m, std::size_t most) : gate_m_(gate_m), most_(most) {}

  /// Which of two meetings counts: the one nearer a hypothesis; without any the one nearer the two axes.
  [[nodiscard]] Vec2 choose(const ArcMeetings& meetings, const WindowArc& own, const WindowArc& other) const;
  /// Joins the oldest hypothesis whose mean lies within the gate, or starts another while there is room.
  void add(Vec2 position, const WindowArc& other);
  /// Most meetings, then the smallest deviation, then the oldest; nullptr without any.
  [[nodiscard]] const Hypothesis* best() const;

 private:
  double gate_m_;
  std::size_t most_;
  std::vector<Hypothesis> hypotheses_;
};

/// Where the arcs of a hypothesis agree most: the weighted centroid of the best cells of a local grid around `start`,
/// whose axes lie along and across the beam of `own`.
[[nodiscard]] Vec2 refined_position(Vec2 start, const WindowArc& own,
                                    const TriangulationHypotheses::Hypothesis& hypothesis, double sigma_m);

}  // namespace echoarc
