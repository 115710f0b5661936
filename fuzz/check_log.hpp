// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdlib>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/jsonl.hpp"

namespace echoarc::io {

/// What holds for every log reader: an error says what, where and what to do; a log can be written, and reads back with
/// every record. Ends the program otherwise, which the fuzzer reports.
inline void check_log(const Result<Log>& log) {
  if (!log) {
    const Error& error = log.error();
    if (error.message.empty() || error.where.empty() || error.remedy.empty()) std::abort();
    return;
  }
  StringSink sink;
  if (!write_jsonl(*log, sink)) std::abort();
  MemorySource written(sink.text(), "written");
  const Result<Log> back = read_jsonl(written);
  if (!back || back->report.bad_lines != 0) std::abort();
  const bool same = back->pings.size() == log->pings.size() && back->odometry.size() == log->odometry.size() &&
                    back->scans.size() == log->scans.size() && back->unknown_lines == log->unknown_lines &&
                    back->robot == log->robot;
  if (!same) std::abort();
}

}  // namespace echoarc::io
