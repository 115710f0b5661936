// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>

namespace echoarc {

/// CPU time of one run of a method, measured by the host: the library reads no clock. Reading files is left out.
struct Timing {
  double insert_cpu_s = 0.0;  ///< readings into the method (for arc maps: building the map of arcs)
  double finish_cpu_s = 0.0;  ///< from there to the processed map
  std::uint64_t readings = 0;

  [[nodiscard]] double total_cpu_s() const { return insert_cpu_s + finish_cpu_s; }
  /// NaN without readings.
  [[nodiscard]] double per_reading_s() const;
};

/// The medians of several runs, each taken on its own; twenty runs or more make them steady. NaN without runs.
struct TimingSummary {
  std::uint64_t runs = 0;
  std::uint64_t readings = 0;  ///< of each run
  double insert_cpu_s = 0.0;
  double finish_cpu_s = 0.0;
  double total_cpu_s = 0.0;
  double per_reading_s = 0.0;
};
/// The runs must have the same number of readings.
[[nodiscard]] TimingSummary summarise(std::span<const Timing> runs);

}  // namespace echoarc
