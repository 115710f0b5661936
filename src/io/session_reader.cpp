// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <utility>

#include "echoarc/io/line_reader.hpp"
#include "echoarc/io/session_log.hpp"
#include "io/jsonl_header.hpp"
#include "io/jsonl_records.hpp"
#include "io/line_faults.hpp"

namespace echoarc::io {
namespace {

constexpr const char* remedy = "correct or delete the bad lines, or map the log by itself: echoarc map session.jsonl";

/// The one record that `read` appended to an empty log.
SessionLine take_record(Log& log) {
  if (!log.odometry.empty()) return std::exchange(log.odometry, {}).front();
  if (!log.truth.empty()) return TruthLine{std::exchange(log.truth, {}).front()};
  if (!log.pings.empty()) return std::exchange(log.pings, {}).front();
  if (!log.scans.empty()) return std::exchange(log.scans, {}).front();
  if (!log.polls.empty()) return std::exchange(log.polls, {}).front();
  if (!log.walls.empty()) return std::exchange(log.walls, {}).front();
  return OtherLine{std::exchange(log.unknown_lines, {}).front()};
}

Result<Log> read_part(const std::filesystem::path& path, const std::function<void(SessionLine)>& take) {
  Result<std::unique_ptr<ByteSource>> source = FileSource::open(path);
  if (!source) return source.error();
  LineReader lines(**source);
  LineFaults faults(path.string(), remedy);
  Log log;
  log.source = path.string();
  if (!lines.next()) return Error{ErrorCode::bad_format, "the file is empty", path.string(), "delete it"};
  faults.count_line();
  if (const auto read = read_jsonl_header(lines.line().text, faults.place(1), log); !read) return read.error();
  JsonlRecords records;
  Log one;
  while (!faults.hopeless() && lines.next()) {
    const Line& line = lines.line();
    faults.count_line();
    if (line.terminated && records.read(line, one))
      take(take_record(one));
    else
      faults.add(line, line.terminated ? records.fault() : "the line was cut short");
  }
  if (lines.failure()) return *lines.failure();
  Result<ReadReport> report = faults.finish();
  if (!report) return report.error();
  log.report = std::move(*report);
  return log;
}

}  // namespace

Result<Log> read_session(const std::filesystem::path& folder, const std::function<void(SessionLine)>& take) {
  const std::vector<std::filesystem::path> parts = session_parts(folder);
  if (parts.empty())
    return Error{ErrorCode::not_found, "there is no session.jsonl", folder.string(),
                 "name the folder that `echoarc serve -o` was given"};
  Result<Log> session = read_part(parts.front(), take);
  for (std::size_t i = 1; session && i < parts.size(); ++i) {
    const Result<Log> part = read_part(parts[i], take);
    if (!part) return part.error();
    if (!(part->robot == session->robot))
      return Error{ErrorCode::bad_format, "its robot is not that of the first part", parts[i].string(),
                   "put the parts of different sessions into different folders"};
    session->report.bad_lines += part->report.bad_lines;
    session->report.lines += part->report.lines;
  }
  return session;
}

}  // namespace echoarc::io
