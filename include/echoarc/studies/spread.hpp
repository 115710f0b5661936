// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace echoarc::studies {

/// A figure measured several times, once per seed. All NaN when no run gave a value.
struct Spread {
  double mean = std::numeric_limits<double>::quiet_NaN();
  double deviation = std::numeric_limits<double>::quiet_NaN();  ///< standard, with n - 1; 0 for a single value
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t values = 0;  ///< that are finite; the others are left out
  std::uint64_t runs = 0;
};

[[nodiscard]] Spread spread_of(std::span<const double> values);

}  // namespace echoarc::studies
