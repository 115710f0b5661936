// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

// Without its exceptions every result of the parser must be looked at: a conversion that could throw does not compile.
#define SIMDJSON_EXCEPTIONS 0
#include <simdjson.h>

#include "echoarc/core/log.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

/// Reads the records of a JSON Lines log, one line at a time, without building a document tree.
class JsonlRecords {
 public:
  /// Appends the record of `line` to `log`. False when the line is none: nothing was appended, and `fault` says why.
  /// `LineReader::padding` bytes behind the text must be readable.
  [[nodiscard]] bool read(const Line& line, Log& log);
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// The type of the last record, if this version does not know it.
  [[nodiscard]] const std::string& unknown_type() const { return unknown_type_; }

 private:
  using Object = simdjson::ondemand::object;
  using Value = simdjson::ondemand::value;

  bool read_object(Object& record, const Line& line, Log& log);
  bool read_ping(Object& record, Log& log);
  bool read_pose(Object& record, std::vector<Odometry>& poses);
  bool read_scan(Object& record, Log& log);
  bool read_poll(Object& record, Log& log);
  bool read_wall(Object& record, Log& log);
  bool keep_unknown(Object& record, std::string_view type, const Line& line, Log& log);

  /// Calls `use(key, value)` for every field of the line's object; stops at the first that returns false or is not
  /// JSON. False, too, when something follows the object.
  template <class Use>
  bool each_field(Object& record, const Use& use);
  /// Calls `use(value)` for every element of a list.
  template <class Use>
  bool each_element(Value& list, const Use& use);
  bool number(std::string_view key, Value& value, double& out);
  bool id(std::string_view key, Value& value, std::uint32_t& out);
  bool range(std::string_view key, Value& value, double& out);
  bool cause(Value& value, EchoCause& out);
  bool fail(std::string_view cause);
  bool fail_key(std::string_view key, std::string_view cause);

  simdjson::ondemand::parser parser_;
  simdjson::ondemand::document document_;
  std::string fault_;
  std::string unknown_type_;
  std::uint64_t line_ = 0;
};

}  // namespace echoarc::io
