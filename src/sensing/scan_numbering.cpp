// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/scan_numbering.hpp"

namespace echoarc {

bool ScanNumbering::repeats(const Ping& ping) const {
  const auto found = last_.find({ping.tx, ping.rx});
  if (found == last_.end() || found->second.time_s != ping.time_s) return false;
  const bool both_nan = ping.range_m != ping.range_m && found->second.range_m != found->second.range_m;
  return both_nan || found->second.range_m == ping.range_m;
}

std::uint32_t ScanNumbering::number(const Ping& ping) {
  const auto found = last_.find({ping.tx, ping.rx});
  const bool again = found != last_.end() && found->second.scan == scan_;
  const bool new_stamp = previous_ && previous_->time_s != ping.time_s;
  if (again || (simultaneous_ && new_stamp)) {
    ++scan_;
    simultaneous_ = false;
  } else if (previous_ && !new_stamp && previous_->tx != ping.tx) {
    simultaneous_ = true;
  }
  last_[{ping.tx, ping.rx}] = {ping.time_s, ping.range_m, scan_};
  previous_ = ping;
  return scan_;
}

}  // namespace echoarc
