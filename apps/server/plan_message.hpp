// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "echoarc/nav/strategy.hpp"

namespace echoarc::server {

inline constexpr std::size_t most_plan_nodes = 1000;
inline constexpr std::size_t most_plan_points = 4000;  ///< of all edges, and of the path

/// The `plan` message: what a strategy has in mind, in millimetres, lines no finer than the eye can tell on a map. What
/// is too long for one message becomes coarser; what is too much is left out, and counted.
[[nodiscard]] std::string plan_message(std::string_view strategy, const nav::Sketch& sketch);
/// Nothing is planned.
[[nodiscard]] std::string no_plan_message();

}  // namespace echoarc::server
