// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

namespace echoarc::nav {

/// Tells when a robot gets no nearer to where it goes. A path that has become longer, because the map shows that it
/// must, gives it new time, but only so often: two ways that take turns in being the better one are no progress either.
class ProgressWatch {
 public:
  explicit ProgressWatch(double patience_s) : patience_s_(patience_s) {}

  void reset() { since_s_.reset(); }
  /// Whether `remaining_m` has not become less for so long.
  [[nodiscard]] bool stalled(double time_s, double remaining_m);

 private:
  static constexpr double progress_m = 0.1;
  static constexpr double detour_m = 0.5;
  static constexpr int most_detours = 20;

  double patience_s_;
  std::optional<double> since_s_;
  double least_m_ = 0.0;
  double before_m_ = 0.0;
  int detours_ = 0;
};

}  // namespace echoarc::nav
