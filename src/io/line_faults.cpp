// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/line_faults.hpp"

#include <utility>

#include <fmt/format.h>

namespace echoarc::io {

void LineFaults::add(const Line& line, std::string cause) {
  if (!line.terminated && !line.too_long) {
    warn(fmt::format("{}: the last line is cut off and was skipped ({})", place(line.number), cause));
    return;
  }
  ++report_.bad_lines;
  if (report_.first_bad.size() < kept_messages) report_.first_bad.push_back({line.number, std::move(cause)});
}

void LineFaults::warn(std::string warning) {
  // A line of its own for every oddity of a hostile file would be another way to fill the memory.
  if (report_.warnings.size() < kept_messages) report_.warnings.push_back(std::move(warning));
}

Result<ReadReport> LineFaults::finish() const {
  if (!hopeless() && report_.bad_lines * 100 <= report_.lines * max_bad_percent) return report_;
  const BadLine& first = report_.first_bad.front();
  return Error{
      ErrorCode::bad_format,
      fmt::format("{} of {} lines are bad, more than {}; the first: {}", report_.bad_lines, report_.lines,
                  hopeless() ? fmt::format("{}", max_bad_lines) : fmt::format("{} %", max_bad_percent), first.message),
      place(first.line), remedy_};
}

std::string LineFaults::place(std::uint64_t line) const {
  return fmt::format("{}:{}", source_, line);
}

}  // namespace echoarc::io
