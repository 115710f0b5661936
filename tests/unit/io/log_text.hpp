// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "echoarc/core/log.hpp"
#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/jsonl.hpp"

namespace echoarc::io {

inline constexpr std::string_view one_sensor_header =
    R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":[{"id":0,"x":0.2,"yaw":0}]}})"
    "\n";
inline constexpr std::string_view good_ping = R"({"type":"ping","t":1,"tx":0,"rx":0,"range":1.5})"
                                              "\n";

inline Result<Log> read_text(std::string_view text, const ReadLimits& limits = {}) {
  MemorySource source(text, "log.jsonl");
  return read_jsonl(source, limits);
}

/// `line` among 199 good pings, so that one bad line is within what a reader forgives. It is line 2 of the file.
inline Result<Log> read_among_good(std::string_view line) {
  std::string text = std::string(one_sensor_header) + std::string(line) + "\n";
  for (int i = 0; i < 199; ++i) text += good_ping;
  return read_text(text);
}

/// A source that hands out `block` bytes at a time.
class TricklingSource final : public ByteSource {
 public:
  TricklingSource(std::string_view bytes, std::size_t block) : bytes_(bytes), block_(block) {}
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Result<std::size_t> read(std::span<char> buffer) override {
    const std::size_t count = std::min({block_, buffer.size(), bytes_.size()});
    std::copy_n(bytes_.begin(), count, buffer.begin());
    bytes_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view bytes_;
  std::size_t block_;
  std::string name_ = "trickle";
};

}  // namespace echoarc::io
