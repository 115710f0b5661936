// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <span>

#include "echoarc/core/executor.hpp"
#include "echoarc/live/reading_log.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::live {

/// One method on its way along a reading log. It brings its map up to date at the marks of the log and nowhere else, so
/// a method that is computed anew ends in the state of one that was there from the start.
class MethodRun {
 public:
  MethodRun(AnyMethod method, std::set<SensorId> off) : method_(std::move(method)), off_(std::move(off)) {}

  /// Takes readings up to the last mark, of which about `limit` at a time. `marks`: sizes of the log at which to
  /// finish, growing. Returns how many places of the log it went on.
  std::size_t advance(const ReadingLog& log, std::span<const std::size_t> marks, std::size_t limit, Executor& executor);
  /// As `advance`, and then everything after the last mark, without finishing.
  void take_rest(const ReadingLog& log, Executor& executor);

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] bool at_end(std::span<const std::size_t> marks) const { return next_mark_ == marks.size(); }
  [[nodiscard]] AnyMethod& method() { return method_; }
  [[nodiscard]] const AnyMethod& method() const { return method_; }
  [[nodiscard]] const std::set<SensorId>& off() const { return off_; }
  /// Finishes that changed something.
  [[nodiscard]] std::size_t finishes() const { return finishes_; }
  /// Carries the counts over to a copy of the method.
  [[nodiscard]] MethodRun with(AnyMethod copy) const;

 private:
  void take(const ReadingLog& log, std::size_t end, Executor& executor);

  AnyMethod method_;
  std::set<SensorId> off_;
  std::size_t position_ = 0;
  std::size_t next_mark_ = 0;
  bool fresh_ = false;  ///< readings came since the last finish
  std::size_t finishes_ = 0;
};

}  // namespace echoarc::live
