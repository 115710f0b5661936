// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

/// What all strategies need to know.
struct StrategySettings {
  RobotBody body;
  double cruise_m_s = 0.25;
  std::vector<Vec2> goals;  ///< of "goto" (the first) and "manual-script" (all, in this order), world, m
};

/// A strategy as it is chosen by name.
struct StrategyEntry {
  std::string_view name;
  std::string_view title;    ///< for people: "Follow the left wall"
  std::string_view summary;  ///< one sentence
  bool needs_goals = false;
  std::unique_ptr<Strategy> (*make)(const StrategySettings&);
};

[[nodiscard]] std::span<const StrategyEntry> strategies();
/// Null for a name that is none.
[[nodiscard]] const StrategyEntry* find_strategy(std::string_view name);
/// Errors: an unknown name, a strategy without the goals it needs.
[[nodiscard]] Result<std::unique_ptr<Strategy>> make_strategy(std::string_view name, const StrategySettings& settings);

}  // namespace echoarc::nav
