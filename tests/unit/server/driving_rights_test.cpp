// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/driving_rights.hpp"

#include <gtest/gtest.h>

namespace echoarc::server {
namespace {

using Taken = DrivingRights::Taken;

TEST(DrivingRights, FreeRightIsTakenAtOnce) {
  DrivingRights rights;
  EXPECT_FALSE(rights.driver());
  EXPECT_EQ(rights.take(1, 0.0), Taken::yes);
  EXPECT_EQ(rights.driver(), 1U);
  EXPECT_EQ(rights.take(1, 1.0), Taken::yes) << "the driver's own wish changes nothing";
}

TEST(DrivingRights, SecondAsksAndThirdHasToWait) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  EXPECT_EQ(rights.take(2, 0.0), Taken::asked);
  EXPECT_EQ(rights.take(3, 0.0), Taken::busy);
  EXPECT_EQ(rights.driver(), 1U);
  EXPECT_EQ(rights.asking(), 2U);
}

TEST(DrivingRights, DriverAloneAnswers) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_FALSE(rights.answer(2, true)) << "who asks cannot answer";
  EXPECT_FALSE(rights.answer(3, true));
  EXPECT_EQ(rights.driver(), 1U);
  EXPECT_EQ(rights.answer(1, true), 2U);
  EXPECT_EQ(rights.driver(), 2U);
  EXPECT_FALSE(rights.asking());
}

TEST(DrivingRights, RefusalLeavesTheDriver) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_EQ(rights.answer(1, false), 2U);
  EXPECT_EQ(rights.driver(), 1U);
  EXPECT_FALSE(rights.answer(1, true)) << "nobody asks any more";
  EXPECT_EQ(rights.take(2, 1.0), Taken::asked) << "it may be asked again";
}

TEST(DrivingRights, DriverAloneHandsOver) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  EXPECT_FALSE(rights.release(2, 2));
  EXPECT_EQ(rights.driver(), 1U);
  EXPECT_TRUE(rights.release(1, 2));
  EXPECT_EQ(rights.driver(), 2U);
  EXPECT_TRUE(rights.release(2, std::nullopt));
  EXPECT_FALSE(rights.driver());
}

TEST(DrivingRights, WhoGetsWhatHeAskedForAsksNoMore) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_TRUE(rights.release(1, 2));
  EXPECT_FALSE(rights.asking());
  EXPECT_FALSE(rights.expired(1e6));
}

TEST(DrivingRights, RightGoesToWhoAsksWhenTheDriverIsGone) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_TRUE(rights.leave(1));
  EXPECT_EQ(rights.driver(), 2U);
  EXPECT_TRUE(rights.leave(2));
  EXPECT_FALSE(rights.driver());
  EXPECT_FALSE(rights.leave(2));
}

TEST(DrivingRights, WhoAsksAndLeavesIsForgotten) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 0.0);
  EXPECT_FALSE(rights.leave(2));
  EXPECT_FALSE(rights.asking());
  EXPECT_TRUE(rights.leave(1));
  EXPECT_FALSE(rights.driver());
}

TEST(DrivingRights, UnansweredRequestExpiresOnce) {
  DrivingRights rights;
  (void)rights.take(1, 0.0);
  (void)rights.take(2, 100.0);
  EXPECT_FALSE(rights.expired(100.0 + DrivingRights::request_timeout_s - 0.01));
  EXPECT_EQ(rights.expired(100.0 + DrivingRights::request_timeout_s), 2U);
  EXPECT_FALSE(rights.expired(1e6));
  EXPECT_EQ(rights.driver(), 1U) << "no answer is a no";
}

}  // namespace
}  // namespace echoarc::server
