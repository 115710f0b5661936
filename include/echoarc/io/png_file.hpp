// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Red, green, blue, row by row from the top, as the bytes of a PNG file.
[[nodiscard]] Result<std::string> encode_png(std::int32_t width, std::int32_t height,
                                             std::span<const std::uint8_t> rgb);

}  // namespace echoarc::io
