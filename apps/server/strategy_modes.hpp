// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "echoarc/core/result.hpp"
#include "echoarc/nav/strategies.hpp"

namespace echoarc::server {

/// Goes to where the robot was when its session began.
inline constexpr std::string_view home_mode = "home";

/// Modes in which a strategy drives: every strategy that needs no list of goals, "goto", and the way home.
[[nodiscard]] std::span<const std::string_view> strategy_modes();

/// The strategy of such a mode, under the mode's name. Errors: an unknown mode; "goto" and "home" without a goal.
[[nodiscard]] Result<std::unique_ptr<nav::Strategy>> make_mode(std::string_view mode,
                                                               const nav::StrategySettings& settings);

}  // namespace echoarc::server
