// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Grey values 0 (black) to 255, row by row from the top.
struct GrayImage {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint8_t> gray;
  std::vector<std::uint8_t> alpha;  ///< 255 opaque; empty where the format has none
};

/// PGM, binary (P5) or plain (P2), up to 255 grey levels, which are stretched to 0..255. `source` names the file.
[[nodiscard]] Result<GrayImage> decode_pgm(std::string_view bytes, std::string_view source);

/// Any PNG, converted to 8-bit grey.
[[nodiscard]] Result<GrayImage> decode_png(std::string_view bytes, std::string_view source);

/// By the first bytes one or the other. At most `max_map_pixels` pixels; memory is taken only for what the bytes can
/// hold.
[[nodiscard]] Result<GrayImage> decode_gray_image(std::string_view bytes, std::string_view source);

/// Whether width x height is legal for a map; the error says what would be.
[[nodiscard]] Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::string_view source);

}  // namespace echoarc::io
