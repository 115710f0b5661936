// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/log.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::bench {

/// The sonar drive every benchmark is measured on.
///
/// A ring of 16 sonars (radius 0.23 m, 25 degree beams, 0.15 to 5.75 m) drives loops through a room of 20 x 15 m with a
/// block, four pillars and a cabinet. Each beam reports the nearest point of any surface inside it, however slanted
/// (real slanted walls are often silent, so maps of this drive say nothing about accuracy), plus 5 mm of noise. A beam
/// with nothing within 5.75 m reports no echo. Loop and range limit are chosen so that mean range and share of silence
/// come out like those of the drive the published figures of other systems were taken on; see bench/README.md.
struct WorkloadOptions {
  std::uint64_t seed = 1;
  std::size_t readings = 100'000;
  double range_max_m = 5.75;   ///< the sonars hear no further; silence counts as free space to here
  double loop_half_x_m = 6.8;  ///< half axes of the loop the robot drives around the room's middle
  double loop_half_y_m = 4.9;
};

/// Readings in the order of time, made from a seed: the same everywhere.
[[nodiscard]] std::vector<Reading> make_workload(const WorkloadOptions& options = {});

/// The same drive as a log: one odometry record per scan, one ping per reading, silence as REP 117 +Inf.
[[nodiscard]] Log make_workload_log(const WorkloadOptions& options = {});

/// Where a dense grid for the drive lies: 24 x 19 m, the room with 2 m around it.
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
[[nodiscard]] WorkloadSummary summarise(const std::vector<Reading>& readings);

/// To where a reading speaks: its echo's range, or its trusted range for silence.
[[nodiscard]] double reach_m(const Reading& reading);
/// The sector a reading covers, widened by \p margin_m beyond an echo.
[[nodiscard]] Arc rim_of(const Reading& reading, double margin_m = 0.0);

}  // namespace echoarc::bench
