// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

namespace echoarc {

/// The middle value; the mean of the two middle ones for an even number; NaN for none, or if one is NaN.
[[nodiscard]] double median(std::span<const double> values);

/// The smallest of the values that a share of at least `share` does not exceed (nearest rank, no interpolation); NaN
/// for none, or if one is NaN. Requires 0 < share <= 1.
[[nodiscard]] double percentile(std::span<const double> values, double share);

/// NaN for none.
[[nodiscard]] double mean(std::span<const double> values);

}  // namespace echoarc
