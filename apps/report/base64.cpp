// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/base64.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace echoarc::report {

std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t block = 0;
    for (std::size_t i = 0; i < 3; ++i)
      block = block << 8 | (i < count ? std::uint32_t(static_cast<unsigned char>(bytes[k + i])) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? alphabet[block >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

}  // namespace echoarc::report
