// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "echoarc/live/mapper.hpp"

namespace echoarc::live {

/// How good the map of one method is by now. What cannot be said is left out.
struct MethodScore {
  std::string method;  ///< its id
  std::size_t points = 0;
  std::optional<double> bound_m;  ///< median bound of its points
  std::optional<double> mae_m;    ///< mean distance of its points to the nearest true wall
  std::optional<double> p95_m;    ///< of those distances
  std::optional<double> found;    ///< share of the wall seen from the path so far with a map point within 10 cm
  std::optional<double> cpu_ms_per_ping;
};

struct Scores {
  double time_s = 0.0;
  std::string reason;  ///< why maps are held against nothing; empty when they are
  std::vector<MethodScore> methods;
};

/// Holds the maps of a mapper against the truth while they form: against the walls of the source, or where those are
/// unknown against what the robot's own laser has seen so far. Which part of the walls could be seen at all is followed
/// along the true path, or the odometry where that is all there is.
class ScoreKeeper {
 public:
  static constexpr double interval_s = 1.0;  ///< of record time, between entries of the history
  static constexpr double found_distance_m = 0.1;
  static constexpr double path_step_m = 0.05;

  explicit ScoreKeeper(const SourceDescription& source);
  ScoreKeeper(ScoreKeeper&&) noexcept;
  ScoreKeeper& operator=(ScoreKeeper&&) noexcept;
  ~ScoreKeeper();

  /// Every record, in order, as the mapper gets them.
  void push(const Record& record);
  /// Whether the records have gone on by `interval_s` since the last entry.
  [[nodiscard]] bool due() const;
  /// Scores the newest exports of the mapper and adds them to the history.
  const Scores& update(const Mapper& mapper);
  [[nodiscard]] std::span<const Scores> history() const;
  /// Forgets everything but the source.
  void restart();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace echoarc::live
