// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace echoarc::server::test {

using Value = nlohmann::json;

/// As much of JSON Schema as schema/messages.schema.json uses. A keyword that it does not know is thrown: a rule that
/// nobody checks would be worse than none.
class JsonSchema {
 public:
  explicit JsonSchema(Value document) : document_(std::move(document)) {}

  /// What is wrong with a value by a definition, the place first; empty: nothing.
  [[nodiscard]] std::string fault(const std::string& definition, const Value& value) const {
    return check(document_.at("$defs").at(definition), value, definition);
  }
  /// The same of a message, by the definition that has its type. `side`: "FromClient" or "FromServer".
  [[nodiscard]] std::string message_fault(const std::string& side, const Value& message) const {
    if (!message.is_object() || !message.contains("type")) return "it has no type";
    for (const std::string& name : message_names(side))
      if (definition(name).at("properties").at("type").at("const") == message.at("type")) return fault(name, message);
    return "no message of " + side + " has type " + message.at("type").dump();
  }
  [[nodiscard]] std::vector<std::string> message_names(const std::string& side) const {
    std::vector<std::string> names;
    for (const Value& choice : definition(side).at("anyOf")) names.push_back(name_of(choice.at("$ref")));
    return names;
  }
  [[nodiscard]] const Value& definition(const std::string& name) const { return document_.at("$defs").at(name); }

 private:
  static std::string name_of(const std::string& reference) { return reference.substr(std::string("#/$defs/").size()); }

  [[nodiscard]] std::string check(const Value& schema, const Value& value, const std::string& place) const {
    for (const auto& [keyword, rule] : schema.items()) {
      std::string wrong = is_structure(keyword) ? structure(schema, keyword, rule, value, place)
                          : holds(keyword, rule, value)
                              ? std::string()
                              : place + ": " + value.dump().substr(0, 80) + " against " + keyword + " " + rule.dump();
      if (!wrong.empty()) return wrong;
    }
    return "";
  }

  static bool is_structure(const std::string& keyword) {
    return keyword == "properties" || keyword == "additionalProperties" || keyword == "items" || keyword == "anyOf" ||
           keyword == "$ref";
  }
  /// Keywords that hold other schemas.
  [[nodiscard]] std::string structure(const Value& schema, const std::string& keyword, const Value& rule,
                                      const Value& value, const std::string& place) const {
    if (keyword == "$ref") return check(definition(name_of(rule)), value, place);
    if (keyword == "anyOf") return any_of(rule, value, place);
    if (keyword == "items") return items(rule, value, place);
    if (!value.is_object()) return "";
    return keyword == "properties" ? properties(rule, value, place) : additional(schema, rule, value, place);
  }
  [[nodiscard]] std::string any_of(const Value& choices, const Value& value, const std::string& place) const {
    std::string wrong;
    for (const Value& choice : choices) {
      wrong = check(choice, value, place);
      if (wrong.empty()) return "";
    }
    return wrong;
  }
  [[nodiscard]] std::string items(const Value& rule, const Value& value, const std::string& place) const {
    if (!value.is_array()) return "";
    for (std::size_t i = 0; i < value.size(); ++i)
      if (std::string wrong = check(rule, value[i], place + "[" + std::to_string(i) + "]"); !wrong.empty())
        return wrong;
    return "";
  }
  [[nodiscard]] std::string properties(const Value& rule, const Value& value, const std::string& place) const {
    for (const auto& [key, property] : rule.items())
      if (value.contains(key))
        if (std::string wrong = check(property, value[key], place + "." + key); !wrong.empty()) return wrong;
    return "";
  }
  [[nodiscard]] std::string additional(const Value& schema, const Value& rule, const Value& value,
                                       const std::string& place) const {
    for (const auto& [key, member] : value.items()) {
      if (schema.contains("properties") && schema["properties"].contains(key)) continue;
      if (rule == false) return place + ": unknown key " + key;
      if (rule == true) continue;
      if (std::string wrong = check(rule, member, place + "." + key); !wrong.empty()) return wrong;
    }
    return "";
  }

  /// Keywords that speak of the value alone.
  static bool holds(const std::string& keyword, const Value& rule, const Value& value) {
    if (keyword == "description") return true;
    if (keyword == "type") return has_type(rule, value);
    if (keyword == "const") return value == rule;
    if (keyword == "enum") return std::ranges::find(rule, value) != rule.end();
    if (keyword == "required")
      return !value.is_object() || std::ranges::all_of(rule, [&](const Value& key) { return value.contains(key); });
    if (keyword == "minimum") return !value.is_number() || value.get<double>() >= rule.get<double>();
    if (keyword == "maximum") return !value.is_number() || value.get<double>() <= rule.get<double>();
    if (keyword == "minItems") return !value.is_array() || value.size() >= rule.get<std::size_t>();
    if (keyword == "maxItems") return !value.is_array() || value.size() <= rule.get<std::size_t>();
    if (keyword == "maxProperties") return !value.is_object() || value.size() <= rule.get<std::size_t>();
    if (keyword == "maxLength") return !value.is_string() || characters(value) <= rule.get<std::size_t>();
    throw std::logic_error("no rule is known for keyword " + keyword);
  }
  static bool has_type(const Value& rule, const Value& value) {
    if (rule.is_array()) return std::ranges::any_of(rule, [&](const Value& one) { return has_type(one, value); });
    if (rule == "integer") return value.is_number_integer();
    if (rule == "number") return value.is_number();
    if (rule == "string") return value.is_string();
    if (rule == "boolean") return value.is_boolean();
    if (rule == "object") return value.is_object();
    if (rule == "array") return value.is_array();
    if (rule == "null") return value.is_null();
    throw std::logic_error("no type is called " + rule.dump());
  }
  static std::size_t characters(const std::string& text) {
    std::size_t count = 0;
    for (const char byte : text) count += (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U ? 1 : 0;
    return count;
  }

  Value document_;
};

/// The wire contract.
inline const JsonSchema& message_schema() {
  static const JsonSchema schema = [] {
    std::ifstream file(std::filesystem::path(ECHOARC_SOURCE_DIR) / "schema/messages.schema.json");
    return JsonSchema(Value::parse(file));
  }();
  return schema;
}

}  // namespace echoarc::server::test
