// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string_view>
#include <variant>

namespace echoarc {

/// Something answered at this range (metres; for receiver != transmitter half of the path).
struct Echo {
  double range_m = 0.0;
  friend constexpr bool operator==(Echo, Echo) = default;
};
/// The receiver listened to the end and heard nothing. REP 117 writes it +Inf.
struct NoEcho {
  friend constexpr bool operator==(NoEcho, NoEcho) = default;
};
/// Something is nearer than the sensor can measure. REP 117 writes it -Inf.
struct TooClose {
  friend constexpr bool operator==(TooClose, TooClose) = default;
};
/// The hardware reported a failed measurement. REP 117 writes it NaN.
struct Invalid {
  friend constexpr bool operator==(Invalid, Invalid) = default;
};

/// What one ping gave. Never a magic number: every spelling of "nothing" is turned into one of these by `sensing`.
using Outcome = std::variant<NoEcho, Echo, TooClose, Invalid>;

[[nodiscard]] constexpr std::optional<double> echo_range_m(const Outcome& outcome) {
  const Echo* echo = std::get_if<Echo>(&outcome);
  return echo != nullptr ? std::optional<double>{echo->range_m} : std::nullopt;
}

[[nodiscard]] constexpr bool is_no_echo(const Outcome& outcome) {
  return std::holds_alternative<NoEcho>(outcome);
}

[[nodiscard]] constexpr std::string_view name(const Outcome& outcome) {
  constexpr std::string_view names[] = {"no_echo", "echo", "too_close", "invalid"};
  return names[outcome.index()];
}

}  // namespace echoarc
