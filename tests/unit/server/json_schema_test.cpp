// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "unit/server/json_schema.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::server::test {
namespace {

struct Case {
  const char* schema;
  std::vector<const char*> good;
  std::vector<const char*> bad;
};

std::vector<Case> cases() {
  return {
      {R"({"type":"integer"})", {"1", "-1"}, {"1.5", "\"1\"", "null", "[1]"}},
      {R"({"type":["boolean","string"]})", {"true", "\"a\""}, {"1", "null", "{}"}},
      {R"({"type":"null"})", {"null"}, {"0", "false", "\"\""}},
      {R"({"const":1})", {"1"}, {"2", "\"1\""}},
      {R"({"enum":["on","off"]})", {"\"on\""}, {"\"full\"", "1"}},
      {R"({"type":"number","minimum":0.5,"maximum":2})", {"0.5", "2"}, {"0.49", "2.01"}},
      {R"({"type":"string","maxLength":3})", {"\"\"", "\"\\u00e4\\u00e4\\u00e4\""}, {"\"abcd\""}},
      {R"({"items":{"type":"number"},"minItems":1,"maxItems":2})", {"[1]", "[1,2]"}, {"[]", "[1,2,3]", "[1,\"2\"]"}},
      {R"({"type":"object","properties":{"a":{"type":"number"}},"required":["a"],"additionalProperties":false})",
       {R"({"a":1})"},
       {"{}", R"({"a":"1"})", R"({"a":1,"b":2})", "[]"}},
      {R"({"type":"object","additionalProperties":{"type":"number"},"maxProperties":2})",
       {"{}", R"({"x":1,"y":2})"},
       {R"({"x":"1"})", R"({"x":1,"y":2,"z":3})"}},
      {R"({"anyOf":[{"type":"null"},{"$ref":"#/$defs/Small"}]})", {"null", "1"}, {"5", "\"a\""}},
      {R"({"properties":{"a":{"items":{"$ref":"#/$defs/Small"}}}})", {R"({"a":[1,2]})"}, {R"({"a":[1,5]})"}},
  };
}

Value document(Value it) {
  Value whole = Value::parse(R"({"$defs":{"Small":{"type":"integer","maximum":4}}})");
  whole["$defs"]["It"] = std::move(it);
  return whole;
}

TEST(JsonSchema, TellsGoodFromBad) {
  for (const Case& c : cases()) {
    const JsonSchema schema(document(Value::parse(c.schema)));
    for (const char* good : c.good) EXPECT_EQ(schema.fault("It", Value::parse(good)), "") << c.schema;
    for (const char* bad : c.bad) EXPECT_NE(schema.fault("It", Value::parse(bad)), "") << c.schema << " took " << bad;
  }
}

TEST(JsonSchema, NamesThePlace) {
  const JsonSchema schema(document(Value::parse(R"({"properties":{"a":{"items":{"type":"null"}}}})")));
  EXPECT_EQ(schema.fault("It", Value::parse(R"({"a":[null,7]})")), R"(It.a[1]: 7 against type "null")");
}

TEST(JsonSchema, RefusesARuleThatItCannotCheck) {
  const JsonSchema schema(document(Value::parse(R"({"pattern":"^a"})")));
  EXPECT_THROW((void)schema.fault("It", "a"), std::logic_error);
}

TEST(JsonSchema, FindsTheDefinitionOfAMessage) {
  const JsonSchema& schema = message_schema();
  EXPECT_EQ(schema.message_fault("FromClient", {{"type", "stop"}}), "");
  EXPECT_NE(schema.message_fault("FromServer", {{"type", "stop"}}), "");
  EXPECT_NE(schema.message_fault("FromClient", {{"type", "stop"}, {"force", true}}), "");
  EXPECT_NE(schema.message_fault("FromClient", Value::array()), "");
}

}  // namespace
}  // namespace echoarc::server::test
