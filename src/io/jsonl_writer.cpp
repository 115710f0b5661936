// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/io/jsonl.hpp"
#include "io/jsonl_header.hpp"
#include "io/range_words.hpp"

namespace echoarc::io {
namespace {

/// Builds lines in memory and hands them to the sink in large pieces.
class LineWriter {
 public:
  LineWriter(ByteSink& sink, std::string_view log_name) : sink_(sink), log_name_(log_name) {}

  LineWriter& text(std::string_view text) {
    buffer_ += text;
    return *this;
  }
  /// The shortest digits that read back as the same number. It must be finite.
  template <class Number>
  LineWriter& number(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    buffer_.append(digits.data(), end);
    return *this;
  }
  LineWriter& finite(double value) {
    all_finite_ = all_finite_ && std::isfinite(value);
    return number(value);
  }
  LineWriter& range(double range_m) {
    if (std::isfinite(range_m)) return number(range_m);
    return text("\"").text(word_of_range(range_m)).text("\"");
  }
  Result<void> end_line() {
    constexpr std::size_t block = std::size_t{1} << 16U;
    buffer_ += '\n';
    return buffer_.size() < block ? Result<void>{} : flush();
  }
  Result<void> flush() {
    if (!all_finite_)
      return Error{ErrorCode::bad_value, "a time, pose or angle of the log is not finite", std::string(log_name_),
                   "drop the record, JSON has no word for it"};
    Result<void> written = sink_.write(buffer_);
    buffer_.clear();
    return written;
  }

 private:
  ByteSink& sink_;
  std::string_view log_name_;
  std::string buffer_;
  bool all_finite_ = true;
};

void write_pose(LineWriter& out, std::string_view type, const Odometry& pose) {
  out.text(R"({"type":")").text(type).text(R"(","t":)").finite(pose.time_s);
  out.text(R"(,"x":)").finite(pose.T_world_robot.position.x);
  out.text(R"(,"y":)").finite(pose.T_world_robot.position.y);
  out.text(R"(,"yaw":)").finite(pose.T_world_robot.heading.rad()).text("}");
}

void write_ping(LineWriter& out, const Ping& ping) {
  out.text(R"({"type":"ping","t":)").finite(ping.time_s);
  out.text(R"(,"tx":)").number(ping.tx).text(R"(,"rx":)").number(ping.rx);
  out.text(R"(,"range":)").range(ping.range_m);
  if (!std::isnan(ping.time_of_flight_s)) out.text(R"(,"tof":)").finite(ping.time_of_flight_s);
  if (ping.echo_index != 0) out.text(R"(,"echo":)").number(ping.echo_index);
  if (ping.cause != EchoCause::unknown) out.text(R"(,"cause":")").text(name(ping.cause)).text("\"");
  out.text("}");
}

template <class Ranges, class Write>
void write_ranges(LineWriter& out, const Ranges& ranges_m, const Write& write) {
  out.text(R"(,"ranges":[)");
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    if (i > 0) out.text(",");
    write(ranges_m[i]);
  }
  out.text("]}");
}

void write_scan(LineWriter& out, const Scan& scan) {
  out.text(R"({"type":"scan","t":)").finite(scan.time_s).text(R"(,"laser":)").number(scan.laser);
  out.text(R"(,"angle_min":)").finite(scan.angle_min.rad());
  out.text(R"(,"angle_step":)").finite(scan.angle_step.rad());
  write_ranges(out, scan.ranges_m,
               [&](float range_m) { std::isfinite(range_m) ? out.number(range_m) : out.text("null"); });
}

void write_poll(LineWriter& out, const Poll& poll) {
  out.text(R"({"type":"poll","t":)").finite(poll.time_s);
  write_ranges(out, poll.ranges_m, [&](double range_m) { out.range(range_m); });
}

void write_wall(LineWriter& out, const WallNote& note) {
  constexpr std::array<std::string_view, 3> sides = {"unknown", "left", "right"};
  out.text(R"({"type":"wall","t":)").finite(note.time_s);
  out.text(R"(,"side":")").text(sides.at(static_cast<std::size_t>(note.side))).text("\"}");
}

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
  if (auto written = out.text(*header).end_line(); !written) return written;
  const auto write_odometry = [&](const Odometry& pose) { write_pose(out, "odom", pose); };
  const auto write_truth = [&](const Odometry& pose) { write_pose(out, "truth", pose); };
  Result<void> merged = merge_by_time(out, Stream{log.odometry, write_odometry}, Stream{log.truth, write_truth},
                                      Stream{log.walls, [&](const WallNote& note) { write_wall(out, note); }},
                                      Stream{log.pings, [&](const Ping& ping) { write_ping(out, ping); }},
                                      Stream{log.polls, [&](const Poll& poll) { write_poll(out, poll); }},
                                      Stream{log.scans, [&](const Scan& scan) { write_scan(out, scan); }});
  if (!merged) return merged;
  for (const std::string& line : log.unknown_lines)
    if (auto written = out.text(line).end_line(); !written) return written;
  return out.flush();
}

}  // namespace echoarc::io
