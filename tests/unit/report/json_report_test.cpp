// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "small_document.hpp"

namespace echoarc::report {
namespace {

using Json = nlohmann::json;

TEST(JsonReport, HoldsTheFigures) {
  const Json json = Json::parse(json_report(test::small_document()));
  EXPECT_EQ(json["format"], "echoarc-reproduction-1");
  const Json& section = json["studies"][0]["sections"][0];
  EXPECT_EQ(section["claims"][1]["verdict"], "fails");
  const Json& row = section["tables"][0]["rows"][0];
  EXPECT_EQ(row["paper"], 2.5);
  EXPECT_EQ(row["ours"]["mean"], 2.0);
  EXPECT_EQ(row["ours"]["values"], 3);
  EXPECT_TRUE(section["tables"][0]["rows"][1]["paper"].is_null());
  EXPECT_EQ(section["charts"][0]["series"][0]["y"], (Json{1.0, 2.0}));
  EXPECT_EQ(section["pictures"][0]["width"], 2);
}

/// The part of JSON Schema that the project's own schema uses.
void expect_valid(const Json& schema, const Json& definitions, const Json& value, const std::string& where) {
  if (schema.contains("$ref")) {
    const std::string name = schema["$ref"].get<std::string>().substr(std::string("#/$defs/").size());
    return expect_valid(definitions.at(name), definitions, value, where);
  }
  if (schema.contains("const")) {
    EXPECT_EQ(value, schema["const"]) << where;
  }
  if (schema.contains("enum")) {
    EXPECT_NE(std::find(schema["enum"].begin(), schema["enum"].end(), value), schema["enum"].end()) << where;
  }
  if (schema.contains("type")) {
    const Json types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
    std::string type = value.type_name();
    if (value.is_number_integer()) type = "integer";
    const bool integer_as_number = type == "integer" && std::find(types.begin(), types.end(), "number") != types.end();
    EXPECT_TRUE(integer_as_number || std::find(types.begin(), types.end(), type) != types.end())
        << where << ": " << type;
  }
  if (value.is_object() && schema.contains("properties")) {
    for (const auto& [key, part] : value.items()) {
      ASSERT_TRUE(schema["properties"].contains(key)) << where << "." << key;
      expect_valid(schema["properties"][key], definitions, part, where + "." + key);
    }
    for (const Json& key : schema.value("required", Json::array()))
      EXPECT_TRUE(value.contains(key.get<std::string>())) << where << "." << key;
  }
  if (value.is_array() && schema.contains("items"))
    for (const Json& item : value) expect_valid(schema["items"], definitions, item, where + "[]");
}

TEST(JsonReport, ObeysItsSchema) {
  std::ifstream file(ECHOARC_SOURCE_DIR "/schema/reproduction.schema.json");
  ASSERT_TRUE(file);
  const Json schema = Json::parse(file);
  expect_valid(schema, schema["$defs"], Json::parse(json_report(test::small_document())), "report");
}

}  // namespace
}  // namespace echoarc::report
