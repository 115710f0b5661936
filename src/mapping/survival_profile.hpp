// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/angle.hpp"

namespace echoarc {

/// What is left of an arc, relative to its axis.
struct AngleInterval {
  Angle begin;
  Angle end;
};

/// How the arcs of a sensor survive carving across its beam: a factor in [0, 1] by bearing from the axis, at most 1.
///
/// Share of the arcs that contain the middle of each bin of one degree, smoothed over three bins, scaled to a largest
/// value of 1; linear between the middles of bins.
class SurvivalProfile {
 public:
  /// No value when no arc contains the middle of any bin.
  [[nodiscard]] static std::optional<SurvivalProfile> of(std::span<const AngleInterval> arcs, Angle half_width);

  [[nodiscard]] double at(Angle theta) const;

 private:
  std::vector<double> factors_;  // bin k is centred k - (size - 1) / 2 degrees from the axis
};

}  // namespace echoarc
