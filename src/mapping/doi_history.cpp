// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/doi_history.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {
namespace {

/// A side sensor looks between 45 and 135 degrees to the left or right of the robot's heading.
WallSide side_of(const Reading& reading, const Arc& arc) {
  const Angle from_heading = wrap(arc.axis() - reading.T_world_robot.heading);
  if (abs(from_heading) < degrees(45.0) || abs(from_heading) > degrees(135.0)) return WallSide::unknown;
  return from_heading > Angle{} ? WallSide::left : WallSide::right;
}

WallSide nearer_side(const DoiHistory::Stop& stop) {
  if (stop.nearest_left_m == stop.nearest_right_m) return WallSide::unknown;
  return stop.nearest_left_m < stop.nearest_right_m ? WallSide::left : WallSide::right;
}

bool is_wall_side(std::uint8_t value) {
  return value <= static_cast<std::uint8_t>(WallSide::right);
}

}  // namespace

void DoiHistory::add(const Reading& reading, const Arc& arc) {
  range_max_m_ = std::max(range_max_m_, reading.range_max_m);
  if (keep_sights_) sights_.push_back({arc.centre(), unit(arc.axis()), arc.range_m(), reading.range_max_m});
  if (keep_path_) add_to_path(reading, arc);
}

void DoiHistory::add_to_path(const Reading& reading, const Arc& arc) {
  if (stops_.empty() || stops_.back().scan != reading.scan) stops_.push_back({.scan = reading.scan});
  Stop& stop = stops_.back();
  if (reading.wall != WallSide::unknown) {
    stop.wall = reading.wall;
    has_wall_labels_ = true;
  }
  const WallSide side = side_of(reading, arc);
  if (side == WallSide::left) stop.nearest_left_m = std::min(stop.nearest_left_m, arc.range_m());
  if (side == WallSide::right) stop.nearest_right_m = std::min(stop.nearest_right_m, arc.range_m());

  const Pose2& T_world_robot = reading.T_world_robot;
  if (path_.empty() || norm(T_world_robot.position - path_.back().position) >= spacing_m_)
    path_.push_back({T_world_robot.position, T_world_robot.heading, stops_.size() - 1});
}

void DoiHistory::save(ByteWriter& out) const {
  out.put<std::uint64_t>(has_wall_labels_ ? 1 : 0);
  out.put(range_max_m_);
  out.put_vector(sights_);
  out.put_vector(path_);
  out.put<std::uint64_t>(stops_.size());
  for (const Stop& stop : stops_) {  // one by one: the struct has padding
    out.put(stop.scan);
    out.put(stop.wall);
    out.put(stop.nearest_left_m);
    out.put(stop.nearest_right_m);
  }
}

bool DoiHistory::restore(ByteReader& in) {
  has_wall_labels_ = in.get<std::uint64_t>() != 0;
  range_max_m_ = in.get<double>();
  sights_ = in.get_vector<Sight>();
  path_ = in.get_vector<Waypoint>();
  const auto count = in.get<std::uint64_t>();
  stops_.clear();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    Stop stop;
    stop.scan = in.get<std::uint32_t>();
    const auto wall = in.get<std::uint8_t>();
    if (!is_wall_side(wall)) return false;
    stop.wall = static_cast<WallSide>(wall);
    stop.nearest_left_m = in.get<double>();
    stop.nearest_right_m = in.get<double>();
    stops_.push_back(stop);
  }
  const auto sane = [&](const Waypoint& w) {
    return is_finite(w.position) && is_finite(w.heading) && w.stop < stops_.size();
  };
  const auto visible = [](const Sight& s) { return is_finite(s.origin) && is_finite(s.direction); };
  return in.ok() && std::isfinite(range_max_m_) && std::ranges::all_of(path_, sane) &&
         std::ranges::all_of(sights_, visible);
}

std::vector<WallSide> followed_sides(std::span<const DoiHistory::Stop> stops, int switch_stops) {
  std::vector<WallSide> sides;
  sides.reserve(stops.size());
  WallSide followed = WallSide::unknown;
  int against = 0;  // stops in a row whose nearest echo is on the other side; a stop without one says nothing
  for (const DoiHistory::Stop& stop : stops) {
    const WallSide nearer = nearer_side(stop);
    if (stop.wall != WallSide::unknown) {
      followed = stop.wall;
      against = 0;
    } else if (nearer == followed) {
      against = 0;
    } else if (nearer != WallSide::unknown && (followed == WallSide::unknown || ++against >= switch_stops)) {
      followed = nearer;
      against = 0;
    }
    sides.push_back(followed);
  }
  return sides;
}

}  // namespace echoarc
