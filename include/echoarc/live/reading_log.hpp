// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>

#include "echoarc/core/reading.hpp"
#include "echoarc/live/chunked_log.hpp"
#include "echoarc/sensing/rejection.hpp"

namespace echoarc::live {

/// What became of one ping: its reading, or the reason why there is none.
struct JudgedPing {
  Reading reading;  ///< of a rejected ping: what is known of it, its pose by the newest odometry
  std::optional<Rejection> rejected;
  double raw_range_m = 0.0;  ///< what the hardware said
};

/// All pings of a session in the order in which they were judged. A copy is cheap and stays as it was, so that
/// questions are answered beside the mapping.
class ReadingLog : public ChunkedLog<JudgedPing> {
 public:
  /// The place of a ping in this log; pings are judged nearly in order of their ids.
  [[nodiscard]] std::optional<std::size_t> find(PingId ping) const;
};

}  // namespace echoarc::live
