// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/option_groups.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "cli/feature_extraction.hpp"
#include "echoarc/io/config.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

Json schema_of(const OptionGroup& group) {
  return Json::parse(io::option_schema(group.title, group.specs));
}

}  // namespace

std::vector<OptionGroup> option_groups() {
  std::vector<OptionGroup> groups{{"sensing", "Sensing",
                                   "What is shared by all methods: how raw pings become readings.", "",
                                   option_specs<SensingOptions>()}};
  for (const MethodEntry& entry : catalog())
    groups.push_back({entry.name, entry.title, entry.summary, entry.source, entry.specs()});
  groups.insert(groups.end(), feature_groups().begin(), feature_groups().end());
  return groups;
}

Json group_json(const OptionGroup& group) {
  const Json schema = schema_of(group);
  Json options = Json::array();
  for (const auto& [name, property] : schema["properties"].items()) {
    Json option{{"name", name}};
    option.update(property);
    options.push_back(std::move(option));
  }
  return {{"name", group.name},
          {"title", group.title},
          {"summary", group.summary},
          {"source", group.source},
          {"options", std::move(options)}};
}

Json json_schema(std::span<const OptionGroup> groups) {
  Json properties = Json::object();
  for (const OptionGroup& group : groups) {
    Json schema = schema_of(group);
    schema.erase("$schema");
    schema["description"] = group.summary;
    properties[std::string(group.name)] = std::move(schema);
  }
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "Options of echoarc"},
          {"type", "object"},
          {"properties", std::move(properties)},
          {"additionalProperties", false}};
}

}  // namespace echoarc::cli
