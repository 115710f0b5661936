// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/option_groups.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view schema_type(OptionKind kind) {
  switch (kind) {
    case OptionKind::boolean: return "boolean";
    case OptionKind::integer: return "integer";
    case OptionKind::real: return "number";
    case OptionKind::choice: return "string";
  }
  return "string";
}

/// The legal range or choices under the keywords of JSON Schema.
void put_limits(const OptionSpec& spec, Json& json) {
  if (spec.kind == OptionKind::choice) json["enum"] = spec.choices;
  if (spec.kind != OptionKind::integer && spec.kind != OptionKind::real) return;
  if (std::isfinite(spec.min)) json["minimum"] = spec.min;
  if (std::isfinite(spec.max)) json["maximum"] = spec.max;
}

Json property_schema(const OptionSpec& spec) {
  Json json{{"type", schema_type(spec.kind)}, {"description", spec.doc}, {"default", to_json(spec.default_value)}};
  put_limits(spec, json);
  if (!spec.unit.empty()) json["x-unit"] = spec.unit;
  if (!spec.source.empty()) json["x-source"] = spec.source;
  return json;
}

}  // namespace

std::vector<OptionGroup> option_groups() {
  std::vector<OptionGroup> groups{{"sensing", "Sensing",
                                   "What is shared by all methods: how raw pings become readings.", "",
                                   option_specs<SensingOptions>()}};
  for (const MethodEntry& entry : catalog())
    groups.push_back({entry.name, entry.title, entry.summary, entry.source, entry.specs()});
  return groups;
}

Json to_json(const OptionValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json to_json(const OptionMap& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = to_json(value);
  return json;
}

Json to_json(const OptionSpec& spec) {
  Json json{{"name", spec.name}, {"type", schema_type(spec.kind)}, {"unit", spec.unit}};
  json["default"] = to_json(spec.default_value);
  put_limits(spec, json);
  json["doc"] = spec.doc;
  json["source"] = spec.source;
  return json;
}

Json json_schema(std::span<const OptionGroup> groups) {
  Json properties = Json::object();
  for (const OptionGroup& group : groups) {
    Json options = Json::object();
    for (const OptionSpec& spec : group.specs) options[std::string(spec.name)] = property_schema(spec);
    properties[std::string(group.name)] = {{"type", "object"},
                                           {"title", group.title},
                                           {"description", group.summary},
                                           {"properties", options},
                                           {"additionalProperties", false}};
  }
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "Options of echoarc"},
          {"type", "object"},
          {"properties", properties},
          {"additionalProperties", false}};
}

}  // namespace echoarc::cli
