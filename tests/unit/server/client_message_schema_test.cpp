// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The reader against the schema: what one accepts, the other must accept.

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "server/client_message.hpp"
#include "unit/server/json_schema.hpp"

namespace echoarc::server {
namespace {

using test::message_schema;
using test::Value;

/// Every type, with every key that it may have.
const std::vector<const char*> samples{
    R"({"type":"hello","protocol":1,"token":"abc","name":"Ann","methods":["consensus"]})",
    R"({"type":"ping","id":1})",
    R"({"type":"subscribe","methods":["vt","dm"]})",
    R"({"type":"stop"})",
    R"({"type":"take"})",
    R"({"type":"release","to":3})",
    R"({"type":"answer","accept":true})",
    R"({"type":"drive","v":0.25,"w":-1,"seq":7})",
    R"({"type":"mode","mode":"goto","x":1.5,"y":-2})",
    R"({"type":"method_add","method":"carve"})",
    R"({"type":"method_add","method":"carve-2","name":"carve","options":{"a":0.5}})",
    R"({"type":"method_remove","method":"carve"})",
    R"({"type":"options","method":"vt","options":{"a":true,"b":3,"c":0.5,"d":"text"}})",
    R"({"type":"sensor","sensor":2,"on":false})",
    R"({"type":"playback","playing":true,"speed":4,"seek_s":12.5})",
    R"({"type":"open","id":5,"scene":"corridor"})",
    R"({"type":"explain","id":1,"method":"consensus","slot":9})",
    R"({"type":"explain","id":1,"method":"evidence","x":1,"y":2})",
    R"({"type":"step","id":2,"method":"evidence","ping":4294967295})",
    R"({"type":"pings","id":3,"from":0,"count":10000})",
    R"({"type":"snapshot","id":4,"t":12.5,"methods":["a","b"]})",
};

Value list_of(std::size_t count) {
  return Value(std::vector<std::string>(count, "a"));
}
Value options_of(std::size_t count) {
  Value options = Value::object();
  for (std::size_t i = 0; i < count; ++i) options["o" + std::to_string(i)] = i;
  return options;
}
std::string umlauts(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += "\xC3\xA4";
  return text;
}

/// What is put in the place of each value.
std::vector<Value> replacements() {
  std::vector<Value> values;
  for (const char* text : {"null",
                           "true",
                           "false",
                           "0",
                           "1",
                           "-1",
                           "2",
                           "1.5",
                           "-0.5",
                           "10",
                           "10.5",
                           "-20.5",
                           "100.5",
                           "0.05",
                           "10001",
                           "1e5",
                           "100001",
                           "-1e6",
                           "1e12",
                           "2e12",
                           "1e300",
                           "4294967295",
                           "4294967296",
                           "9223372036854775808",
                           "18446744073709551615",
                           "-9223372036854775808",
                           "[]",
                           "{}",
                           R"(["a"])",
                           "[1]",
                           "[null]",
                           "[[]]",
                           R"({"a":1})",
                           R"({"a":null})",
                           R"({"a":[1]})",
                           R"({"a":{}})",
                           R"({"a":18446744073709551615})"})
    values.push_back(Value::parse(text));
  for (const std::size_t length : {0U, 1U, 32U, 33U, 40U, 41U, 64U, 65U, 128U, 129U}) {
    values.emplace_back(std::string(length, 'a'));
    values.emplace_back(umlauts(length));
    values.push_back(Value::array({std::string(length, 'a')}));
  }
  for (const std::size_t count : {8U, 9U, 32U, 33U}) values.push_back(list_of(count));
  for (const std::size_t count : {64U, 65U}) values.push_back(options_of(count));
  return values;
}

/// A rule between keys, which the schema leaves to the protocol's text.
bool is_rule_between_keys(const Error& error) {
  return error.message.find("either a \"slot\" or a place") != std::string::npos ||
         error.message.find("has one alone") != std::string::npos;
}

void expect_agreement(const Value& message) {
  const std::string fault = message_schema().message_fault("FromClient", message);
  const Result<ClientMessage> read = parse_message(message.dump());
  if (fault.empty())
    EXPECT_TRUE(read || is_rule_between_keys(read.error()))
        << message.dump() << "\nthe schema accepts it, the reader says: " << (read ? "" : read.error().message);
  else
    EXPECT_FALSE(read) << message.dump() << "\nthe reader accepts it, the schema says: " << fault;
}

TEST(ClientMessageSchema, SamplesAreAcceptedAndShowEveryKey) {
  std::set<std::string> shown;
  for (const char* text : samples) {
    const Value message = Value::parse(text);
    EXPECT_TRUE(parse_message(text)) << text;
    EXPECT_EQ(message_schema().message_fault("FromClient", message), "") << text;
    for (const auto& [key, value] : message.items()) shown.insert(message["type"].get<std::string>() + "." + key);
  }
  for (const std::string& name : message_schema().message_names("FromClient")) {
    const Value& properties = message_schema().definition(name).at("properties");
    const std::string type = properties.at("type").at("const");
    for (const auto& [key, rule] : properties.items())
      EXPECT_TRUE(shown.contains(type + "." + key)) << "no sample has " << type << "." << key;
  }
}

TEST(ClientMessageSchema, HasAReaderForEveryMessageAndNoOther) {
  std::set<std::string> types;
  for (const std::string& name : message_schema().message_names("FromClient")) {
    const std::string type = message_schema().definition(name).at("properties").at("type").at("const");
    types.insert(type);
    const Result<ClientMessage> read = parse_message(Value{{"type", type}}.dump());
    EXPECT_TRUE(read || read.error().message.find("not known") == std::string::npos) << type;
  }
  EXPECT_EQ(types.size(), std::variant_size_v<ClientMessage>);
}

TEST(ClientMessageSchema, ReaderAndSchemaAgreeOnEveryReplacedValue) {
  const std::vector<Value> values = replacements();
  for (const char* text : samples) {
    const Value message = Value::parse(text);
    for (const auto& [key, had] : message.items())
      for (const Value& value : values) {
        if (key == "type" && !value.is_string()) continue;
        Value changed = message;
        changed[key] = value;
        expect_agreement(changed);
      }
  }
}

TEST(ClientMessageSchema, ReaderAndSchemaAgreeOnMissingAndUnknownKeys) {
  for (const char* text : samples) {
    const Value message = Value::parse(text);
    for (const auto& [key, had] : message.items()) {
      Value changed = message;
      changed.erase(key);
      expect_agreement(changed);
    }
    for (const char* key : {"id", "method", "methods", "to", "x", "unheard_of", ""}) {
      Value changed = message;
      if (!changed.contains(key)) changed[key] = 1;
      expect_agreement(changed);
    }
  }
}

TEST(ClientMessageSchema, RulesBetweenKeysAreKept) {
  for (const char* text :
       {R"({"type":"explain","id":1,"method":"a"})", R"({"type":"explain","id":1,"method":"a","slot":1,"x":1,"y":2})",
        R"({"type":"explain","id":1,"method":"a","slot":1,"x":1})", R"({"type":"explain","id":1,"method":"a","x":1})",
        R"({"type":"explain","id":1,"method":"a","y":1})", R"({"type":"mode","mode":"goto","x":1})",
        R"({"type":"mode","mode":"goto","y":1})"}) {
    const Result<ClientMessage> read = parse_message(text);
    ASSERT_FALSE(read) << text;
    EXPECT_TRUE(is_rule_between_keys(read.error())) << read.error().message;
  }
}

}  // namespace
}  // namespace echoarc::server
