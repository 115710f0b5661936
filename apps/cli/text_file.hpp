// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string_view>

#include "echoarc/core/result.hpp"

namespace echoarc::cli {

/// A file that holds the text, or, after an error, none. Errors: those of `io::FileSink`.
[[nodiscard]] Result<void> write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace echoarc::cli
