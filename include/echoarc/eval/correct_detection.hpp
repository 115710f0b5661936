// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "echoarc/core/result.hpp"
#include "echoarc/eval/directions.hpp"
#include "echoarc/eval/reference.hpp"

namespace echoarc {

/// Correct detection ratios over directions of interest ([Barshan07] eqs. 9-11).
struct CorrectDetection {
  std::uint64_t full = 0;  ///< directions on which the reference has a point
  std::uint64_t empty = 0;
  std::uint64_t correct_full = 0;  ///< full, and the map has a point there, too
  std::uint64_t correct_empty = 0;

  /// CDR_F, CDR_E, CDR_O: shares in 0..1. NaN when there is nothing to divide by; such a share plays no part in CDR_O.
  [[nodiscard]] double full_ratio() const { return ratio(correct_full, full); }
  [[nodiscard]] double empty_ratio() const { return ratio(correct_empty, empty); }
  [[nodiscard]] double overall_ratio() const { return ratio(correct_full + correct_empty, full + empty); }

  friend bool operator==(const CorrectDetection&, const CorrectDetection&) = default;

 private:
  [[nodiscard]] static double ratio(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : double(part) / double(whole);
  }
};

/// Holds the map against the reference direction by direction. A direction is full when at least one point lies on it,
/// wherever along it. A cell lies on the line of its centre and on those whose middle is less than half a cell away, so
/// that a coarse map is full on every fine line its cells cover.
///
/// With `tolerance_m` a full direction is correct only if one of the map's points on it is that near to the reference;
/// such figures cannot be compared with the paper's. Errors: those of `validate`, and a tolerance that is negative or
/// NaN.
[[nodiscard]] Result<CorrectDetection> correct_detection(const PointSet& map, const Reference& reference,
                                                         const DirectionSet& directions,
                                                         std::optional<double> tolerance_m = std::nullopt);

}  // namespace echoarc
