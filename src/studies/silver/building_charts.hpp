// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

#include "echoarc/studies/svg_chart.hpp"
#include "studies/silver/building_run.hpp"

/// Figs. 10 to 12 of [Silver04]: means over the seeds within least and most.
namespace echoarc::studies::silver {

[[nodiscard]] Chart latency_chart(std::span<const BuildingRun> runs);
[[nodiscard]] Chart length_chart(std::span<const BuildingRun> runs);
[[nodiscard]] Chart error_chart(std::span<const BuildingRun> runs);

}  // namespace echoarc::studies::silver
