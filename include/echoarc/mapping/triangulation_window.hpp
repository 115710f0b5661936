// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/bytes.hpp"
#include "echoarc/core/reading.hpp"

namespace echoarc {

/// A monostatic arc as triangulation needs it: everything a pair of arcs asks for is computed once.
struct WindowArc {
  Vec2 sensor;
  Vec2 axis;  ///< unit vector along the acoustic axis
  Vec2 midpoint;
  double range_m = 0.0;
  double half_width_rad = 0.0;
  double reach_m = 0.0;      ///< from the midpoint to the ends, 2 r sin(h / 2): no point of the arc is farther
  double along_min_m = 0.0;  ///< r cos(h): a point of the circle that lies at least so far along the axis is on the arc
  PingId ping = 0;
  SensorId id = 0;

  [[nodiscard]] static WindowArc of(const Reading& reading, double range_m);
  /// Whether a point of the whole circle lies on the arc; ends included.
  [[nodiscard]] bool contains(Vec2 p) const { return dot(p - sensor, axis) >= along_min_m; }
  /// The acoustic axis to the bearing of `p`, unsigned.
  [[nodiscard]] double off_axis_rad(Vec2 p) const;
};

/// How far apart the columns of a window are.
struct WindowShape {
  int rows = 0;     ///< most arcs in a column
  int columns = 1;  ///< the newest one included
  double column_m = 0.0;
  Angle column_turn;
};

/// The sliding window of triangulation-based fusion ([Barshan07] 3.7): the most recent columns, each with one arc per
/// sonar. A column ends when the robot has moved or turned far enough; until then a sonar's first echo fills its row
/// and further ones are passed over. So a robot that stands still does not fill the window with copies.
class TriangulationWindow {
 public:
  struct Column {
    Pose2 T_world_robot;  ///< where the column began
    std::vector<WindowArc> arcs;
  };

  /// Where a reading would go.
  enum class Place { new_column, newest_column, none };

  explicit TriangulationWindow(const WindowShape& shape) : shape_(shape), columns_(std::size_t(shape.columns)) {}

  [[nodiscard]] Place place_of(const Reading& reading) const;
  /// Puts an arc to its place, which must not be `none`; a new column pushes the oldest out of a full window.
  void put(const Reading& reading, const WindowArc& arc, Place place);
  /// Ages [begin, end) of the columns that a reading at this place is compared with: those that will be older than its
  /// own, without the one that a new column pushes out.
  [[nodiscard]] std::pair<std::size_t, std::size_t> older_columns(Place place) const {
    if (place == Place::newest_column) return {1, used_};
    return {0, std::min(used_, columns_.size() - 1)};
  }
  /// Columns in use, at most `columns`.
  [[nodiscard]] std::size_t size() const { return used_; }
  /// Column number `age`; 0 is the newest.
  [[nodiscard]] const Column& column(std::size_t age) const {
    return columns_[(newest_ + columns_.size() - age) % columns_.size()];
  }

  void save(ByteWriter& out) const;
  /// False when the bytes do not hold a window of this shape.
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  WindowShape shape_;
  std::vector<Column> columns_;
  std::size_t newest_ = 0;
  std::size_t used_ = 0;
};

}  // namespace echoarc
