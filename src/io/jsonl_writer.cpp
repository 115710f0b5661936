// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/io/jsonl.hpp"
#include "io/jsonl_header.hpp"
#include "io/record_text.hpp"

namespace echoarc::io {
namespace {

/// Builds lines in memory and hands them to the sink in large pieces.
class LineWriter {
 public:
  LineWriter(ByteSink& sink, std::string_view log_name) : sink_(sink), log_name_(log_name) {}

  [[nodiscard]] RecordText& record() { return record_; }
  Result<void> end_line() {
    constexpr std::size_t block = std::size_t{1} << 16U;
    record_.buffer() += '\n';
    return record_.buffer().size() < block ? Result<void>{} : flush();
  }
  Result<void> flush() {
    if (!record_.all_finite())
      return Error{ErrorCode::bad_value, "a time, pose or angle of the log is not finite", std::string(log_name_),
                   "drop the record, JSON has no word for it"};
    Result<void> written = sink_.write(record_.buffer());
    record_.buffer().clear();
    return written;
  }

 private:
  ByteSink& sink_;
  std::string_view log_name_;
  RecordText record_;
};

/// One kind of records, taken from the front.
template <class Record, class Write>
struct Stream {
  const std::vector<Record>& records;
  Write write;
  std::size_t next = 0;

  [[nodiscard]] double time_s() const {
    return next < records.size() ? records[next].time_s : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool done() const { return next == records.size(); }
  void write_next() { write(records[next++]); }
};
template <class Record, class Write>
Stream(const std::vector<Record>&, Write) -> Stream<Record, Write>;

/// Writes the earliest front record of all streams, the first stream winning a tie, until none is left.
template <class... Streams>
Result<void> merge_by_time(LineWriter& out, Streams... streams) {
  while (!(streams.done() && ...)) {
    const double earliest = std::min({streams.done() ? std::numeric_limits<double>::infinity() : streams.time_s()...});
    const auto take = [&](auto& stream) {
      // Written so that a time that is no number is taken, too, and found by the writer.
      if (stream.done() || stream.time_s() > earliest) return false;
      stream.write_next();
      return true;
    };
    (void)(take(streams) || ...);
    if (Result<void> written = out.end_line(); !written) return written;
  }
  return {};
}

}  // namespace

Result<void> write_jsonl(const Log& log, ByteSink& sink) {
  const Result<std::string> header = jsonl_header(log);
  if (!header) return header.error();
  LineWriter out(sink, log.source);
  if (auto written = (out.record().text(*header), out.end_line()); !written) return written;
  const auto write_odometry = [&](const Odometry& pose) { write_pose(out.record(), "odom", pose); };
  const auto write_truth = [&](const Odometry& pose) { write_pose(out.record(), "truth", pose); };
  Result<void> merged = merge_by_time(out, Stream{log.odometry, write_odometry}, Stream{log.truth, write_truth},
                                      Stream{log.walls, [&](const WallNote& note) { write_wall(out.record(), note); }},
                                      Stream{log.pings, [&](const Ping& ping) { write_ping(out.record(), ping); }},
                                      Stream{log.polls, [&](const Poll& poll) { write_poll(out.record(), poll); }},
                                      Stream{log.scans, [&](const Scan& scan) { write_scan(out.record(), scan); }});
  if (!merged) return merged;
  for (const std::string& line : log.unknown_lines)
    if (auto written = (out.record().text(line), out.end_line()); !written) return written;
  return out.flush();
}

}  // namespace echoarc::io
