// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc::server {

/// Takes the fields of one message out, each at most once. The first fault is remembered and everything after it yields
/// defaults; a key that nobody took is a fault, too.
class MessageFields {
 public:
  explicit MessageFields(const nlohmann::json& object) : object_(object) {}

  std::string text(const char* key, std::size_t max_length);
  std::string text_or_empty(const char* key, std::size_t max_length);
  std::optional<std::string> optional_text(const char* key, std::size_t max_length);
  bool boolean(const char* key);
  std::optional<bool> optional_boolean(const char* key);
  double number(const char* key, double min, double max);
  std::optional<double> optional_number(const char* key, double min, double max);
  std::uint32_t integer(const char* key, std::uint32_t min,
                        std::uint32_t max = std::numeric_limits<std::uint32_t>::max());
  std::optional<std::uint32_t> optional_integer(const char* key);
  std::vector<std::string> texts(const char* key, std::size_t max_count, std::size_t max_length);
  std::optional<std::vector<std::string>> optional_texts(const char* key, std::size_t max_count,
                                                         std::size_t max_length);
  OptionMap options(const char* key, std::size_t max_count);
  std::optional<OptionMap> optional_options(const char* key, std::size_t max_count);

  void fault(std::string what);
  /// The first fault, or that of a key that is not known.
  [[nodiscard]] Result<void> finish(std::string_view type);

 private:
  [[nodiscard]] const nlohmann::json* find(const char* key, bool required);

  const nlohmann::json& object_;
  std::set<std::string, std::less<>> taken_{"type"};
  std::string fault_;
};

}  // namespace echoarc::server
