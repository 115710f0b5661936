// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/toml_fields.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "echoarc/core/options.hpp"

namespace echoarc::io {

std::string toml_place(std::string_view source, const toml::source_region& region) {
  return region.begin.line > 0 ? fmt::format("{}:{}", source, region.begin.line) : std::string(source);
}

Result<toml::table> parse_toml(std::string_view text, std::string_view source) {
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    return Error{
        ErrorCode::bad_format, "not valid TOML: " + std::string(error.description()),
        fmt::format("{}:{}", toml_place(source, error.source()), error.source().begin.column),
        "correct the line; strings need quotes, tables [brackets], numbers a digit on both sides of the point"};
  }
}

std::optional<double> TomlFields::number(std::string_view key, double min, double max) {
  const toml::node* found = node(key);
  if (found == nullptr) return std::nullopt;
  const std::optional<double> value = found->is_number() ? found->value<double>() : std::nullopt;
  if (!value) {
    wrong_type(*found, key, "a number");
    return std::nullopt;
  }
  if (!std::isfinite(*value) || *value < min || *value > max) {
    fail(found, fmt::format("{} = {} of {} is out of range", key, *value, what_),
         std::isfinite(min) && std::isfinite(max) ? fmt::format("use {} to {}", min, max)
         : std::isfinite(min)                     ? fmt::format("use at least {}", min)
                                                  : "use a finite number");
    return std::nullopt;
  }
  return value;
}

std::optional<double> TomlFields::length_m(std::string_view key, double min, double max) {
  const std::string with_unit = std::string(key) + "_m";
  if (has(key) && has(with_unit))
    fail(node(with_unit), fmt::format("{} gives both {} and {}", what_, key, with_unit), "keep one of them");
  const std::optional<double> plain = number(key, min, max);
  const std::optional<double> metres = number(with_unit, min, max);
  return plain ? plain : metres;
}

std::optional<Angle> TomlFields::angle(std::string_view key) {
  const std::string with_unit = std::string(key) + "_deg";
  if (has(key) && has(with_unit))
    fail(node(with_unit), fmt::format("{} gives both {} and {}", what_, key, with_unit),
         fmt::format("keep one: {} is in radians, {} in degrees", key, with_unit));
  const std::optional<double> rad = number(key);
  const std::optional<double> deg = number(with_unit);
  if (rad) return radians(*rad);
  if (deg) return degrees(*deg);
  return std::nullopt;
}

std::optional<std::int64_t> TomlFields::integer(std::string_view key, std::int64_t min, std::int64_t max) {
  const toml::node* found = node(key);
  if (found == nullptr) return std::nullopt;
  if (!found->is_integer()) {
    wrong_type(*found, key, "a whole number");
    return std::nullopt;
  }
  const std::int64_t value = found->as_integer()->get();
  if (value >= min && value <= max) return value;
  fail(found, fmt::format("{} = {} of {} is out of range", key, value, what_), fmt::format("use {} to {}", min, max));
  return std::nullopt;
}

std::optional<bool> TomlFields::boolean(std::string_view key) {
  const toml::node* found = node(key);
  if (found == nullptr) return std::nullopt;
  if (found->is_boolean()) return found->as_boolean()->get();
  wrong_type(*found, key, "true or false");
  return std::nullopt;
}

std::optional<std::string> TomlFields::text(std::string_view key) {
  const toml::node* found = node(key);
  if (found == nullptr) return std::nullopt;
  if (found->is_string()) return found->as_string()->get();
  wrong_type(*found, key, "a \"string\"");
  return std::nullopt;
}

const toml::table* TomlFields::table(std::string_view key) {
  const toml::node* found = node(key);
  if (found != nullptr && !found->is_table()) wrong_type(*found, key, "a table { ... }");
  return found != nullptr ? found->as_table() : nullptr;
}

const toml::array* TomlFields::array(std::string_view key) {
  const toml::node* found = node(key);
  if (found != nullptr && !found->is_array()) wrong_type(*found, key, "a list [ ... ]");
  return found != nullptr ? found->as_array() : nullptr;
}

std::vector<const toml::table*> TomlFields::tables(std::string_view key, std::size_t max_count) {
  const toml::node* found = node(key);
  if (found == nullptr) return {};
  if (found->is_table()) return {found->as_table()};
  if (!found->is_array()) {
    wrong_type(*found, key, "a table, or a list of tables");
    return {};
  }
  std::vector<const toml::table*> tables;
  for (const toml::node& element : *found->as_array()) {
    if (!element.is_table()) {
      wrong_type(element, key, "a list of tables");
      return {};
    }
    tables.push_back(element.as_table());
  }
  if (tables.size() <= max_count) return tables;
  fail(found, fmt::format("{} {} are too many", tables.size(), key), fmt::format("at most {} are allowed", max_count));
  return {};
}

const toml::node* TomlFields::node(std::string_view key) {
  known_.emplace(key);
  return table_.get(key);
}

void TomlFields::wrong_type(const toml::node& node, std::string_view key, std::string_view wanted) {
  fail(&node, fmt::format("{} of {} has the wrong type", key, what_), fmt::format("write {} = {}", key, wanted));
}

void TomlFields::fail(const toml::node* at, std::string message, std::string remedy) {
  const toml::source_region& region = at != nullptr ? at->source() : table_.source();
  fail(Error{ErrorCode::bad_value, std::move(message), toml_place(source_, region), std::move(remedy)});
}

void TomlFields::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

Result<void> TomlFields::finish() {
  if (error_) return *error_;
  for (const auto& [key, value] : table_)
    if (!known_.contains(key.str())) return unknown_key(key);
  return {};
}

Error TomlFields::unknown_key(const toml::key& key) const {
  std::vector<OptionSpec> specs(known_.size());
  std::size_t i = 0;
  for (const std::string& name : known_) specs[i++].name = name;
  return {ErrorCode::bad_value, fmt::format("there is no key {} in {}", key.str(), what_),
          toml_place(source_, key.source()), unknown_option(key.str(), specs).remedy};
}

}  // namespace echoarc::io
