// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <optional>

#include "echoarc/mapping/carved_grid.hpp"
#include "mapping/carver.hpp"

/// What a reading does to the cells of a carved grid.
namespace echoarc {

/// p - 1/2 of the occupied band at its range, by bearing from the arc's axis.
using BandAmplitude = std::function<double(Angle)>;

/// Where a reading says something: free to `free_to_m`, a band around the echo, nothing beyond `rim`.
struct CarvedBeam {
  Arc rim;
  std::optional<double> echo_m;
  double near_m = 0.0;
  double free_to_m = 0.0;
  double free_weight = 1.0;
};

/// None for a reading that says nothing to a grid.
[[nodiscard]] std::optional<CarvedBeam> carved_beam(const Reading& reading, const CarvedGridOptions& options);
[[nodiscard]] InverseSonarModel sonar_model(const CarvedGridOptions& options, Angle half_width);

/// The change of one cell in log-odds.
[[nodiscard]] double carved_increment(const CarvedBeam& beam, const InverseSonarModel& model,
                                      const BandAmplitude& amplitude, Vec2 centre);

/// The band of the evidence grid: the model's profile across the whole beam.
[[nodiscard]] BandAmplitude gaussian_band(const InverseSonarModel& model);
/// A band on what is left of an arc alone, the higher the less that is; none where the arc was removed.
[[nodiscard]] BandAmplitude remaining_band(const Remains& remains, const CarvedGridOptions& options);

}  // namespace echoarc
