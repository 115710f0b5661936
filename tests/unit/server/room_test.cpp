// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/room.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "server/room_messages.hpp"
#include "support/temp_folder.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

const std::vector<live::MethodChoice> choices{{"evidence", {}}, {"consensus", {}}};

class Rooms : public RoomTest {
 protected:
  void drive_until_it_moves(FakeViewer& driver) {
    std::uint32_t seq = 0;
    ASSERT_TRUE(io.run_until([&] {
      driver.say(DriveMessage{0.2, 0.0, ++seq});
      const Value* state = driver.last("state");
      return state != nullptr && (*state)["v"] > 0.05;
    }));
    EXPECT_EQ((*driver.last("state"))["mode"], "drive");
    EXPECT_TRUE((*driver.last("state"))["drive_seq"].is_number());
    EXPECT_LE((*driver.last("state"))["drive_seq"], seq);
  }
  bool comes_to_stand(const FakeViewer& viewer, const std::string& reason) {
    return run_until_state(viewer, [&](const Value& state) { return state["v"] == 0.0 && state["reason"] == reason; });
  }
  /// After everything said so far was heard by the robot.
  void let_ticks_pass(const FakeViewer& viewer, int ticks) {
    const std::size_t enough = viewer.count("state") + static_cast<std::size_t>(ticks);
    ASSERT_TRUE(io.run_until([&] { return viewer.count("state") >= enough; }));
  }
};

TEST_F(Rooms, WelcomeHoldsToTheSchema) {
  for (RoomSetup& setup : [&] {
         std::vector<RoomSetup> setups;
         setups.push_back(scene_room(choices, executor));
         setups.push_back(log_room(choices, executor, 1.0));
         return setups;
       }()) {
    open(std::move(setup));
    FakeViewer viewer(*room, 7);
    const ServerFacts facts{"0.1.0", "session", {{"demo", "A room"}}, 1000};
    const Value message = Value::parse(welcome_message(facts, *room, viewer));
    EXPECT_EQ(message_schema().message_fault("FromServer", message), "");
    EXPECT_EQ(message["you"]["viewer"], 7);
    EXPECT_EQ(message["robot"]["sensors"].size(), 16U);
    EXPECT_EQ(message["source"]["drivable"], room->kind() == "scene");
    EXPECT_EQ(message["modes"].empty(), room->kind() == "log");
    viewer.leave();
    room.reset();
  }
}

TEST_F(Rooms, NewcomerIsToldTheHistoryAndWhoElseIsThere) {
  open(scene_room(choices, executor));
  FakeViewer first(*room, 1);
  ASSERT_TRUE(run_until_heard(first, "history"));
  FakeViewer second(*room, 2);
  ASSERT_TRUE(run_until_heard(second, "viewers"));
  EXPECT_EQ((*second.last("viewers"))["viewers"].size(), 2U);
  EXPECT_NE(second.last("history"), nullptr);
  for (const char* type : {"state", "methods", "counters", "scores", "timeline"})
    EXPECT_TRUE(run_until_heard(second, type)) << type;
  EXPECT_EQ((*second.last("state"))["watchers"], 2);
  second.leave();
  ASSERT_TRUE(io.run_until([&] { return (*first.last("viewers"))["viewers"].size() == 1; }));
}

TEST_F(Rooms, DriverDrivesAndStandsWhenTheHandIsOff) {
  open(scene_room(choices, executor));
  FakeViewer driver(*room, 1);
  driver.say(Take{});
  drive_until_it_moves(driver);
  EXPECT_EQ((*driver.last("state"))["driver"], 1);
  EXPECT_TRUE(comes_to_stand(driver, "dead man"));
  ASSERT_TRUE(run_until_heard(driver, "drive_lost"));
  EXPECT_EQ((*driver.last("drive_lost"))["reason"], "dead_man");
  EXPECT_EQ((*driver.last("state"))["stopped_by"]["who"], "dead_man");
}

TEST_F(Rooms, NextDriverKeepsTheRightThoughTheOneBeforeWasLost) {
  open(scene_room(choices, executor));
  FakeViewer lost(*room, 1);
  FakeViewer next(*room, 2);
  lost.say(Take{});
  drive_until_it_moves(lost);
  next.say(Take{});
  lost.leave();
  EXPECT_TRUE(comes_to_stand(next, "dead man"));
  let_ticks_pass(next, 3);
  EXPECT_EQ((*next.last("state"))["driver"], 2) << "it asked, and did not drive yet";
  EXPECT_EQ(next.last("drive_lost"), nullptr);
  drive_until_it_moves(next);
}

TEST_F(Rooms, RobotBrakesAtOnceWhenItsDriverLeaves) {
  open(scene_room(choices, executor));
  FakeViewer watcher(*room, 2);
  // The dead-man would do it, too, but not before its time; a busy machine may take as long once or twice.
  bool at_once = false;
  for (int attempt = 0; attempt < 6 && !at_once; ++attempt) {
    {
      FakeViewer driver(*room, 1);
      driver.say(Take{});
      drive_until_it_moves(driver);
    }
    ASSERT_TRUE(run_until_state(watcher, [](const Value& state) { return state["reason"] == "dead man"; }));
    const Value& state = *watcher.last("state");
    at_once = state["mono_us"].get<double>() - state["drive_mono_us"].get<double>() < 500e3;
    EXPECT_TRUE(comes_to_stand(watcher, "dead man"));
    EXPECT_TRUE((*watcher.last("state"))["driver"].is_null());
  }
  EXPECT_TRUE(at_once);
}

TEST_F(Rooms, WhoStoppedItIsNotForgottenOverAStateFromBefore) {
  open(scene_room(choices, executor));
  FakeViewer viewer(*room, 1);
  viewer.say(ModeMessage{"goto", 5.0, 2.0});
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["v"] > 0.05; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(250));  // a state lies in the mailbox now
  viewer.say(Stop{});
  EXPECT_TRUE(comes_to_stand(viewer, "stopped"));
  EXPECT_EQ((*viewer.last("state"))["stopped_by"]["who"], "viewer");
  EXPECT_EQ((*viewer.last("state"))["stopped_by"]["name"], "viewer 1");
}

TEST_F(Rooms, AnybodyMayStopIt) {
  open(scene_room(choices, executor));
  FakeViewer driver(*room, 1);
  FakeViewer watcher(*room, 2, false);
  driver.say(Take{});
  drive_until_it_moves(driver);
  watcher.say(Stop{});
  EXPECT_TRUE(comes_to_stand(driver, "stopped"));
  EXPECT_EQ((*driver.last("state"))["stopped_by"]["who"], "viewer");
  EXPECT_EQ((*driver.last("state"))["stopped_by"]["viewer"], 2);
  EXPECT_EQ((*driver.last("state"))["limited_by"], "stop");
  EXPECT_EQ(watcher.last("error"), nullptr);
}

TEST_F(Rooms, WithoutTheTokenNothingElseIsDone) {
  open(scene_room(choices, executor));
  FakeViewer watcher(*room, 1, false);
  for (const ClientMessage& message :
       {ClientMessage(Take{}), ClientMessage(DriveMessage{1.0, 0.0, 1}), ClientMessage(ModeMessage{"stand", {}, {}}),
        ClientMessage(MethodAdd{"vt"}), ClientMessage(MethodRemove{"evidence"}),
        ClientMessage(OptionsMessage{"evidence", {}}), ClientMessage(SensorMessage{0, false}),
        ClientMessage(Playback{.playing = false})}) {
    watcher.forget();
    watcher.say(message);
    ASSERT_NE(watcher.last("error"), nullptr) << message.index();
    EXPECT_NE((*watcher.last("error"))["message"].get<std::string>().find("token"), std::string::npos);
  }
  ASSERT_TRUE(run_until_heard(watcher, "state"));
  let_ticks_pass(watcher, 3);
  EXPECT_TRUE((*watcher.last("state"))["driver"].is_null());
  EXPECT_EQ((*watcher.last("state"))["mode"], "stand");
  EXPECT_EQ(with_mapper([](MappingLoop::Access& access) { return access.mapper.methods().size(); }), choices.size());
}

TEST_F(Rooms, DriverIsAskedAndHandsOver) {
  open(scene_room(choices, executor));
  FakeViewer driver(*room, 1);
  FakeViewer asking(*room, 2);
  FakeViewer third(*room, 3);
  driver.say(Take{});
  asking.say(DriveMessage{0.2, 0.0, 1});
  ASSERT_NE(asking.last("error"), nullptr) << "who does not drive is told so";
  asking.say(Take{});
  ASSERT_NE(driver.last("drive_request"), nullptr);
  EXPECT_EQ((*driver.last("drive_request"))["viewer"], 2);
  third.say(Take{});
  EXPECT_NE(third.last("error"), nullptr);
  driver.say(Answer{false});
  ASSERT_NE(asking.last("drive_lost"), nullptr);
  EXPECT_EQ((*asking.last("drive_lost"))["reason"], "kept");
  asking.say(Take{});
  driver.say(Answer{true});
  ASSERT_NE(driver.last("drive_lost"), nullptr);
  EXPECT_EQ((*driver.last("drive_lost"))["reason"], "handed_over");
  drive_until_it_moves(asking);
  EXPECT_EQ((*asking.last("state"))["driver"], 2);
  asking.say(Release{3});
  ASSERT_TRUE(run_until_state(third, [](const Value& state) { return state["driver"] == 3; }));
  third.forget();
  third.say(Release{99});
  EXPECT_NE(third.last("error"), nullptr) << "nobody has that number";
  third.say(Release{});
  EXPECT_TRUE(run_until_state(third, [](const Value& state) { return state["driver"].is_null(); }));
}

TEST_F(Rooms, ModesAreStartedByWhoMay) {
  open(scene_room(choices, executor));
  FakeViewer viewer(*room, 1);
  FakeViewer other(*room, 2);
  for (const ModeMessage& message : {ModeMessage{"drive", {}, {}}, ModeMessage{"fly", {}, {}},
                                     ModeMessage{"goto", {}, {}}, ModeMessage{"tour", {}, {}}}) {
    viewer.forget();
    viewer.say(message);
    EXPECT_NE(viewer.last("error"), nullptr) << message.mode;
  }
  viewer.say(ModeMessage{"goto", 2.0, 2.0});
  EXPECT_TRUE(run_until_state(viewer, [](const Value& state) {
    return state["mode"] == "goto" && state["v"] > 0.05 && state["goal"] == Value::array({2.0, 2.0});
  }));
  other.say(Take{});
  viewer.forget();
  viewer.say(ModeMessage{"stand", {}, {}});
  EXPECT_NE(viewer.last("error"), nullptr) << "somebody else drives";
  other.say(ModeMessage{"stand", {}, {}});
  EXPECT_TRUE(run_until_state(other, [](const Value& state) { return state["mode"] == "stand"; }));
}

TEST_F(Rooms, AttendedRobotStandsWhenNobodyWatches) {
  RoomSetup setup = scene_room(choices, executor);
  setup.attended = true;
  open(std::move(setup));
  {
    FakeViewer viewer(*room, 1);
    viewer.say(ModeMessage{"goto", 5.0, 2.0});
    ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["v"] > 0.05; }));
  }
  FakeViewer late(*room, 2);
  EXPECT_TRUE(comes_to_stand(late, "dead man"));
}

TEST_F(Rooms, LogIsPlayedAndNotDriven) {
  open(log_room(choices, executor, 1.0));
  FakeViewer viewer(*room, 1);
  viewer.say(Take{});
  ASSERT_NE(viewer.last("error"), nullptr);
  viewer.say(Playback{.playing = false, .speed = 4.0});
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["playing"] == false; }));
  EXPECT_EQ((*viewer.last("state"))["speed"], 4.0);
  const Value held = (*viewer.last("state"))["t"];
  let_ticks_pass(viewer, 4);
  EXPECT_EQ((*viewer.last("state"))["t"], held);
  viewer.say(Playback{.playing = true});
  EXPECT_TRUE(run_until_state(viewer, [&](const Value& state) { return state["t"] > held; }));
}

TEST_F(Rooms, RunningRobotIsNotPlayed) {
  open(scene_room(choices, executor));
  FakeViewer viewer(*room, 1);
  viewer.say(Playback{.playing = false});
  EXPECT_NE(viewer.last("error"), nullptr);
  viewer.say(PingMessage{12});
  ASSERT_NE(viewer.last("pong"), nullptr);
  EXPECT_EQ((*viewer.last("pong"))["id"], 12);
}

TEST_F(Rooms, ChangesOfTheMapsAreKeptInTheSessionLog) {
  const echoarc::test::TempFolder folder;
  Log header;
  RoomSetup setup = scene_room(choices, executor);
  header.robot = setup.source->description().robot;
  setup.log = std::make_unique<SessionWriter>(io::SessionLog::create(folder.path(), header).value());
  open(std::move(setup));
  {
    FakeViewer viewer(*room, 1);
    viewer.say(MethodAdd{"vt"});
    viewer.say(OptionsMessage{"vt", {{"threshold", std::int64_t{7}}}});
    viewer.say(OptionsMessage{"vt", {{"threshold", std::int64_t{-7}}}});
    viewer.say(SensorMessage{3, false});
    viewer.say(MethodRemove{"consensus"});
    viewer.say(MethodRemove{"consensus"});
    ASSERT_TRUE(io.run_until([&] { return viewer.count("error") == 2; }));
    ASSERT_TRUE(run_until_heard(viewer, "counters"));
    EXPECT_EQ((*viewer.last("counters"))["log"]["state"], "on");
    ASSERT_TRUE(io.run_until([&] {
      const Value* methods = viewer.last("methods");
      return methods != nullptr && (*methods)["running"].size() == 2 && (*methods)["running"][1]["method"] == "vt" &&
             (*methods)["running"][1]["options"]["threshold"] == 7;
    }));
    let_ticks_pass(viewer, 5);
  }
  room.reset();
  std::vector<std::string> setups;
  std::size_t records = 0;
  const auto read = io::read_session(folder.path(), [&](const io::SessionLine& line) {
    const auto* other = std::get_if<io::OtherLine>(&line);
    if (other == nullptr)
      ++records;
    else if (Value::parse(other->json)["type"] == "setup")
      setups.push_back(other->json);
  });
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_GT(records, 10U);
  EXPECT_EQ(setups, (std::vector<std::string>{
                        R"({"type":"setup","add":"vt"})", R"({"type":"setup","method":"vt","options":{"threshold":7}})",
                        R"({"type":"setup","sensor":3,"on":false})", R"({"type":"setup","remove":"consensus"})"}))
      << "what was refused is not kept";
}

}  // namespace
}  // namespace echoarc::server::test
