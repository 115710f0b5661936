// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/line_reader.hpp"

#include <algorithm>
#include <cstring>
#include <span>

#include <fmt/format.h>

namespace echoarc::io {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18U;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

LineReader::LineReader(ByteSource& source, ReadLimits limits)
    : source_(source), limits_(limits), buffer_(block_bytes + padding) {}

bool LineReader::next() {
  std::size_t searched = begin_;  // no line feed in [begin_, searched)
  while (true) {
    const void* found = std::memchr(buffer_.data() + searched, '\n', end_ - searched);
    if (found != nullptr) {
      set_line(static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()) - begin_, true);
      return true;
    }
    const std::size_t length = end_ - begin_;
    if (length > limits_.line_bytes) {
      skip_long_line();
      return !failure_;
    }
    if (!fill()) {
      if (failure_ || length == 0) return false;
      set_line(length, false);
      return true;
    }
    searched = begin_ + length;
  }
}

/// Reads the next block behind the bytes that are waiting; false at the end or after an error.
bool LineReader::fill() {
  if (at_end_ || failure_) return false;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < end_ + block_bytes / 2 + padding) buffer_.resize(2 * buffer_.size());
  const Result<std::size_t> count = source_.read(std::span(buffer_).subspan(end_, buffer_.size() - padding - end_));
  if (!count) {
    failure_ = count.error();
    return false;
  }
  at_end_ = *count == 0;
  end_ += *count;
  total_ += *count;
  if (total_ > limits_.input_bytes)
    failure_ = Error{ErrorCode::too_large, fmt::format("longer than {} bytes", limits_.input_bytes),
                     fmt::format("{}:{}", source_.name(), line_.number + 1), "cut the log into parts"};
  return !at_end_ && !failure_;
}

/// Drops bytes up to and including the next line feed, block by block.
void LineReader::skip_long_line() {
  line_ = {.text = {}, .number = line_.number + 1, .terminated = false, .too_long = true};
  begin_ = end_;
  while (fill()) {
    const void* found = std::memchr(buffer_.data() + begin_, '\n', end_ - begin_);
    if (found != nullptr) {
      begin_ = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()) + 1;
      line_.terminated = true;
      return;
    }
    begin_ = end_;
  }
}

void LineReader::set_line(std::size_t length, bool terminated) {
  std::string_view text(buffer_.data() + begin_, length);
  begin_ = std::min(begin_ + length + 1, end_);
  if (text.ends_with('\r')) text.remove_suffix(1);
  if (line_.number == 0 && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const bool too_long = text.size() > limits_.line_bytes;
  line_ = {.text = too_long ? std::string_view{} : text,
           .number = line_.number + 1,
           .terminated = terminated,
           .too_long = too_long};
}

}  // namespace echoarc::io
