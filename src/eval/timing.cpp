// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/timing.hpp"

#include <cassert>
#include <limits>
#include <vector>

#include "echoarc/eval/statistics.hpp"

namespace echoarc {

double Timing::per_reading_s() const {
  return readings == 0 ? std::numeric_limits<double>::quiet_NaN() : total_cpu_s() / double(readings);
}

TimingSummary summarise(std::span<const Timing> runs) {
  std::vector<double> insert_s;
  std::vector<double> finish_s;
  std::vector<double> total_s;
  std::vector<double> per_reading_s;
  for (const Timing& run : runs) {
    assert(run.readings == runs.front().readings);
    insert_s.push_back(run.insert_cpu_s);
    finish_s.push_back(run.finish_cpu_s);
    total_s.push_back(run.total_cpu_s());
    per_reading_s.push_back(run.per_reading_s());
  }
  return {.runs = runs.size(),
          .readings = runs.empty() ? 0 : runs.front().readings,
          .insert_cpu_s = median(insert_s),
          .finish_cpu_s = median(finish_s),
          .total_cpu_s = median(total_s),
          .per_reading_s = median(per_reading_s)};
}

}  // namespace echoarc
