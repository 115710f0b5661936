// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/spread.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::studies {

Spread spread_of(std::span<const double> values) {
  Spread spread;
  spread.runs = values.size();
  double sum = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    spread.min = spread.values == 0 ? value : std::min(spread.min, value);
    spread.max = spread.values == 0 ? value : std::max(spread.max, value);
    ++spread.values;
    sum += value;
  }
  if (spread.values == 0) return spread;
  spread.mean = sum / double(spread.values);
  double squares = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = spread.values == 1 ? 0.0 : std::sqrt(squares / double(spread.values - 1));
  return spread;
}

}  // namespace echoarc::studies
