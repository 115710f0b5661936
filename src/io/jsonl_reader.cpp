// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <string>

#include <fmt/format.h>

#include "echoarc/io/jsonl.hpp"
#include "io/jsonl_header.hpp"
#include "io/jsonl_records.hpp"
#include "io/line_faults.hpp"

namespace echoarc::io {
namespace {

constexpr const char* line_remedy =
    R"(correct or delete the bad lines; a ping is {"type":"ping","t":0.04,"tx":0,"rx":0,"range":1.234})";
constexpr const char* empty_remedy = "check that the recording was written; a log starts with a header line";

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t") == std::string_view::npos;
}

/// Warns once for each type of record that this version does not know.
class UnknownTypes {
 public:
  void note(const std::string& type, const Line& line, LineFaults& faults) {
    constexpr std::size_t max_types = 10;
    if (type.empty() || types_.size() >= max_types || !types_.insert(type).second) return;
    faults.warn(fmt::format("{}: records of type \"{:.40}\" are not known and are passed over",
                            faults.place(line.number), type));
  }

 private:
  std::set<std::string, std::less<>> types_;
};

/// The first line that is not blank.
Result<Line> first_line(LineReader& lines, const ByteSource& source) {
  while (lines.next())
    if (!is_blank(lines.line().text) || lines.line().too_long) return lines.line();
  if (lines.failure()) return *lines.failure();
  return Error{ErrorCode::bad_format, "the file is empty", source.name(), empty_remedy};
}

/// Copies good lines; after the first failure only that is remembered.
class LineCopy {
 public:
  explicit LineCopy(ByteSink* sink) : sink_(sink) {}
  void add(std::string_view line) {
    if (sink_ == nullptr || !state_) return;
    state_ = sink_->write(line);
    if (state_) state_ = sink_->write("\n");
  }
  [[nodiscard]] const Result<void>& state() const { return state_; }

 private:
  ByteSink* sink_;
  Result<void> state_;
};

void read_body(LineReader& lines, LineFaults& faults, Log& log, LineCopy& copy) {
  JsonlRecords records;
  UnknownTypes unknown;
  while (!faults.hopeless() && lines.next()) {
    const Line& line = lines.line();
    if (!line.too_long && is_blank(line.text)) continue;
    faults.count_line();
    if (line.too_long)
      faults.add(line, "the line is too long");
    else if (!records.read(line, log))
      faults.add(line, records.fault());
    else {
      copy.add(line.text);
      if (!records.unknown_type().empty()) unknown.note(records.unknown_type(), line, faults);
    }
  }
}

}  // namespace

Result<Log> read_jsonl(ByteSource& source, const ReadLimits& limits, ByteSink* copy) {
  Log log;
  log.source = source.name();
  LineReader lines(source, limits);
  LineFaults faults(source.name(), line_remedy);
  const Result<Line> header = first_line(lines, source);
  if (!header) return header.error();
  faults.count_line();
  if (const auto read = read_jsonl_header(header->text, faults.place(header->number), log); !read) return read.error();
  LineCopy line_copy(copy);
  line_copy.add(header->text);
  read_body(lines, faults, log, line_copy);
  if (!line_copy.state()) return line_copy.state().error();
  if (lines.failure()) return *lines.failure();
  Result<ReadReport> report = faults.finish();
  if (!report) return report.error();
  log.report = std::move(*report);
  return log;
}

}  // namespace echoarc::io
