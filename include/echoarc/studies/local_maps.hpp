// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/mapping/atm.hpp"
#include "echoarc/mapping/carve.hpp"
#include "echoarc/mapping/centerline.hpp"
#include "echoarc/mapping/combined.hpp"
#include "echoarc/maps/neighbour_filter.hpp"

namespace echoarc::studies {

/// Points of a map with one of the labels.
[[nodiscard]] std::vector<MapPoint> labelled(std::span<const MapPoint> points,
                                             std::initializer_list<PointLabel> labels);
[[nodiscard]] std::vector<Vec2> positions(std::span<const MapPoint> points);

/// What the robot of [Silver04] has before its eyes at one moment: the newest 250 echoes as each method sees them,
/// after the test for company of App. B.
struct LocalMaps {
  std::vector<MapPoint> centerline;         ///< the middle of every arc
  std::vector<MapPoint> atm;                ///< medians alone
  std::vector<MapPoint> atm_centerline;     ///< medians, and the middle of arcs that have none (Figs. 4a, 9a)
  std::vector<MapPoint> carved;             ///< what carving has shortened
  std::vector<MapPoint> carved_centerline;  ///< and the middle of arcs it has not met yet (5.A)
  std::vector<MapPoint> atm_carved;         ///< medians and carved points (Fig. 9b)
  std::vector<MapPoint> combined;           ///< and the middle of arcs that have neither
};

/// Keeps all local maps of a drive up to date.
class LocalMapper {
 public:
  static constexpr int history = 250;

  explicit LocalMapper(NeighbourRule rule = {});
  /// Readings in the order of time.
  void insert(std::span<const Reading> readings);
  [[nodiscard]] LocalMaps maps();

 private:
  NeighbourRule rule_;
  AtmSilver atm_;
  Carve carve_;
  Combined combined_;
  Centerline centerline_;
};

/// Hands the readings to `mapper` and calls `look` whenever the robot has gone another `step_m`, with the reading at
/// which it had.
void look_along(std::span<const Reading> readings, double step_m, LocalMapper& mapper,
                const std::function<void(const Reading&)>& look);

}  // namespace echoarc::studies
