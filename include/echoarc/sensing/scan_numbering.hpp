// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "echoarc/core/log.hpp"

namespace echoarc {

/// Groups pings into scans, one sweep of the array each. A new scan begins when a pair of transmitter and receiver
/// comes again, or, where several sensors fire at one time stamp, with the next stamp.
class ScanNumbering {
 public:
  /// Number of the scan to which `ping` belongs, from 0. Pings come in the order of time.
  [[nodiscard]] std::uint32_t number(const Ping& ping);
  /// Whether `ping` repeats the last ping of its pair: same time, same value.
  [[nodiscard]] bool repeats(const Ping& ping) const;

 private:
  struct Last {
    double time_s;
    double range_m;
    std::uint32_t scan;
  };
  std::map<std::pair<SensorId, SensorId>, Last> last_;
  std::optional<Ping> previous_;
  std::uint32_t scan_ = 0;
  bool simultaneous_ = false;  ///< the present scan has several transmitters at one time stamp
};

}  // namespace echoarc
