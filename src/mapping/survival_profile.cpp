// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/survival_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace echoarc {
namespace {

/// Mean of each bin and its neighbours; at the ends of the beam of two.
std::vector<double> smoothed(const std::vector<double>& shares) {
  std::vector<double> means(shares.size());
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const std::size_t first = k > 0 ? k - 1 : 0;
    const std::size_t last = std::min(k + 1, shares.size() - 1);
    double sum = 0.0;
    for (std::size_t n = first; n <= last; ++n) sum += shares[n];
    means[k] = sum / double(last - first + 1);
  }
  return means;
}

}  // namespace

std::optional<SurvivalProfile> SurvivalProfile::of(std::span<const AngleInterval> arcs, Angle half_width) {
  const int side = int(std::floor(half_width.deg()));
  std::vector<double> shares(2 * std::size_t(side) + 1);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const Angle middle = degrees(double(k) - side);
    const auto contains = [&](const AngleInterval& arc) { return arc.begin <= middle && middle <= arc.end; };
    shares[k] = double(std::ranges::count_if(arcs, contains));
  }
  SurvivalProfile profile;
  profile.factors_ = smoothed(shares);
  const double largest = std::ranges::max(profile.factors_);
  if (!(largest > 0.0)) return std::nullopt;
  for (double& factor : profile.factors_) factor /= largest;
  return profile;
}

double SurvivalProfile::at(Angle theta) const {
  const double last = double(factors_.size() - 1);
  const double place = std::clamp(theta.deg() + 0.5 * last, 0.0, last);
  const auto below = std::size_t(place);
  const auto above = std::min(below + 1, factors_.size() - 1);
  const double fraction = place - double(below);
  return factors_[below] + fraction * (factors_[above] - factors_[below]);
}

}  // namespace echoarc
