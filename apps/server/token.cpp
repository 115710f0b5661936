// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/token.hpp"

#include <cstddef>
#include <random>

namespace echoarc::server {

std::string make_token() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::random_device system;  // reads the kernel's generator
  std::string token;
  while (token.size() < 32) {
    const unsigned bits = system();
    for (unsigned shift = 0; shift < 32 && token.size() < 32; shift += 4) token += digits[(bits >> shift) & 15U];
  }
  return token;
}

bool equal_tokens(std::string_view given, std::string_view wanted) {
  unsigned difference = given.size() == wanted.size() && !wanted.empty() ? 0U : 1U;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const char other = wanted.empty() ? '\0' : wanted[i % wanted.size()];
    difference |= static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(other);
  }
  return difference == 0;
}

}  // namespace echoarc::server
