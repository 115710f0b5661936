// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "echoarc/io/carmen.hpp"
#include "io/carmen_messages.hpp"
#include "io/line_faults.hpp"
#include "io/text_cells.hpp"

namespace echoarc::io {
namespace {

constexpr const char* line_remedy =
    "correct or delete the bad lines; a CARMEN log has one message a line, its name first";

}  // namespace

Result<Log> read_carmen(ByteSource& source, const ReadLimits& limits) {
  Log log;
  log.source = source.name();
  log.robot.name = "CARMEN robot";
  LineReader lines(source, limits);
  LineFaults faults(source.name(), line_remedy);
  CarmenMessages messages;
  bool empty = true;
  while (!faults.hopeless() && lines.next()) {
    const Line& line = lines.line();
    const std::string_view text = trimmed(line.text);
    if (!line.too_long && (text.empty() || text.starts_with('#'))) continue;
    empty = false;
    faults.count_line();
    if (line.too_long)
      faults.add(line, "the line is too long");
    else if (!messages.read(line, log))
      faults.add(line, messages.fault());
  }
  if (lines.failure()) return *lines.failure();
  if (empty)
    return Error{ErrorCode::bad_format, "the file holds no message", source.name(),
                 "check that the recording was written"};
  messages.finish(log);
  if (!messages.skipped().empty())
    faults.warn(fmt::format("{}: messages passed over: {}", source.name(), fmt::join(messages.skipped(), ", ")));
  Result<ReadReport> report = faults.finish();
  if (!report) return report.error();
  log.report = std::move(*report);
  return log;
}

}  // namespace echoarc::io
