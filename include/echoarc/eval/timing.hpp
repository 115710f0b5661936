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

/// The middle value; the mean of the two middle ones for an even number; NaN for none, or if one is NaN.
[[nodiscard]] double median(std::span<const double> values);

/// Each figure is the median over the runs on its own. Twenty runs or more make it steady.
struct TimingSummary {
  std::uint64_t runs = 0;
  Timing median;
};
/// The runs must have the same number of readings. Without runs every time is NaN.
[[nodiscard]] TimingSummary summarise(std::span<const Timing> runs);

}  // namespace echoarc
