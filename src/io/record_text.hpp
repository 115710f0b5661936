// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "echoarc/core/log.hpp"

namespace echoarc::io {

/// Text of JSON records, appended piece by piece.
class RecordText {
 public:
  RecordText& text(std::string_view text) {
    buffer_ += text;
    return *this;
  }
  /// The shortest digits that read back as the same number. It must be finite.
  template <class Number>
  RecordText& number(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    buffer_.append(digits.data(), end);
    return *this;
  }
  /// Remembers whether it was.
  RecordText& finite(double value) {
    all_finite_ = all_finite_ && std::isfinite(value);
    return number(value);
  }
  /// A number, or the word for what is none.
  RecordText& range(double range_m);

  [[nodiscard]] bool all_finite() const { return all_finite_; }
  [[nodiscard]] std::string& buffer() { return buffer_; }

 private:
  std::string buffer_;
  bool all_finite_ = true;
};

// One record each, without line feed.
void write_pose(RecordText& out, std::string_view type, const Odometry& pose);
void write_ping(RecordText& out, const Ping& ping);
void write_scan(RecordText& out, const Scan& scan);
void write_poll(RecordText& out, const Poll& poll);
void write_wall(RecordText& out, const WallNote& note);

}  // namespace echoarc::io
