// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/token.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::server {
namespace {

TEST(Token, Holds128BitsAsHexadecimalDigits) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) {
    const std::string token = make_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos) << token;
    EXPECT_TRUE(seen.insert(token).second) << "made twice: " << token;
  }
}

TEST(Token, IsEqualToItselfAlone) {
  const std::string token = make_token();
  EXPECT_TRUE(equal_tokens(token, token));
  for (std::size_t i = 0; i < token.size(); ++i) {
    std::string other = token;
    other[i] = other[i] == 'a' ? 'b' : 'a';
    EXPECT_FALSE(equal_tokens(other, token)) << "digit " << i;
    EXPECT_FALSE(equal_tokens(token.substr(0, i), token)) << "a beginning of " << i;
  }
  EXPECT_FALSE(equal_tokens(token + "0", token));
  EXPECT_FALSE(equal_tokens(token + token, token)) << "repeated";
  EXPECT_FALSE(equal_tokens(token + std::string(1, '\0'), token));
}

TEST(Token, EmptyOneOpensNothing) {
  EXPECT_FALSE(equal_tokens("", ""));
  EXPECT_FALSE(equal_tokens("a", ""));
  EXPECT_FALSE(equal_tokens("", "a"));
  EXPECT_FALSE(equal_tokens(std::string(1, '\0'), ""));
}

}  // namespace
}  // namespace echoarc::server
