// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "server/driving_rights.hpp"

namespace echoarc::server {
namespace {

/// Whatever happens in whatever order: nobody drives who did not come to it in one of the four ways.
RC_GTEST_PROP(DrivingRightsLaw, RightPassesByTakingAnsweringReleasingOrLeavingAlone, ()) {
  DrivingRights rights;
  double now_s = 0.0;
  const int steps = *rc::gen::inRange(1, 60);
  for (int step = 0; step < steps; ++step) {
    const auto who = static_cast<ViewerId>(*rc::gen::inRange(1, 5));
    const std::optional<ViewerId> driver = rights.driver();
    const std::optional<ViewerId> asking = rights.asking();
    now_s += *rc::gen::inRange(0, 8);
    switch (*rc::gen::inRange(0, 5)) {
      case 0: {
        const DrivingRights::Taken taken = rights.take(who, now_s);
        const bool may = !driver || driver == who;
        RC_ASSERT((taken == DrivingRights::Taken::yes) == may);
        RC_ASSERT(rights.driver() == (may ? std::optional(who) : driver));
        if (taken == DrivingRights::Taken::asked) RC_ASSERT(rights.asking() == who);
        if (taken == DrivingRights::Taken::busy) RC_ASSERT(rights.asking() == asking && asking != who);
        break;
      }
      case 1: {
        const bool accept = *rc::gen::arbitrary<bool>();
        const bool counts = driver == who && asking;
        RC_ASSERT(rights.answer(who, accept) == (counts ? asking : std::nullopt));
        RC_ASSERT(rights.driver() == (counts && accept ? asking : driver));
        break;
      }
      case 2: {
        const auto to = *rc::gen::arbitrary<bool>() ? std::optional<ViewerId>(*rc::gen::inRange(1, 5)) : std::nullopt;
        RC_ASSERT(rights.release(who, to) == (driver == who));
        RC_ASSERT(rights.driver() == (driver == who ? (to ? to : asking) : driver));
        break;
      }
      case 3: {
        RC_ASSERT(rights.leave(who) == (driver == who));
        RC_ASSERT(rights.driver() != who && rights.asking() != who);
        RC_ASSERT(rights.driver() == (driver == who ? asking : driver));
        break;
      }
      default: {
        const std::optional<ViewerId> expired = rights.expired(now_s);
        RC_ASSERT(!expired || expired == asking);
        RC_ASSERT(rights.driver() == driver);
      }
    }
    RC_ASSERT(!rights.asking() || rights.driver());  // a free right is not asked for
    RC_ASSERT(!rights.asking() || rights.asking() != rights.driver());
  }
}

TEST(DrivingRights, FreeRightGoesToWhoAsksWhenItIsReleased) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_TRUE(rights.release(1, std::nullopt));
  EXPECT_EQ(rights.driver(), 2U);
  EXPECT_FALSE(rights.asking());
}

TEST(DrivingRights, RequestStaysWhenTheRightGoesToAThird) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_TRUE(rights.release(1, 3));
  EXPECT_EQ(rights.driver(), 3U);
  EXPECT_EQ(rights.asking(), 2U);
  EXPECT_EQ(rights.answer(3, true), 2U);
}

}  // namespace
}  // namespace echoarc::server
