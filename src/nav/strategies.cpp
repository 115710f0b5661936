// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/strategies.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "echoarc/nav/frontier_exploration.hpp"
#include "echoarc/nav/go_to.hpp"
#include "echoarc/nav/vector_field_histogram.hpp"
#include "echoarc/nav/voronoi_exploration.hpp"
#include "echoarc/nav/wall_follower.hpp"

namespace echoarc::nav {
namespace {

template <bool left>
std::unique_ptr<Strategy> make_wall_follower(const StrategySettings& settings) {
  WallFollowerOptions options;
  options.left = left;
  options.cruise_m_s = settings.cruise_m_s;
  return std::make_unique<WallFollower>(settings.body, options);
}

/// Around what the points say, by a histogram that remembers.
Avoidance histogram_avoidance(const StrategySettings& settings) {
  HistogramOptions options;
  options.cruise_m_s = settings.cruise_m_s;
  const auto histogram = std::make_shared<VectorFieldHistogram>(settings.body, options);
  return [histogram](const Surroundings& surroundings, Vec2 target) -> RobotVelocity {
    const auto heading = histogram->steer(surroundings.T_world_base, target, surroundings.points);
    return heading ? histogram->velocity(surroundings.T_world_base, *heading) : RobotVelocity{};
  };
}

std::unique_ptr<Strategy> make_frontier_exploration(const StrategySettings& settings) {
  FrontierExplorationOptions options;
  options.follower.speed_m_s = settings.cruise_m_s;
  return std::make_unique<FrontierExploration>(settings.body, options, histogram_avoidance(settings));
}

std::unique_ptr<Strategy> go_to(const StrategySettings& settings, std::vector<Vec2> goals, std::string_view name) {
  GoToOptions options;
  options.follower.speed_m_s = settings.cruise_m_s;
  options.follower.arrival_m = 0.2;  // nearer by, a histogram of sectors may turn the robot for ever
  return std::make_unique<GoTo>(std::move(goals), settings.body, options, histogram_avoidance(settings), name);
}

std::unique_ptr<Strategy> make_go_to(const StrategySettings& settings) {
  return go_to(settings, {settings.goals.front()}, "goto");
}

std::unique_ptr<Strategy> make_manual_script(const StrategySettings& settings) {
  return go_to(settings, settings.goals, "manual-script");
}

std::unique_ptr<Strategy> make_voronoi_exploration(const StrategySettings& settings) {
  return std::make_unique<VoronoiExploration>(settings.body);
}

constexpr std::array all{
    StrategyEntry{"frontier", "Explore frontiers", "to where what is known ends, until nothing is left", false,
                  &make_frontier_exploration},
    StrategyEntry{"wall-left", "Follow the left wall", "once round with the wall on the left", false,
                  &make_wall_follower<true>},
    StrategyEntry{"wall-right", "Follow the right wall", "once round with the wall on the right", false,
                  &make_wall_follower<false>},
    StrategyEntry{"gvg", "Explore the Voronoi graph", "along what is equally far from the nearest obstacles", false,
                  &make_voronoi_exploration},
    StrategyEntry{"manual-script", "Go from goal to goal", "to the scene's goals, one after the other", true,
                  &make_manual_script},
    StrategyEntry{"goto", "Go to a point", "to the first goal, around what is in the way", true, &make_go_to},
};

std::string names() {
  std::string text;
  for (const StrategyEntry& entry : all) text += (text.empty() ? "" : ", ") + std::string(entry.name);
  return text;
}

}  // namespace

std::span<const StrategyEntry> strategies() {
  return all;
}

const StrategyEntry* find_strategy(std::string_view name) {
  const auto found = std::ranges::find(all, name, &StrategyEntry::name);
  return found != all.end() ? &*found : nullptr;
}

Result<std::unique_ptr<Strategy>> make_strategy(std::string_view name, const StrategySettings& settings) {
  const StrategyEntry* entry = find_strategy(name);
  if (entry == nullptr)
    return Error{ErrorCode::bad_value, "there is no strategy of that name", std::string(name),
                 "take one of " + names()};
  if (entry->needs_goals && settings.goals.empty())
    return Error{ErrorCode::bad_value, "there is no goal to go to", std::string(name),
                 "give the scene a table [explore] with goals = [[x, y], ...]"};
  return entry->make(settings);
}

}  // namespace echoarc::nav
