// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/driving_rights.hpp"

#include <utility>

namespace echoarc::server {

DrivingRights::Taken DrivingRights::take(ViewerId viewer, double now_s) {
  if (!driver_ || driver_ == viewer) {
    driver_ = viewer;
    if (asking_ == viewer) asking_.reset();
    return Taken::yes;
  }
  if (asking_ && asking_ != viewer) return Taken::busy;
  asking_ = viewer;
  asked_s_ = now_s;
  return Taken::asked;
}

std::optional<ViewerId> DrivingRights::answer(ViewerId driver, bool accept) {
  if (driver_ != driver || !asking_) return std::nullopt;
  const std::optional<ViewerId> asked = std::exchange(asking_, std::nullopt);
  if (accept) driver_ = asked;
  return asked;
}

bool DrivingRights::release(ViewerId driver, std::optional<ViewerId> to) {
  if (driver_ != driver) return false;
  driver_ = to ? to : asking_;  // who asked need not ask again
  if (asking_ == driver_) asking_.reset();
  return true;
}

bool DrivingRights::leave(ViewerId viewer) {
  if (asking_ == viewer) asking_.reset();
  if (driver_ != viewer) return false;
  driver_ = std::exchange(asking_, std::nullopt);  // who asked need not ask again
  return true;
}

std::optional<ViewerId> DrivingRights::expired(double now_s) {
  if (!asking_ || now_s < asked_s_ + request_timeout_s) return std::nullopt;
  return std::exchange(asking_, std::nullopt);
}

}  // namespace echoarc::server
