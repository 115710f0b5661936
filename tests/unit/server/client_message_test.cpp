// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/client_message.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::server {
namespace {

template <class Message>
Message parsed(std::string_view text) {
  const Result<ClientMessage> message = parse_message(text);
  if (!message) {
    ADD_FAILURE() << text << ": " << message.error().message;
    return {};
  }
  const Message* wanted = std::get_if<Message>(&message.value());
  if (wanted == nullptr) {
    ADD_FAILURE() << text << " became another message";
    return {};
  }
  return *wanted;
}

void expect_refused(std::string_view text, std::string_view why) {
  const Result<ClientMessage> message = parse_message(text);
  ASSERT_FALSE(message) << text;
  EXPECT_NE(message.error().message.find(why), std::string::npos) << message.error().message;
  EXPECT_FALSE(message.error().remedy.empty());
}

TEST(ClientMessage, HelloWithAndWithoutToken) {
  const auto watcher = parsed<Hello>(R"({"type":"hello","protocol":1})");
  EXPECT_EQ(watcher.token, "");
  EXPECT_FALSE(watcher.methods);
  const auto driver =
      parsed<Hello>(R"({"type":"hello","protocol":1,"token":"abc","name":"Ann","methods":["consensus"]})");
  EXPECT_EQ(driver.token, "abc");
  EXPECT_EQ(driver.name, "Ann");
  EXPECT_EQ(driver.methods, std::vector<std::string>{"consensus"});
  expect_refused(R"({"type":"hello","protocol":2})", "protocol");
  expect_refused(R"({"type":"hello"})", "protocol");
}

TEST(ClientMessage, DriveWithinItsBounds) {
  const auto drive = parsed<DriveMessage>(R"({"type":"drive","v":0.25,"w":-1,"seq":7})");
  EXPECT_EQ(drive.v_m_s, 0.25);
  EXPECT_EQ(drive.w_rad_s, -1.0);
  EXPECT_EQ(drive.seq, 7U);
  expect_refused(R"({"type":"drive","v":10.01,"w":0})", "\"v\"");
  expect_refused(R"({"type":"drive","v":0,"w":-20.5})", "\"w\"");
  expect_refused(R"({"type":"drive","v":"fast","w":0})", "\"v\"");
  expect_refused(R"({"type":"drive","v":null,"w":0})", "\"v\"");
  expect_refused(R"({"type":"drive","v":1e999,"w":0})", "");
  expect_refused(R"({"type":"drive","v":NaN,"w":0})", "no JSON object");
  expect_refused(R"({"type":"drive","w":0})", "has no \"v\"");
}

TEST(ClientMessage, GoToNeedsBothCoordinatesOrNone) {
  const auto mode = parsed<ModeMessage>(R"({"type":"mode","mode":"goto","x":1.5,"y":-2})");
  EXPECT_EQ(mode.mode, "goto");
  EXPECT_EQ(mode.x_m, 1.5);
  EXPECT_EQ(mode.y_m, -2.0);
  EXPECT_FALSE(parsed<ModeMessage>(R"({"type":"mode","mode":"tour"})").x_m);
  expect_refused(R"({"type":"mode","mode":"goto","x":1.5})", "one alone");
  expect_refused(R"({"type":"mode","mode":"goto","x":1e9,"y":0})", "\"x\"");
}

TEST(ClientMessage, OptionsOfEveryKind) {
  const auto message =
      parsed<OptionsMessage>(R"({"type":"options","method":"atm_mod","options":{"a":true,"b":3,"c":0.5,"d":"text"}})");
  EXPECT_EQ(message.method, "atm_mod");
  const OptionMap wanted{{"a", true}, {"b", std::int64_t{3}}, {"c", 0.5}, {"d", std::string("text")}};
  EXPECT_EQ(message.options, wanted);
  expect_refused(R"({"type":"options","method":"atm_mod","options":{"a":[1]}})", "option \"a\"");
  expect_refused(R"({"type":"options","method":"atm_mod","options":{"a":null}})", "option \"a\"");
  expect_refused(R"({"type":"options","method":"atm_mod","options":[]})", "no object");
}

TEST(ClientMessage, MethodIsAddedUnderAnIdOfItsOwn) {
  const auto plain = parsed<MethodAdd>(R"({"type":"method_add","method":"carve"})");
  EXPECT_FALSE(plain.name);
  EXPECT_FALSE(plain.options);
  const auto second =
      parsed<MethodAdd>(R"({"type":"method_add","method":"carve-2","name":"carve","options":{"guard_m":0.1}})");
  EXPECT_EQ(second.method, "carve-2");
  EXPECT_EQ(second.name, "carve");
  EXPECT_EQ(second.options, (OptionMap{{"guard_m", 0.1}}));
  expect_refused(R"({"type":"method_add","method":"a","name":1})", "\"name\"");
  expect_refused(R"({"type":"method_add","method":"a","options":[]})", "no object");
  expect_refused(R"({"type":"method_add","name":"carve"})", "has no \"method\"");
}

TEST(ClientMessage, ExplainsAPointOrAPlace) {
  EXPECT_EQ(parsed<Explain>(R"({"type":"explain","id":1,"method":"consensus","slot":9})").slot, 9U);
  EXPECT_EQ(parsed<Explain>(R"({"type":"explain","id":1,"method":"evidence","x":1,"y":2})").y_m, 2.0);
  expect_refused(R"({"type":"explain","id":1,"method":"evidence"})", "either");
  expect_refused(R"({"type":"explain","id":1,"method":"evidence","slot":9,"x":1,"y":2})", "either");
  expect_refused(R"({"type":"explain","method":"evidence","slot":9})", "\"id\"");
}

TEST(ClientMessage, QuestionsWithinTheirBounds) {
  EXPECT_EQ(parsed<StepMessage>(R"({"type":"step","id":2,"method":"evidence","ping":4294967295})").ping,
            4'294'967'295U);
  expect_refused(R"({"type":"step","id":2,"method":"evidence","ping":4294967296})", "\"ping\"");
  expect_refused(R"({"type":"step","id":0,"method":"evidence","ping":1})", "\"id\"");
  expect_refused(R"({"type":"step","id":2.5,"method":"evidence","ping":1})", "\"id\"");
  expect_refused(R"({"type":"step","id":2,"method":"evidence","ping":-1})", "\"ping\"");
  EXPECT_EQ(parsed<PingsMessage>(R"({"type":"pings","id":3,"from":0,"count":10000})").count, 10'000U);
  expect_refused(R"({"type":"pings","id":3,"from":0,"count":10001})", "\"count\"");
  EXPECT_EQ(parsed<Snapshot>(R"({"type":"snapshot","id":4,"t":12.5,"methods":["a","b"]})").time_s, 12.5);
}

TEST(ClientMessage, SmallOnes) {
  (void)parsed<Stop>(R"({"type":"stop"})");
  (void)parsed<Take>(R"({"type":"take"})");
  EXPECT_FALSE(parsed<Release>(R"({"type":"release"})").to);
  EXPECT_EQ(parsed<Release>(R"({"type":"release","to":3})").to, 3U);
  EXPECT_TRUE(parsed<Answer>(R"({"type":"answer","accept":true})").accept);
  EXPECT_EQ(parsed<PingMessage>(R"({"type":"ping","id":11})").id, 11U);
  EXPECT_EQ(parsed<MethodAdd>(R"({"type":"method_add","method":"sequential"})").method, "sequential");
  EXPECT_EQ(parsed<MethodRemove>(R"({"type":"method_remove","method":"sequential"})").method, "sequential");
  EXPECT_FALSE(parsed<SensorMessage>(R"({"type":"sensor","sensor":2,"on":false})").on);
  EXPECT_EQ(parsed<Playback>(R"({"type":"playback","speed":4})").speed, 4.0);
  EXPECT_EQ(parsed<OpenScene>(R"({"type":"open","id":5,"scene":"corridor"})").scene, "corridor");
  EXPECT_TRUE(parsed<Subscribe>(R"({"type":"subscribe","methods":[]})").methods.empty());
}

TEST(ClientMessage, WhatIsNoMessageIsRefused) {
  for (const std::string_view text : std::array<std::string_view, 9>{
           "", " ", "null", "[]", "17", "{", R"({"type":"stop"} {"type":"stop"})", "\xff\xfe", R"("stop")"})
    expect_refused(text, "no JSON object");
  expect_refused("{}", "no \"type\"");
  expect_refused(R"({"type":1})", "no \"type\"");
  expect_refused(R"({"type":"shutdown"})", "not known");
  expect_refused(R"({"type":"stop","force":true})", "unknown key \"force\"");
}

TEST(ClientMessage, LengthAndDepthAreLimited) {
  const std::string longest = R"({"type":"subscribe","methods":[]})";
  (void)parsed<Subscribe>(longest + std::string(max_message_bytes - longest.size(), ' '));
  expect_refused(longest + std::string(max_message_bytes - longest.size() + 1, ' '), "longer than");
  expect_refused(std::string(max_message_bytes, '['), "no JSON object");
  std::string nested = R"({"type":"subscribe","methods":)";
  for (int i = 0; i < 2000; ++i) nested += "[";
  for (int i = 0; i < 2000; ++i) nested += "]";
  expect_refused(nested + "}", "no JSON object");
  expect_refused(R"({"type":"method_add","method":")" + std::string(65, 'a') + "\"}", "\"method\"");
  std::string many = R"({"type":"subscribe","methods":["a")";
  for (int i = 0; i < 32; ++i) many += R"(,"a")";
  expect_refused(many + "]}", "\"methods\"");
}

TEST(ClientMessage, RefusalCarriesTheIdWhereThereIsOne) {
  EXPECT_EQ(id_of(R"({"type":"nonsense","id":42})"), 42U);
  EXPECT_FALSE(id_of(R"({"type":"nonsense"})"));
  EXPECT_FALSE(id_of(R"({"id":-1})"));
  EXPECT_FALSE(id_of(R"({"id":0})"));
  EXPECT_FALSE(id_of(R"({"id":4294967296})"));
  EXPECT_FALSE(id_of(R"({"id":"42"})"));
  EXPECT_FALSE(id_of("garbage"));
}

}  // namespace
}  // namespace echoarc::server
