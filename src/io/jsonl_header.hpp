// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Reads the header line into frame, temperature and robot of `log`. `place` is its "file:line". Unknown keys are
/// ignored.
[[nodiscard]] Result<void> read_jsonl_header(std::string_view line, const std::string& place, Log& log);

/// The header line of a log, without line feed. Error: bad_value for a number that is not finite.
[[nodiscard]] Result<std::string> jsonl_header(const Log& log);

}  // namespace echoarc::io
