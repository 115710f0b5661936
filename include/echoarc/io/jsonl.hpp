// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

/// Major version of the JSON Lines log that this library reads and writes.
inline constexpr int jsonl_version = 1;

/// Reads a JSON Lines log: a header, then one record a line (docs/formats.md). Units: metres, radians, seconds.
///
/// A range in words becomes its REP 117 double: "no_echo" +Inf, "too_close" -Inf, "invalid" NaN. Records keep the order
/// of the file, unknown sensor ids included; `sensing` judges them. Records of unknown type go to
/// `Log::unknown_lines`. A line that is not a record is counted in `Log::report` and skipped; a broken last line
/// without line feed is only a warning. Errors: no or a bad header, a newer major version, more than 1 % or 100 bad
/// lines; they name the line and a remedy. With `copy`, every good line is
/// also written there as it stands, with keys and types that this version does not know.
[[nodiscard]] Result<Log> read_jsonl(ByteSource& source, const ReadLimits& limits = {}, ByteSink* copy = nullptr);

/// Writes what `read_jsonl` reads back equal (line numbers and report aside). Records are merged by time, each kind in
/// its order; numbers are the shortest that read back the same. Error: bad_value for a pose, time, scan angle or header
/// number that is not finite, which JSON cannot say.
[[nodiscard]] Result<void> write_jsonl(const Log& log, ByteSink& sink);

}  // namespace echoarc::io
