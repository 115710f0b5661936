// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "echoarc/io/map_server.hpp"

/// A map.yaml, a zero byte, and its picture. What is read must be a map.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.find('\0');
  const std::string_view image = end == std::string_view::npos ? std::string_view{} : bytes.substr(end + 1);
  const auto grid = echoarc::io::parse_map(bytes.substr(0, end), image, "map.yaml");
  if (!grid) return 0;
  const auto pixels = std::int64_t{grid->width()} * grid->height();
  if (pixels < 1 || pixels > echoarc::io::max_map_pixels || !(grid->geometry().cell_m > 0.0)) std::abort();
  return 0;
}
