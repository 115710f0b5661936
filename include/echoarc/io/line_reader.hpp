// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_source.hpp"

namespace echoarc::io {

/// How much a reader takes before it gives up. A log in memory is at most about four times its text.
struct ReadLimits {
  std::size_t line_bytes = std::size_t{16} << 20U;      ///< a longer line is a bad line
  std::uint64_t input_bytes = std::uint64_t{8} << 30U;  ///< a longer input is an error
};

/// One line without its line feed (nor carriage return).
struct Line {
  std::string_view text;     ///< valid until the next call of `next`; empty when the line is too long
  std::uint64_t number = 0;  ///< counted from 1
  bool terminated = true;    ///< false: the input ends without a line feed, perhaps within a record
  bool too_long = false;     ///< longer than the limit; skipped, not kept
};

/// Cuts a source into lines, with memory for one line (and 256 KiB) alone.
class LineReader {
 public:
  /// So many bytes behind a line may be read (not used), which vectorised parsers need.
  static constexpr std::size_t padding = 64;

  /// `source` must outlive the reader.
  explicit LineReader(ByteSource& source, ReadLimits limits = {});

  /// Advances; false at the end of the input or after an error, see `failure`. A byte order mark before the first line
  /// is dropped.
  [[nodiscard]] bool next();
  [[nodiscard]] const Line& line() const { return line_; }
  /// Why the input ended early: the source failed, or holds more than `ReadLimits::input_bytes`.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 private:
  [[nodiscard]] bool fill();
  void skip_long_line();
  void set_line(std::size_t length, bool terminated);

  ByteSource& source_;
  ReadLimits limits_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< first byte not handed out yet
  std::size_t end_ = 0;    ///< behind the last byte read
  std::uint64_t total_ = 0;
  bool at_end_ = false;
  Line line_;
  std::optional<Error> failure_;
};

}  // namespace echoarc::io
