// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/jsonl_records.hpp"

#include <bitset>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/range_words.hpp"

namespace echoarc::io {

static_assert(LineReader::padding >= simdjson::SIMDJSON_PADDING);

namespace {

using Key = simdjson::ondemand::raw_json_string;

bool is(Key key, std::string_view name) {
  return key.unsafe_is_equal(name);
}

bool is_null(simdjson::ondemand::value& value) {
  bool null = false;
  return value.is_null().get(null) == simdjson::SUCCESS && null;  // "nul" is an error, and no null
}

}  // namespace

bool JsonlRecords::fail(std::string_view cause) {
  fault_ = cause;
  return false;
}

bool JsonlRecords::fail_key(std::string_view key, std::string_view cause) {
  fault_ = fmt::format("{} {}", key, cause);
  return false;
}

template <class Use>
bool JsonlRecords::each_field(Object& record, const Use& use) {
  for (auto result : record) {
    simdjson::ondemand::field field;
    if (const auto error = std::move(result).get(field)) return fail(simdjson::error_message(error));
    if (!use(field.key(), field.value())) return false;
  }
  // Out of bounds is how this parser says that it stands behind the last token.
  const bool at_end = document_.current_location().error() == simdjson::OUT_OF_BOUNDS;
  return at_end || fail("something follows the record");
}

template <class Use>
bool JsonlRecords::each_element(Value& list, const Use& use) {
  simdjson::ondemand::array array;
  if (list.get_array().get(array)) return fail("ranges is not a list");
  for (auto result : array) {
    Value value;
    if (const auto error = std::move(result).get(value)) return fail(simdjson::error_message(error));
    if (!use(value)) return false;
  }
  return true;
}

bool JsonlRecords::number(std::string_view key, Value& value, double& out) {
  // JSON numbers are finite, and one too large for a double is an error of the parser: no NaN gets through here.
  return value.get_double().get(out) == simdjson::SUCCESS || fail_key(key, "is not a finite number");
}

bool JsonlRecords::id(std::string_view key, Value& value, std::uint32_t& out) {
  std::uint64_t wide = 0;
  if (value.get_uint64().get(wide) || wide > std::numeric_limits<std::uint32_t>::max())
    return fail_key(key, "is not a whole number from 0 on");
  out = static_cast<std::uint32_t>(wide);
  return true;
}

bool JsonlRecords::range(std::string_view key, Value& value, double& out) {
  if (value.get_double().get(out) == simdjson::SUCCESS) return true;
  std::string_view word;
  if (value.get_string().get(word) == simdjson::SUCCESS)
    if (const auto rep117 = range_of_word(word)) {
      out = *rep117;
      return true;
    }
  return fail_key(key, R"(is neither a number nor "no_echo", "too_close", "invalid")");
}

bool JsonlRecords::cause(Value& value, EchoCause& out) {
  std::string_view word;
  if (value.get_string().get(word) != simdjson::SUCCESS) return fail("cause is not a string");
  out = echo_cause(word).value_or(EchoCause::unknown);  // a later version may know more
  return true;
}

bool JsonlRecords::read_ping(Object& record, Log& log) {
  enum { t, tx, rx, range_m, count };
  std::bitset<count> seen;
  Ping ping;
  ping.line = line_;
  const bool read = each_field(record, [&](Key key, Value value) {
    if (is(key, "t")) return seen.set(t), number("t", value, ping.time_s);
    if (is(key, "tx")) return seen.set(tx), id("tx", value, ping.tx);
    if (is(key, "rx")) return seen.set(rx), id("rx", value, ping.rx);
    if (is(key, "range")) return seen.set(range_m), range("range", value, ping.range_m);
    if (is(key, "tof")) return number("tof", value, ping.time_of_flight_s);
    if (is(key, "echo")) return id("echo", value, ping.echo_index);
    if (is(key, "cause")) return cause(value, ping.cause);
    return true;
  });
  if (!read) return false;
  if (!seen[t] || !seen[tx] || !seen[range_m])
    return fail_key(!seen[t] ? "t" : !seen[tx] ? "tx" : "range", "of the ping is missing");
  if (!seen[rx]) ping.rx = ping.tx;
  log.pings.push_back(ping);
  return true;
}

bool JsonlRecords::read_pose(Object& record, std::vector<Odometry>& poses) {
  enum { t, x, y, yaw, count };
  std::bitset<count> seen;
  double yaw_rad = 0.0;
  Odometry pose;
  pose.line = line_;
  const bool read = each_field(record, [&](Key key, Value value) {
    if (is(key, "t")) return seen.set(t), number("t", value, pose.time_s);
    if (is(key, "x")) return seen.set(x), number("x", value, pose.T_world_robot.position.x);
    if (is(key, "y")) return seen.set(y), number("y", value, pose.T_world_robot.position.y);
    if (is(key, "yaw")) return seen.set(yaw), number("yaw", value, yaw_rad);
    return true;
  });
  if (!read) return false;
  if (!seen.all()) return fail("t, x, y or yaw of the pose is missing");
  pose.T_world_robot.heading = radians(yaw_rad);
  poses.push_back(pose);
  return true;
}

bool JsonlRecords::read_scan(Object& record, Log& log) {
  enum { t, angle_min, angle_step, ranges, count };
  std::bitset<count> seen;
  double min_rad = 0.0;
  double step_rad = 0.0;
  Scan scan;
  scan.line = line_;
  const auto read_beam = [&](Value value) {
    double range_m = std::numeric_limits<double>::quiet_NaN();
    if (!is_null(value) && !number("a range", value, range_m)) return false;
    if (std::abs(range_m) > std::numeric_limits<float>::max()) return fail("a range of the scan is too large");
    scan.ranges_m.push_back(static_cast<float>(range_m));
    return true;
  };
  const bool read = each_field(record, [&](Key key, Value value) {
    if (is(key, "t")) return seen.set(t), number("t", value, scan.time_s);
    if (is(key, "laser")) return id("laser", value, scan.laser);
    if (is(key, "angle_min")) return seen.set(angle_min), number("angle_min", value, min_rad);
    if (is(key, "angle_step")) return seen.set(angle_step), number("angle_step", value, step_rad);
    if (is(key, "ranges")) return seen.set(ranges), each_element(value, read_beam);
    return true;
  });
  if (!read) return false;
  if (!seen.all()) return fail("t, angle_min, angle_step or ranges of the scan is missing");
  scan.angle_min = radians(min_rad);
  scan.angle_step = radians(step_rad);
  scan.ranges_m.shrink_to_fit();
  log.scans.push_back(std::move(scan));
  return true;
}

bool JsonlRecords::read_poll(Object& record, Log& log) {
  enum { t, ranges, count };
  std::bitset<count> seen;
  Poll poll;
  poll.line = line_;
  const auto read_register = [&](Value value) {
    double range_m = std::numeric_limits<double>::quiet_NaN();
    if (!is_null(value) && !range("a range", value, range_m)) return false;
    poll.ranges_m.push_back(range_m);
    return true;
  };
  const bool read = each_field(record, [&](Key key, Value value) {
    if (is(key, "t")) return seen.set(t), number("t", value, poll.time_s);
    if (is(key, "ranges")) return seen.set(ranges), each_element(value, read_register);
    return true;
  });
  if (!read) return false;
  if (!seen.all()) return fail("t or ranges of the poll is missing");
  poll.ranges_m.shrink_to_fit();
  log.polls.push_back(std::move(poll));
  return true;
}

bool JsonlRecords::read_wall(Object& record, Log& log) {
  enum { t, side, count };
  std::bitset<count> seen;
  WallNote note;
  note.line = line_;
  const auto read_side = [&](Value& value) {
    std::string_view word;
    if (value.get_string().get(word) != simdjson::SUCCESS) word = {};
    if (word != "left" && word != "right" && word != "unknown")
      return fail(R"(side is none of "left", "right", "unknown")");
    note.side = word == "left" ? WallSide::left : word == "right" ? WallSide::right : WallSide::unknown;
    return true;
  };
  const bool read = each_field(record, [&](Key key, Value value) {
    if (is(key, "t")) return seen.set(t), number("t", value, note.time_s);
    if (is(key, "side")) return seen.set(side), read_side(value);
    return true;
  });
  if (!read) return false;
  if (!seen.all()) return fail("t or side of the wall record is missing");
  log.walls.push_back(note);
  return true;
}

bool JsonlRecords::keep_unknown(Object& record, std::string_view type, const Line& line, Log& log) {
  unknown_type_ = type;  // before the rest is parsed, which may move the text `type` points to
  if (!each_field(record, [](Key, Value) { return true; })) return false;
  log.unknown_lines.emplace_back(line.text);
  return true;
}

bool JsonlRecords::read_object(Object& record, const Line& line, Log& log) {
  std::string_view type;
  if (record.find_field_unordered("type").get_string().get(type)) return fail("type is missing or not a string");
  if (record.reset().error()) return fail("not a JSON object");
  if (type == "ping") return read_ping(record, log);
  if (type == "odom") return read_pose(record, log.odometry);
  if (type == "scan") return read_scan(record, log);
  if (type == "truth") return read_pose(record, log.truth);
  if (type == "poll") return read_poll(record, log);
  if (type == "wall") return read_wall(record, log);
  if (type == "header") return fail("a second header");
  return keep_unknown(record, type, line, log);
}

bool JsonlRecords::read(const Line& line, Log& log) {
  line_ = line.number;
  unknown_type_.clear();
  const simdjson::padded_string_view text(line.text.data(), line.text.size(), line.text.size() + LineReader::padding);
  if (const auto error = parser_.iterate(text).get(document_))
    return fail(fmt::format("not JSON: {}", simdjson::error_message(error)));
  Object record;
  if (const auto error = document_.get_object().get(record))
    return fail(fmt::format("not a JSON object: {}", simdjson::error_message(error)));
  return read_object(record, line, log);
}

}  // namespace echoarc::io
