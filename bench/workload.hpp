// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bench/scene.hpp"
#include "echoarc/core/arc.hpp"
#include "echoarc/core/log.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::bench {

/// A drive with a ring of 16 sonars (radius 0.23 m, 25 degree beams) on an elliptical loop around the middle of a
/// scene.
///
/// Each beam reports the nearest point of any surface inside it, however slanted (real slanted walls are often silent,
/// so maps of these drives say nothing about accuracy), plus 5 mm of noise; with nothing in reach it reports no echo.
/// Loop and range limit of the default, the hall, are chosen so that mean range and share of silence come out like
/// those of the drive on which the published figures of other systems were taken; see bench/README.md.
struct WorkloadOptions {
  Scene scene = hall();
  std::uint64_t seed = 1;
  std::size_t readings = 100'000;  ///< at least 1
  double range_max_m = 5.75;       ///< the sonars hear no further; silence counts as free space to here
  double loop_half_x_m = 6.8;
  double loop_half_y_m = 4.9;
};

/// Readings in the order of time, made from a seed: the same everywhere.
[[nodiscard]] std::vector<Reading> make_workload(const WorkloadOptions& options = {});

/// The same drive as a log: one odometry record per sweep of the ring, silence as REP 117 +Inf.
[[nodiscard]] Log make_workload_log(const WorkloadOptions& options = {});

/// Where a dense grid for the hall lies: 24 x 19 m, the room with 2 m around it.
struct DenseArea {
  GridGeometry geometry;
  std::int32_t width = 0;
  std::int32_t height = 0;
};
[[nodiscard]] DenseArea workload_area(double cell_m);

struct WorkloadSummary {
  std::size_t readings = 0;
  double mean_range_m = 0.0;    ///< silence counted at the range limit
  double no_echo_share = 0.0;   ///< 0 to 1
  double sector_area_m2 = 0.0;  ///< mean area of the exact sector: beam/2 range^2
};
[[nodiscard]] WorkloadSummary summarise(std::span<const Reading> readings);

/// To where a reading speaks: its echo's range, or its trusted range for silence.
[[nodiscard]] double reach_m(const Reading& reading);
/// The sector a reading covers, widened by \p margin_m beyond an echo.
[[nodiscard]] Arc rim_of(const Reading& reading, double margin_m);

}  // namespace echoarc::bench
