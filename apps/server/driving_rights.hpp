// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>

namespace echoarc::server {

using ViewerId = std::uint32_t;

/// Who drives. One at a time; the right is taken when it is free, else asked for, and goes back when its holder is
/// gone. Times are the host's monotonic seconds.
class DrivingRights {
 public:
  static constexpr double request_timeout_s = 20.0;  ///< no answer for so long: the driver keeps driving

  enum class Taken : std::uint8_t { yes, asked, busy };
  /// `busy`: somebody else asks already.
  [[nodiscard]] Taken take(ViewerId viewer, double now_s);
  /// The driver's answer; who asked, and gets it if `accept`. None: nobody asks, or it is not the driver who answers.
  [[nodiscard]] std::optional<ViewerId> answer(ViewerId driver, bool accept);
  /// Hands over to `to`; without it to who asks, or to nobody. False: not the driver.
  [[nodiscard]] bool release(ViewerId driver, std::optional<ViewerId> to);
  /// The viewer is gone, or may not drive any more. True if it drove.
  bool leave(ViewerId viewer);
  /// Who asked in vain for too long, once.
  [[nodiscard]] std::optional<ViewerId> expired(double now_s);

  [[nodiscard]] std::optional<ViewerId> driver() const { return driver_; }
  [[nodiscard]] std::optional<ViewerId> asking() const { return asking_; }

 private:
  std::optional<ViewerId> driver_;
  std::optional<ViewerId> asking_;
  double asked_s_ = 0.0;
};

}  // namespace echoarc::server
