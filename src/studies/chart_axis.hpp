// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/studies/svg_chart.hpp"

namespace echoarc::studies {

/// A number with so many decimals, never in exponent form; "-0" is "0".
[[nodiscard]] std::string fixed(double value, int decimals);

struct Tick {
  double value = 0.0;
  std::string text;
};

/// The stretch of numbers an axis shows, and where it is marked.
struct AxisScale {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
  std::vector<Tick> ticks;

  /// Share of the axis at which a value lies, 0 to 1 inside.
  [[nodiscard]] double share(double value) const;
};

/// The scale for an axis whose values run from `low` to `high` (not finite or crossed: there are none), marked about
/// `wanted` times. `widen` moves ends that the axis leaves open to the next mark.
[[nodiscard]] AxisScale scale_for(const ChartAxis& axis, double low, double high, int wanted, bool widen);

}  // namespace echoarc::studies
