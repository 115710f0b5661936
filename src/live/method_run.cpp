// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/method_run.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace echoarc::live {

std::size_t MethodRun::advance(const ReadingLog& log, std::span<const std::size_t> marks, std::size_t limit,
                               Executor& executor) {
  const std::size_t begin = position_;
  while (next_mark_ < marks.size() && position_ - begin < limit) {
    const std::size_t mark = marks[next_mark_];
    take(log, std::min(mark, begin + limit), executor);
    if (position_ < mark) break;
    ++next_mark_;
    // Without new readings a finish would change nothing, or do a whole batch's work (consensus).
    if (!std::exchange(fresh_, false)) continue;
    method_.finish(executor);
    ++finishes_;
  }
  return position_ - begin;
}

void MethodRun::take_rest(const ReadingLog& log, Executor& executor) {
  take(log, log.size(), executor);
}

void MethodRun::take(const ReadingLog& log, std::size_t end, Executor& executor) {
  std::vector<Reading> readings;
  for (; position_ < end; ++position_) {
    const JudgedPing& judged = log[position_];
    if (judged.rejected || off_.contains(judged.reading.rx) || off_.contains(judged.reading.tx)) continue;
    readings.push_back(judged.reading);
  }
  if (readings.empty()) return;
  method_.insert(readings, executor);
  fresh_ = true;
}

MethodRun MethodRun::with(AnyMethod copy) const {
  MethodRun run(std::move(copy), off_);
  run.position_ = position_;
  run.next_mark_ = next_mark_;
  run.fresh_ = fresh_;
  run.finishes_ = finishes_;
  return run;
}

}  // namespace echoarc::live
