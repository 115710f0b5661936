// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <charconv>
#include <cstddef>

#include "sensing/findings.hpp"

namespace echoarc {

std::string number_text(double value, int digits) {
  std::array<char, 400> buffer{};  // the largest double has 309 digits before the point
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  std::string text(buffer.data(), end.ptr);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string sensor_text(const std::vector<SensorId>& ids) {
  std::string text = ids.size() == 1 ? "sensor " : "sensors ";
  for (std::size_t begin = 0; begin < ids.size();) {
    std::size_t end = begin + 1;
    while (end < ids.size() && ids[end] == ids[end - 1] + 1) ++end;
    if (begin > 0) text += ",";
    text += std::to_string(ids[begin]);
    if (end - begin > 1) text += "-" + std::to_string(ids[end - 1]);
    begin = end;
  }
  return text;
}

}  // namespace echoarc
