// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/bytes.hpp"
#include "echoarc/core/reading.hpp"

namespace echoarc {

/// What directions of interest are derived from, gathered while readings come in: the lines of sight along which echoes
/// came, and the path the robot took between them. Readings without an arc leave no trace here, so silence can never
/// add a direction of interest.
class DoiHistory {
 public:
  /// A line of sight that gave an echo.
  struct Sight {
    Vec2 origin;     ///< centre of the arc, world
    Vec2 direction;  ///< unit vector along its axis
    double range_m = 0.0;
    double range_max_m = 0.0;  ///< the sensor's limit: how far to look along the line
  };
  /// One sweep of the array, with the nearest echo on each side of the robot.
  struct Stop {
    std::uint32_t scan = 0;
    WallSide wall = WallSide::unknown;  ///< the followed wall, where the log names it
    double nearest_left_m = std::numeric_limits<double>::infinity();
    double nearest_right_m = std::numeric_limits<double>::infinity();
  };
  /// A place on the path; the next one is at least a cell away.
  struct Waypoint {
    Vec2 position;
    Angle heading;
    std::uint64_t stop = 0;  ///< index into `stops()`
  };

  /// \p spacing_m: least distance between waypoints. What is not kept costs no memory.
  DoiHistory(bool keep_sights, bool keep_path, double spacing_m)
      : keep_sights_(keep_sights), keep_path_(keep_path), spacing_m_(spacing_m) {}

  void add(const Reading& reading, const Arc& arc);

  [[nodiscard]] std::span<const Sight> sights() const { return sights_; }
  [[nodiscard]] std::span<const Stop> stops() const { return stops_; }
  [[nodiscard]] std::span<const Waypoint> path() const { return path_; }
  [[nodiscard]] bool has_wall_labels() const { return has_wall_labels_; }
  [[nodiscard]] double range_max_m() const { return range_max_m_; }  ///< largest limit of the sensors that gave an echo
  [[nodiscard]] std::size_t memory_bytes() const {
    return sights_.size() * sizeof(Sight) + stops_.size() * sizeof(Stop) + path_.size() * sizeof(Waypoint);
  }

  void save(ByteWriter& out) const;
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  void add_to_path(const Reading& reading, const Arc& arc);

  bool keep_sights_;
  bool keep_path_;
  double spacing_m_;
  bool has_wall_labels_ = false;
  double range_max_m_ = 0.0;
  std::vector<Sight> sights_;
  std::vector<Stop> stops_;
  std::vector<Waypoint> path_;
};

/// The side on which the robot follows a wall, per stop: where the log names it, that; elsewhere the side of the
/// nearest echo among the side sensors, changed only after \p switch_stops stops in a row say otherwise
/// ([Barshan07] 4.2).
[[nodiscard]] std::vector<WallSide> followed_sides(std::span<const DoiHistory::Stop> stops, int switch_stops);

}  // namespace echoarc
