// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Descriptions are written by people; larger ones are somebody's log under the wrong name.
inline constexpr std::size_t max_description_bytes = std::size_t{1} << 20;

/// The whole file. Errors: absent, a folder, unreadable, larger than `max_bytes`.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Writes the pieces, one after the other, as the whole file, replacing it. After an error there is no file, or the old
/// one.
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path,
                                      std::initializer_list<std::string_view> pieces);
[[nodiscard]] inline Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  return write_file(path, {bytes});
}

/// The error of a name that cannot be written to, with the system's reason.
[[nodiscard]] Error unwritable(const std::filesystem::path& path, std::string_view reason);

}  // namespace echoarc::io
