// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/angle.hpp"
#include "echoarc/mapping/consensus_options.hpp"

namespace echoarc::consensus {

/// Nothing is searched farther from a sensor's axis.
inline constexpr Angle widest_search = degrees(45.0);

/// What is assumed of a beam, in its stated widths.
struct BeamPrior {
  double sigma_beams = 0.0;   ///< standard deviation of an echo's bearing
  double search_beams = 0.0;  ///< bearings searched to either side of the axis
};

/// The bearings t = -half ... half steps on which the echo of a beam is searched, and what the beam alone says of them.
/// Vectors are filled up to whole blocks of the kernels.
struct BeamBins {
  Angle beam_width;
  int half = 0;
  float sigma_rad = 0.0F;  ///< standard deviation of an echo's bearing
  std::vector<float> t_rad;
  std::vector<float> cos_t;
  std::vector<float> sin_t;
  std::vector<float> log_prior;  ///< -(t/sigma)^2/2
  std::vector<float> prior;      ///< sums to 1
  float prior_top = 0.0F;        ///< its largest value
  double cone_cos = 0.0;         ///< of the angle beyond which it says nothing of points
  double cone_sin = 0.0;

  [[nodiscard]] int count() const { return 2 * half + 1; }
  [[nodiscard]] int padded() const { return int(t_rad.size()); }
  [[nodiscard]] double search_rad(Angle step) const { return half * step.rad(); }
};

[[nodiscard]] BeamBins make_bins(const ConsensusOptions& options, const BeamPrior& prior, Angle beam_width);

}  // namespace echoarc::consensus
