// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/message_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace echoarc::server {
namespace {

constexpr const char* remedy = "docs/protocol.md and schema/messages.schema.json say what a message holds";

/// In characters; the parser has seen that it is UTF-8.
std::size_t length_of(const nlohmann::json& text) {
  const auto begins_character = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(text.get_ref<const std::string&>(), begins_character));
}

bool exceeds_int64(const nlohmann::json& number) {
  constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  return number.is_number_unsigned() && number.get<std::uint64_t>() > most;
}

}  // namespace

void MessageFields::fault(std::string what) {
  if (fault_.empty()) fault_ = std::move(what);
}

const nlohmann::json* MessageFields::find(const char* key, bool required) {
  taken_.insert(key);
  const auto found = object_.find(key);
  if (found != object_.end()) return &*found;
  if (required) fault(fmt::format("it has no \"{}\"", key));
  return nullptr;
}

std::string MessageFields::text(const char* key, std::size_t max_length) {
  const nlohmann::json* value = find(key, true);
  if (value == nullptr) return {};
  if (value->is_string() && length_of(*value) <= max_length) return *value;
  fault(fmt::format("\"{}\" is no text of at most {} characters", key, max_length));
  return {};
}

std::string MessageFields::text_or_empty(const char* key, std::size_t max_length) {
  return object_.contains(key) ? text(key, max_length) : std::string();
}

std::optional<std::string> MessageFields::optional_text(const char* key, std::size_t max_length) {
  if (!object_.contains(key)) return std::nullopt;
  return text(key, max_length);
}

std::optional<bool> MessageFields::optional_boolean(const char* key) {
  const nlohmann::json* value = find(key, false);
  if (value == nullptr) return std::nullopt;
  if (value->is_boolean()) return value->get<bool>();
  fault(fmt::format("\"{}\" is neither true nor false", key));
  return std::nullopt;
}

bool MessageFields::boolean(const char* key) {
  (void)find(key, true);
  return optional_boolean(key).value_or(false);
}

std::optional<double> MessageFields::optional_number(const char* key, double min, double max) {
  const nlohmann::json* value = find(key, false);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) {
    const double number = value->get<double>();
    if (std::isfinite(number) && number >= min && number <= max) return number;
  }
  fault(fmt::format("\"{}\" is no number from {} to {}", key, min, max));
  return std::nullopt;
}

double MessageFields::number(const char* key, double min, double max) {
  (void)find(key, true);
  return optional_number(key, min, max).value_or(0.0);
}

std::uint32_t MessageFields::integer(const char* key, std::uint32_t min, std::uint32_t max) {
  const nlohmann::json* value = find(key, true);
  if (value == nullptr) return min;
  if (value->is_number_unsigned()) {
    const auto number = value->get<std::uint64_t>();
    if (number >= min && number <= max) return static_cast<std::uint32_t>(number);
  }
  fault(fmt::format("\"{}\" is no whole number from {} to {}", key, min, max));
  return min;
}

std::optional<std::uint32_t> MessageFields::optional_integer(const char* key) {
  if (!object_.contains(key)) return std::nullopt;
  return integer(key, 0);
}

std::vector<std::string> MessageFields::texts(const char* key, std::size_t max_count, std::size_t max_length) {
  const nlohmann::json* list = find(key, true);
  if (list == nullptr) return {};
  std::vector<std::string> texts;
  bool good = list->is_array() && list->size() <= max_count;
  for (std::size_t i = 0; good && i < list->size(); ++i) {
    good = (*list)[i].is_string() && length_of((*list)[i]) <= max_length;
    if (good) texts.push_back((*list)[i]);
  }
  if (good) return texts;
  fault(fmt::format("\"{}\" is no list of at most {} names", key, max_count));
  return {};
}

std::optional<std::vector<std::string>> MessageFields::optional_texts(const char* key, std::size_t max_count,
                                                                      std::size_t max_length) {
  if (!object_.contains(key)) return std::nullopt;
  return texts(key, max_count, max_length);
}

OptionMap MessageFields::options(const char* key, std::size_t max_count) {
  const nlohmann::json* object = find(key, true);
  if (object == nullptr) return {};
  if (!object->is_object() || object->size() > max_count) {
    fault(fmt::format("\"{}\" is no object of at most {} options", key, max_count));
    return {};
  }
  OptionMap options;
  for (const auto& [name, value] : object->items()) {
    if (value.is_boolean())
      options.emplace(name, value.get<bool>());
    else if (value.is_number_integer() && !exceeds_int64(value))
      options.emplace(name, value.get<std::int64_t>());
    else if (value.is_number())
      options.emplace(name, value.get<double>());
    else if (value.is_string())
      options.emplace(name, value.get<std::string>());
    else
      fault(fmt::format("option \"{:.40}\" is neither number, text, true nor false", name));
  }
  return options;
}

std::optional<OptionMap> MessageFields::optional_options(const char* key, std::size_t max_count) {
  if (!object_.contains(key)) return std::nullopt;
  return options(key, max_count);
}

Result<void> MessageFields::finish(std::string_view type) {
  for (const auto& [key, value] : object_.items())
    if (!taken_.contains(key)) fault(fmt::format("it has an unknown key \"{:.40}\"", key));
  if (fault_.empty()) return {};
  return Error{ErrorCode::bad_format, fmt::format("message \"{}\": {}", type, fault_), std::string(type), remedy};
}

}  // namespace echoarc::server
