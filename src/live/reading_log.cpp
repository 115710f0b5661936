// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/reading_log.hpp"

namespace echoarc::live {

std::optional<std::size_t> ReadingLog::find(PingId ping) const {
  const auto is = [&](std::size_t k) { return (*this)[k].reading.ping == ping; };
  if (ping < size() && is(ping)) return std::size_t(ping);
  for (std::size_t k = size(); k-- > 0;)
    if (is(k)) return k;
  return std::nullopt;
}

}  // namespace echoarc::live
