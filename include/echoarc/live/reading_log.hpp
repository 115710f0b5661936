// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/sensing/rejection.hpp"

namespace echoarc::live {

/// What became of one ping: its reading, or the reason why there is none.
struct JudgedPing {
  Reading reading;  ///< of a rejected ping: what is known of it, its pose by the newest odometry
  std::optional<Rejection> rejected;
  double raw_range_m = 0.0;  ///< what the hardware said
};

/// All pings of a session in the order in which they were judged, in chunks that never change once they are full. A
/// copy is cheap and stays as it was, so that questions are answered beside the mapping.
class ReadingLog {
 public:
  static constexpr std::size_t chunk_size = 1024;

  void append(const JudgedPing& ping);
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] const JudgedPing& operator[](std::size_t index) const;
  /// The place of a ping in this log; pings are judged nearly in order of their ids.
  [[nodiscard]] std::optional<std::size_t> find(PingId ping) const;
  void clear();

 private:
  std::vector<std::shared_ptr<std::vector<JudgedPing>>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace echoarc::live
