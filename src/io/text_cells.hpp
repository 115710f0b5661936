// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace echoarc::io {

inline constexpr std::string_view blanks = " \t";

[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// The whole of `text` as a number; "inf" and "nan" are numbers, a leading "+" is allowed.
template <class Number>
[[nodiscard]] std::optional<Number> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The words between blanks, at most `max_words`; what is left then is not looked at.
inline void split_words(std::string_view text, std::size_t max_words, std::vector<std::string_view>& words) {
  words.clear();
  while (words.size() < max_words) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return;
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    text.remove_prefix(end);
  }
}

/// The cells between delimiters, trimmed and without the quotes around them; at most `max_cells`.
inline void split_cells(std::string_view text, char delimiter, std::size_t max_cells,
                        std::vector<std::string_view>& cells) {
  cells.clear();
  while (cells.size() < max_cells) {
    const std::size_t end = std::min(text.find(delimiter), text.size());
    std::string_view cell = trimmed(text.substr(0, end));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

}  // namespace echoarc::io
