// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What the server writes holds to schema/messages.schema.json.

#include <limits>

#include "server/map_messages.hpp"
#include "server/mapping_loop.hpp"
#include "server/room_messages.hpp"
#include "unit/live/mapper_fixture.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

Value good(const std::string& text) {
  const Value message = Value::parse(text, nullptr, false);
  EXPECT_EQ(message_schema().message_fault("FromServer", message), "") << text.substr(0, 600);
  return message;
}

/// The short drive, mapped by some methods.
struct Mapped {
  explicit Mapped(const std::vector<live::MethodChoice>& methods)
      : played(live::test::play(short_drive())),
        mapper(live::Mapper::make(played.description, {}, methods, executor).value()),
        scores(played.description) {
    for (const live::Record& record : played.records) {
      mapper.push(record);
      scores.push(record);
    }
    mapper.end_of_records();
    (void)mapper.refresh();
  }
  InlineExecutor executor;
  live::test::Played played;
  live::Mapper mapper;
  live::ScoreKeeper scores;
};
std::vector<live::MethodChoice> all_methods() {
  std::vector<live::MethodChoice> methods;
  for (const MethodEntry& entry : catalog()) methods.push_back({std::string(entry.name), {}});
  return methods;
}

TEST(MessageSchema, StateOfEveryKind) {
  RobotStatus status;
  DrivingRights rights;
  Value message = good(state_message(status, rights, 0, std::nullopt, 0));
  EXPECT_TRUE(message["driver"].is_null());
  EXPECT_TRUE(message["drive_seq"].is_null());
  EXPECT_TRUE(message["drive_mono_us"].is_null());
  EXPECT_TRUE(message["true_pose"].is_null());
  (void)rights.take(3, 0.0);
  status.T_world_robot = status.T_world_true = Pose2{{1.0, 2.0}, radians(0.5)};
  status.control.goal = Vec2{3.0, 4.0};
  status.control.free_ahead_m = std::numeric_limits<double>::infinity();
  status.control.limited_by_obstacle = true;
  status.drive_seq = 8;
  status.drive_us = 1234;
  for (const live::Mode mode : {live::Mode::stand, live::Mode::drive, live::Mode::tour, live::Mode::go_to}) {
    status.control.mode = mode;
    message = good(state_message(status, rights, 2, StopNote{"viewer", 3, "Ann"}, 5));
    EXPECT_EQ(message["mode"], live::mode_name(status.control));
  }
  EXPECT_EQ(message["true_pose"], Value::array({1.0, 2.0, 0.5}));
  EXPECT_EQ(message["driver"], 3);
  EXPECT_TRUE(message["free_ahead_m"].is_null()) << "JSON has no infinity";
  EXPECT_EQ(message["limited_by"], "obstacle");
  status.control.mode = live::Mode::navigate;
  status.control.strategy = "wall-left";
  status.control.detail = "around a corner";
  message = good(state_message(status, rights, 2, std::nullopt, 5));
  EXPECT_EQ(message["mode"], "wall-left");
  EXPECT_EQ(message["detail"], "around a corner");
  status.control.mode = live::Mode::stand;
  status.control.reason = live::Reason::failed;
  message = good(state_message(status, rights, 2, std::nullopt, 5));
  EXPECT_EQ(message["mode"], "stand");
  EXPECT_EQ(message["strategy"], "wall-left") << "that ended";
  EXPECT_EQ(message["reason"], "failed");
  status.control.reason = live::Reason::stopped;
  for (const char* who : {"viewer", "obstacle", "dead_man", "host"})
    message = good(state_message(status, rights, 2, StopNote{who, std::nullopt, ""}, 5));
  EXPECT_EQ(message["limited_by"], "stop");
  status.ended = true;
  EXPECT_EQ(good(state_message(status, rights, 2, std::nullopt, 5))["reason"], "end of log");
  status.broken = "the cable is loose";
  EXPECT_EQ(good(state_message(status, rights, 2, std::nullopt, 5))["reason"], "the cable is loose");
}

TEST(MessageSchema, SmallMessages) {
  using enum ErrorCode;
  for (const ErrorCode code :
       {not_found, unreadable, unwritable, bad_format, bad_value, unsupported, too_large, interrupted})
    for (const std::optional<MessageId> id : {std::optional<MessageId>(), std::optional<MessageId>(4'294'967'295U)})
      (void)good(error_message(id, {code, "what \"it\" \xff was", "where", "do\nthis"}));
  for (const char* reason : {"handed_over", "dead_man", "kept"}) (void)good(drive_lost_message(reason));
  (void)good(pong_message(1));
  (void)good(opened_message(2, "room-1"));
  (void)good(pings_end_message(3));
  EXPECT_TRUE(good(snapshot_end_message(4, 1.5, 0, std::nullopt))["pose"].is_null());
  EXPECT_EQ(good(snapshot_end_message(4, 1.5, 7, Pose2{{1.0, 2.0}, {}}))["pose"].size(), 3U);
}

TEST(MessageSchema, MapsOfEveryMethod) {
  Mapped mapped(all_methods());
  const Value methods = good(methods_message(mapped.mapper));
  ASSERT_EQ(methods["running"].size(), catalog().size());
  for (const live::RunningMethod& method : mapped.mapper.methods()) (void)good(recompute_message(method));
  const Value scores = good(scores_message(mapped.scores.update(mapped.mapper)));
  EXPECT_EQ(scores["methods"].size(), catalog().size());
  const std::string open = counters_message(mapped.mapper, R"({"state":"full","bytes":12,"message":"no space"})");
  const Value counters = good(open + "0}");
  EXPECT_EQ(counters["pings"], short_drive().pings.size());
  EXPECT_EQ(counters["log"]["state"], "full");
  std::uint64_t of_sensors = 0;
  for (const Value& sensor : counters["sensors"]) of_sensors += sensor["echoes"].get<std::uint64_t>();
  EXPECT_EQ(of_sensors, counters["echoes"]);
  const Value history = good(history_message(mapped.mapper, mapped.scores));
  EXPECT_EQ(history["scores"].size(), catalog().size());
  EXPECT_EQ(history["scores"][0]["t"].size(), 1U);
}

TEST(MessageSchema, TimelineBeginsWhereItChanged) {
  const std::vector<live::TimelineBin> before{{1, 2, 3}, {4, 5, 6}};
  std::vector<live::TimelineBin> now = before;
  now[1].rejected = 7;
  now.push_back({8, 9, 10});
  Value message = good(timeline_message(before, now));
  EXPECT_EQ(message["first"], 1);
  EXPECT_EQ(message["echoes"], Value::array({4, 8}));
  EXPECT_EQ(message["no_echoes"], Value::array({5, 9}));
  EXPECT_EQ(message["rejected"], Value::array({7, 10}));
  message = good(timeline_message(before, before));
  EXPECT_EQ(message["first"], 2);
  EXPECT_TRUE(message["echoes"].empty());
  EXPECT_EQ(good(timeline_message({}, before))["first"], 0);
  EXPECT_EQ(good(timeline_message(before, {}))["first"], 0);
}

TEST(MessageSchema, AnswersAboutEveryMethod) {
  const Mapped mapped(all_methods());
  const live::Evidence evidence = MappingLoop::evidence_of(mapped.mapper, mapped.played.description);
  const std::size_t middle = evidence.readings.size() / 2;
  for (const live::RunningMethod& method : mapped.mapper.methods()) {
    const std::string& name = method.choice.name;
    ASSERT_TRUE(method.map) << name;
    if (method.point_method) {
      ASSERT_GT(method.map->points.size(), 0U) << name;
      const auto why = live::explain_point(evidence, name, method.map->points.size() / 2);
      ASSERT_TRUE(why) << name << ": " << why.error().message;
      const Value explained = good(explanation_message(1, 7, *why));
      EXPECT_EQ(explained["kind"], "point");
      EXPECT_EQ(explained["slot"], 7);
    }
    const auto cell = live::explain_cell(evidence, name, {3.0, 2.0});
    if (cell) {
      const Value explained = good(explanation_message(2, std::nullopt, *cell));
      EXPECT_EQ(explained["kind"], "cell") << name;
      EXPECT_TRUE(explained["slot"].is_null());
    }
    for (std::size_t k = middle; k < middle + 40; k += 13) {
      const auto step = live::step_ping(evidence, name, evidence.readings[k].reading.ping);
      ASSERT_TRUE(step) << name << ": " << step.error().message;
      const Value stepped = good(stepped_message(3, *step, 293.0));
      EXPECT_EQ(stepped["method"], name);
      EXPECT_NEAR(stepped["speed_of_sound_m_s"], 343.0, 1.0);
    }
  }
}

}  // namespace
}  // namespace echoarc::server::test
