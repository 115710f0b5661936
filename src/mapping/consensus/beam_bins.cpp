// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/beam_bins.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/consensus/posterior_kernels.hpp"

namespace echoarc::consensus {

BeamBins make_bins(const ConsensusOptions& options, const BeamPrior& prior, Angle beam_width) {
  BeamBins bins;
  bins.beam_width = beam_width;
  const Angle search = std::min(prior.search_beams * beam_width, widest_search);
  bins.half = std::max(1, int(std::lround(search / options.step)));
  const double sigma_rad = std::max((prior.sigma_beams * beam_width).rad(), 0.5 * options.step.rad());
  bins.sigma_rad = float(sigma_rad);
  const int blocks = (bins.count() + kernels::bin_block - 1) / kernels::bin_block;
  double sum = 0.0;
  for (int k = 0; k < blocks * kernels::bin_block; ++k) {
    const double t_rad = (k - bins.half) * options.step.rad();
    const double log_prior = -0.5 * (t_rad / sigma_rad) * (t_rad / sigma_rad);
    bins.t_rad.push_back(float(t_rad));
    bins.cos_t.push_back(float(std::cos(t_rad)));
    bins.sin_t.push_back(float(std::sin(t_rad)));
    bins.log_prior.push_back(float(log_prior));
    bins.prior.push_back(k < bins.count() ? float(std::exp(log_prior)) : 0.0F);
    sum += k < bins.count() ? std::exp(log_prior) : 0.0;
  }
  for (float& p : bins.prior) p = float(double(p) / sum);
  const Angle cone = std::max((bins.half + 1) * options.step, options.facing_angle + options.step);
  bins.cone_cos = cos(cone);
  bins.cone_sin = sin(cone);
  bins.prior_top = bins.prior[std::size_t(bins.half)];
  return bins;
}

}  // namespace echoarc::consensus
