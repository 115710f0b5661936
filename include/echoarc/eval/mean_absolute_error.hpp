// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/eval/reference.hpp"

namespace echoarc {

/// Mean distance in metres from the points of a map to their nearest reference points ([Barshan07] 4.2, MAE); NaN for
/// an empty map. Says nothing of what the map leaves out.
[[nodiscard]] double mean_absolute_error_m(const PointSet& map, const Reference& reference);

}  // namespace echoarc
