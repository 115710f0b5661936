// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/access.hpp"

#include <string_view>

#include <gtest/gtest.h>

#include "server/rate_limit.hpp"

namespace echoarc::server {
namespace {

TEST(Access, HostsThatNameThisServer) {
  const std::vector<std::string> names{"robot.local"};
  for (const std::string_view host : {"127.0.0.1", "127.0.0.1:8765", "192.168.1.7:80", "localhost", "localhost:8765",
                                      "[::1]", "[::1]:8765", "robot.local", "robot.local:8765"})
    EXPECT_TRUE(is_own_host(host, names)) << host;
  for (const std::string_view host : {"", ":8765", "evil.example", "evil.example:8765", "localhost.evil.example",
                                      "127.0.0.1.evil.example", "robot.local.evil.example", "xrobot.local", "[::1"})
    EXPECT_FALSE(is_own_host(host, names)) << host;
  EXPECT_FALSE(is_own_host("robot.local", {}));
}

TEST(Access, PageMayCallTheHostThatServedIt) {
  EXPECT_TRUE(is_own_origin("", "localhost:8765")) << "no browser";
  EXPECT_TRUE(is_own_origin("http://localhost:8765", "localhost:8765"));
  EXPECT_TRUE(is_own_origin("https://robot.local", "robot.local"));
  for (const std::string_view origin : {"null", "http://evil.example", "http://localhost", "http://localhost:8766",
                                        "http://localhost:8765.evil.example", "http://evil.example/localhost:8765",
                                        "localhost:8765", "ftp://localhost:8765", "file://"})
    EXPECT_FALSE(is_own_origin(origin, "localhost:8765")) << origin;
}

TEST(Access, TargetIsPathAndQuery) {
  const Target plain = split_target("/api/state");
  EXPECT_EQ(plain.path, "/api/state");
  EXPECT_EQ(plain.query, "");
  const Target asked = split_target("/ws?room=main?&token=a");
  EXPECT_EQ(asked.path, "/ws");
  EXPECT_EQ(asked.query, "room=main?&token=a");
  EXPECT_EQ(split_target("").path, "");
}

TEST(Access, ParametersAreFoundByTheirWholeName) {
  EXPECT_EQ(parameter("room=main&token=abc", "room"), "main");
  EXPECT_EQ(parameter("room=main&token=abc", "token"), "abc");
  EXPECT_EQ(parameter("classroom=1&room=2", "room"), "2");
  EXPECT_EQ(parameter("room=a=b", "room"), "a=b");
  EXPECT_EQ(parameter("room=&room=2", "room"), "") << "the first counts";
  for (const std::string_view query : {"", "&", "&&&", "room", "=main", "Room=main", "roo=m"})
    EXPECT_EQ(parameter(query, "room"), "") << query;
}

TEST(Access, BearerTokenAlone) {
  EXPECT_EQ(bearer("Bearer abc"), "abc");
  EXPECT_EQ(bearer("Bearer "), "");
  EXPECT_EQ(bearer("bearer abc"), "");
  EXPECT_EQ(bearer("Basic abc"), "");
  EXPECT_EQ(bearer(""), "");
}

TEST(Access, NamesOfFilesAreForShowAlone) {
  EXPECT_EQ(shown_name("hall-2.jsonl"), "hall-2.jsonl");
  EXPECT_EQ(shown_name("B%C3%BCro%202.log"), "B\xC3\xBCro 2.log");
  EXPECT_EQ(shown_name("..%2F..%2Fetc%2Fpasswd"), "passwd");
  EXPECT_EQ(shown_name("C:\\logs\\a.clf"), "a.clf");
  EXPECT_EQ(shown_name("a%00b%0Ac%7F"), "abc");
  EXPECT_EQ(shown_name("100%"), "100%");
  EXPECT_EQ(shown_name("%zz%4"), "%zz%4");
  EXPECT_EQ(shown_name(""), "");
  EXPECT_EQ(shown_name("folder/"), "");
  EXPECT_EQ(shown_name(std::string(200, 'a')), std::string(80, 'a'));
  std::string longest(79, 'a');
  EXPECT_EQ(shown_name(longest + "%C3%BC"), longest) << "no half of a character";
}

TEST(RateLimit, SoManyAtOnceThenSoManyASecond) {
  RateLimit limit(10.0, 3.0);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(limit.take(100.0)) << i;
  EXPECT_FALSE(limit.take(100.0));
  EXPECT_FALSE(limit.take(100.05));
  EXPECT_TRUE(limit.take(100.11));
  EXPECT_FALSE(limit.take(100.12)) << "what was taken is gone";
  int taken = 0;
  for (int i = 0; i < 1000; ++i) taken += limit.take(101.0 + 0.01 * i) ? 1 : 0;
  EXPECT_NEAR(taken, 10 * 10 + 3, 2) << "ten seconds";
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(limit.take(1000.0)) << "a pause saves up the burst alone";
  EXPECT_FALSE(limit.take(1000.0));
}

TEST(RateLimit, ClockThatGoesBackGivesNothing) {
  RateLimit limit(10.0, 1.0);
  EXPECT_TRUE(limit.take(100.0));
  EXPECT_FALSE(limit.take(99.0));
  EXPECT_FALSE(limit.take(99.05));
}

}  // namespace
}  // namespace echoarc::server
