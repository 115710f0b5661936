// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "sim/office_plan.hpp"

namespace echoarc::sim {
namespace {

struct Crossing {
  std::size_t column = 0;
  std::size_t row = 0;
  friend bool operator==(Crossing, Crossing) = default;
};

enum class Heading : std::uint8_t { east, north, west, south };
constexpr std::array all_headings{Heading::east, Heading::north, Heading::west, Heading::south};

/// Walks the lattice until it has gone along every stretch: on along unknown ones as long as there are any, otherwise
/// by the shortest way to the nearest crossing that has one.
class TourWalk {
 public:
  explicit TourWalk(const OfficePlan& plan)
      : plan_(plan),
        columns_(plan.column_x.size()),
        rows_(plan.row_y.size()),
        walked_(2 * columns_ * rows_, false),
        came_by_(columns_ * rows_) {}

  std::vector<Vec2> walk() {
    points_.push_back(place(at_));
    while (true) {
      if (const std::optional<Heading> next = unknown_from(at_)) {
        go(*next);
        continue;
      }
      const std::vector<Heading> way = way_to_unknown();
      if (way.empty()) return std::move(points_);
      for (const Heading heading : way) go(heading);
    }
  }

 private:
  [[nodiscard]] Vec2 place(Crossing c) const { return {plan_.column_x[c.column], plan_.row_y[c.row]}; }
  [[nodiscard]] std::size_t index(Crossing c) const { return c.row * columns_ + c.column; }

  [[nodiscard]] std::optional<Crossing> neighbour(Crossing c, Heading heading) const {
    if (heading == Heading::east && c.column + 1 < columns_) return Crossing{c.column + 1, c.row};
    if (heading == Heading::north && c.row + 1 < rows_) return Crossing{c.column, c.row + 1};
    if (heading == Heading::west && c.column > 0) return Crossing{c.column - 1, c.row};
    if (heading == Heading::south && c.row > 0) return Crossing{c.column, c.row - 1};
    return std::nullopt;
  }

  /// A stretch is known by its left or lower end and its direction.
  [[nodiscard]] std::size_t stretch(Crossing c, Heading heading) const {
    const bool along_row = heading == Heading::east || heading == Heading::west;
    const bool backwards = heading == Heading::west || heading == Heading::south;
    return 2 * index(backwards ? *neighbour(c, heading) : c) + (along_row ? 0 : 1);
  }

  [[nodiscard]] std::optional<Heading> unknown_from(Crossing c) const {
    const auto unknown = [&](Heading heading) { return neighbour(c, heading) && !walked_[stretch(c, heading)]; };
    if (unknown(heading_)) return heading_;  // straight on, if that is possible
    const auto found = std::ranges::find_if(all_headings, unknown);
    return found != all_headings.end() ? std::optional(*found) : std::nullopt;
  }

  void go(Heading heading) {
    const Crossing next = *neighbour(at_, heading);
    const std::size_t id = stretch(at_, heading);
    if (!walked_[id] && next.row == at_.row) visit_rooms(heading);
    walked_[id] = true;
    points_.push_back(place(next));
    at_ = next;
    heading_ = heading;
  }

  void visit_rooms(Heading heading) {
    const std::size_t left = heading == Heading::east ? at_.column : at_.column - 1;
    const auto visit = [this](const OfficeDoor& door) {
      if (door.visited) points_.insert(points_.end(), {door.outside, door.inside, door.outside});
    };
    const std::vector<OfficeDoor>& doors = plan_.doors_of(at_.row, left);
    if (heading == Heading::east)
      std::for_each(doors.begin(), doors.end(), visit);
    else
      std::for_each(doors.rbegin(), doors.rend(), visit);
  }

  /// Breadth first; empty when every stretch is walked.
  [[nodiscard]] std::vector<Heading> way_to_unknown() {
    std::fill(came_by_.begin(), came_by_.end(), std::nullopt);
    std::deque<Crossing> front{at_};
    while (!front.empty()) {
      const Crossing c = front.front();
      front.pop_front();
      if (unknown_from(c)) return way_back(c);
      for (const Heading heading : all_headings) {
        const std::optional<Crossing> next = neighbour(c, heading);
        if (!next || *next == at_ || came_by_[index(*next)]) continue;
        came_by_[index(*next)] = heading;
        front.push_back(*next);
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<Heading> way_back(Crossing c) const {
    std::vector<Heading> way;
    while (!(c == at_)) {
      const Heading heading = *came_by_[index(c)];
      way.push_back(heading);
      c = *neighbour(c, all_headings[(static_cast<std::size_t>(heading) + 2) % 4]);
    }
    std::ranges::reverse(way);
    return way;
  }

  const OfficePlan& plan_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<bool> walked_;
  std::vector<std::optional<Heading>> came_by_;
  std::vector<Vec2> points_;
  Crossing at_;
  Heading heading_ = Heading::east;
};

/// Without the points that lie on the way from the one before to the one after.
std::vector<Vec2> without_middles(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept;
  for (const Vec2 point : points) {
    if (!kept.empty() && point == kept.back()) continue;
    if (kept.size() >= 2) {
      const Vec2 before = kept.back() - kept[kept.size() - 2];
      const Vec2 after = point - kept.back();
      if (cross(before, after) == 0.0 && dot(before, after) > 0.0) kept.pop_back();
    }
    kept.push_back(point);
  }
  return kept;
}

}  // namespace

std::vector<Vec2> office_tour(const OfficePlan& plan) {
  return without_middles(TourWalk(plan).walk());
}

}  // namespace echoarc::sim
