// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace echoarc {

/// What the choice of a method's parameter looks at, for one value of it. Shares in 0..1.
struct ParameterScore {
  double cdr_full = 0.0;
  double cdr_empty = 0.0;
  double cdr_overall = 0.0;
  double mae_m = 0.0;

  /// |CDR_F - CDR_E|; NaN where one of them is.
  [[nodiscard]] double gap() const;
};

/// The value that the rule of [Barshan07] 4.2 takes, and those that it would take as well.
struct ParameterChoice {
  std::size_t best = 0;
  /// All values whose gap exceeds that of the best by at most `near_gap`, the best one first, then by the rule.
  std::vector<std::size_t> candidates;
};

inline constexpr double near_gap = 0.05;

/// Chooses the parameter for which CDR_F and CDR_E are as close as possible ([Barshan07] 4.2). Of equal gaps (to 1e-12)
/// the larger CDR_O wins, then the smaller mean absolute error, then the earlier value. Values whose gap is NaN take no
/// part; no choice when none is left.
[[nodiscard]] std::optional<ParameterChoice> choose_parameter(std::span<const ParameterScore> values);

}  // namespace echoarc
