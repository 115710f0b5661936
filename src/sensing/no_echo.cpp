// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/no_echo.hpp"

#include <cmath>

#include "echoarc/core/options.hpp"

namespace echoarc {
namespace {

// Limits written in millimetres and scaled to metres need not be hit to the last bit.
constexpr double slack = 1e-9;

bool is_minus_one(double raw) {
  for (const double unit_m : {1.0, 0.1, 0.01, 0.001})
    if (std::abs(raw + unit_m) <= slack * unit_m) return true;
  return false;
}

bool is_code(double raw, const NoEchoDecision& decision) {
  if (raw == decision.code_m) return true;
  if (raw < 0.0 && decision.below_is_no_echo) return true;
  if (decision.zero_is_no_echo && (raw == 0.0 || is_minus_one(raw))) return true;
  return raw >= decision.from_m * (1.0 - slack) && raw <= decision.implausible_m * (1.0 + slack);
}

DecodedRange rejected(Rejection reason) {
  return {Invalid{}, reason};
}

std::string metres(double value) {
  return to_text(value) + " m";
}

}  // namespace

NoEchoDecision describe_no_echo(const Sensor& sensor) {
  const double max_m = sensor.model.range_max_m;
  NoEchoDecision decision{.sensor = sensor.id, .implausible_m = 2.0 * max_m, .sentence = {}, .rule = {}};
  switch (sensor.model.no_echo.kind) {
    case NoEchoRule::Kind::automatic:
      decision.zero_is_no_echo = true;
      decision.from_m = max_m;
      decision.rule = "+Inf, 0, -1 and values from the maximum of " + metres(max_m) + " to " + metres(2.0 * max_m) +
                      " are read as no echo; no log was looked at";
      break;
    case NoEchoRule::Kind::inf: decision.rule = "+Inf alone is no echo, as described"; break;
    case NoEchoRule::Kind::nan:
      decision.nan_is_no_echo = true;
      decision.rule = "NaN and +Inf are no echo, as described";
      break;
    case NoEchoRule::Kind::zero:
      decision.zero_is_no_echo = true;
      decision.below_is_no_echo = true;
      decision.rule = "0, negative values and +Inf are no echo, as described";
      break;
    case NoEchoRule::Kind::max:
    case NoEchoRule::Kind::above:
      decision.from_m = sensor.model.no_echo.kind == NoEchoRule::Kind::max ? max_m : sensor.model.no_echo.above_m;
      decision.implausible_m = std::numeric_limits<double>::infinity();
      decision.rule = "values of " + metres(decision.from_m) + " and above are no echo, as described";
      break;
  }
  decision.sentence = "sensor " + std::to_string(sensor.id) + ": " + decision.rule;
  return decision;
}

DecodedRange decode_range(double raw_m, const NoEchoDecision& decision, const SensorModel& model) {
  if (std::isnan(raw_m)) return decision.nan_is_no_echo ? DecodedRange{NoEcho{}, {}} : rejected(Rejection::invalid);
  if (std::isinf(raw_m)) return {raw_m > 0.0 ? Outcome{NoEcho{}} : Outcome{TooClose{}}, {}};
  if (is_code(raw_m, decision)) return {NoEcho{}, {}};
  if (raw_m < 0.0) return rejected(Rejection::invalid);
  if (raw_m > 2.0 * model.range_max_m * (1.0 + slack)) return rejected(Rejection::implausible_range);
  if (raw_m > model.range_max_m * (1.0 + slack)) return rejected(Rejection::above_max_range);
  if (raw_m < model.range_min_m * (1.0 - slack) || raw_m == 0.0) return rejected(Rejection::below_min_range);
  return {Echo{raw_m}, {}};
}

}  // namespace echoarc
