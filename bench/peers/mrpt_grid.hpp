// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "bench/contestant.hpp"

namespace echoarc::bench {

/// MRPT's `COccupancyGridMap2D` fed with one `CObservationRange` per reading; null where MRPT was not found at
/// configuration.
[[nodiscard]] std::unique_ptr<Contestant> make_mrpt(double cell_m);

}  // namespace echoarc::bench
