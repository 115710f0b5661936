// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace echoarc {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

bool has_order(std::span<const double> values) {
  return !values.empty() && std::none_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

}  // namespace

double median(std::span<const double> values) {
  if (!has_order(values)) return undefined;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double percentile(std::span<const double> values, double share) {
  assert(share > 0.0 && share <= 1.0);
  if (!has_order(values)) return undefined;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  // 0.95 * 20 is 19 in numbers and a little more in doubles; the slack keeps the rank from slipping up.
  const double rank = std::ceil(share * double(sorted.size()) - 1e-9);
  return sorted[std::size_t(std::max(rank, 1.0)) - 1];
}

double mean(std::span<const double> values) {
  return values.empty() ? undefined : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace echoarc
