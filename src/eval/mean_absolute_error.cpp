// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/mean_absolute_error.hpp"

#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/eval/statistics.hpp"

namespace echoarc {

double mean_absolute_error_m(const PointSet& map, const Reference& reference) {
  return mean(nearest_distances_m(map, reference.points));
}

}  // namespace echoarc
