// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace echoarc::io {

/// A range that is no number, as the JSON Lines log says it and as REP 117 does.
struct RangeWord {
  std::string_view word;
  double rep117;
};
inline constexpr std::array range_words = {
    RangeWord{"no_echo", std::numeric_limits<double>::infinity()},
    RangeWord{"too_close", -std::numeric_limits<double>::infinity()},
    RangeWord{"invalid", std::numeric_limits<double>::quiet_NaN()},
};

[[nodiscard]] inline std::optional<double> range_of_word(std::string_view word) {
  for (const RangeWord& known : range_words)
    if (known.word == word) return known.rep117;
  return std::nullopt;
}

/// The word for a range that is not finite.
[[nodiscard]] inline std::string_view word_of_range(double range_m) {
  if (std::isnan(range_m)) return range_words[2].word;
  return range_m > 0.0 ? range_words[0].word : range_words[1].word;
}

}  // namespace echoarc::io
