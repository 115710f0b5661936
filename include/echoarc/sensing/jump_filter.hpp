// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <utility>

#include "echoarc/core/reading.hpp"

namespace echoarc {

/// Finds readings that leap away from the one before of the same sensors ([Silver04] App. B). The one before is what
/// the sensor said, whether or not it was a leap itself: a lasting change is a leap once.
class JumpFilter {
 public:
  /// Whether the reading differs by more than `threshold_m` from the last one asked about, and remembers it. Between an
  /// echo and silence, or too close, the difference is a leap at any threshold. The first reading is none.
  [[nodiscard]] bool jumps(const Reading& reading, double threshold_m);

 private:
  std::map<std::pair<SensorId, SensorId>, Outcome> last_;
};

}  // namespace echoarc
