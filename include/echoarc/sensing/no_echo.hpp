// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/outcome.hpp"
#include "echoarc/sensing/rejection.hpp"

namespace echoarc {

/// How the raw values of one sensor are read. +Inf is always no echo and -Inf always too close (REP 117).
struct NoEchoDecision {
  SensorId sensor = 0;
  bool nan_is_no_echo = false;    ///< otherwise NaN is a failed measurement
  bool zero_is_no_echo = false;   ///< 0 and the ways to write -1; otherwise they are failed measurements
  bool below_is_no_echo = false;  ///< every negative number as well
  double from_m = std::numeric_limits<double>::infinity();         ///< this and everything above is no echo, up to ...
  double implausible_m = std::numeric_limits<double>::infinity();  ///< ... here; beyond, the range is implausible
  double code_m = std::numeric_limits<double>::quiet_NaN();        ///< this very value is no echo, however large it is
  std::string sentence;                                            ///< what was decided and why, for people
  std::string rule;  ///< the same without the sensor and its counts: equal for sensors that are read alike
};

/// The rule of a description carried out to the letter; for `automatic`, what can be said without having seen a log:
/// 0, -1 and everything from the maximum range to twice that is no echo, what lies beyond is implausible.
[[nodiscard]] NoEchoDecision describe_no_echo(const Sensor& sensor);

/// One decision per sensor of `array`, in its order. `automatic` looks at all values of a log first: a value near the
/// top that is far more frequent than its neighbours and has next to nothing beyond it is the sensor's code for no
/// echo. Sensors of the same model are looked at together. Depends on the values alone, not on their order.
[[nodiscard]] std::vector<NoEchoDecision> decide_no_echo(const SensorArray& array, std::span<const Ping> pings);

/// A raw value as an outcome, or the reason for which it is none.
struct DecodedRange {
  Outcome outcome;
  std::optional<Rejection> rejection;
};

/// `raw_m` of a sensor of the given model: first the decision, then the model's limits. A range below the minimum is
/// `below_min_range`; the caller may choose to read it as too close.
[[nodiscard]] DecodedRange decode_range(double raw_m, const NoEchoDecision& decision, const SensorModel& model);

}  // namespace echoarc
