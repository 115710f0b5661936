// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// A robot that finds its way by itself, as those who watch it see it.

#include <algorithm>

#include "server/room.hpp"
#include "server/strategy_modes.hpp"
#include "support/temp_folder.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

const std::vector<live::MethodChoice> choices{{"evidence", {}}};

Vec2 position_in(const Value& state) {
  return {state["pose"][0].get<double>(), state["pose"][1].get<double>()};
}

class Strategies : public RoomTest {
 protected:
  bool drives_by(const FakeViewer& viewer, const std::string& strategy) {
    return run_until_state(viewer, [&](const Value& state) {
      return state["mode"] == strategy && state["strategy"] == strategy && state["v"] != 0.0;
    });
  }
  bool plans_by(const FakeViewer& viewer, const std::string& strategy) {
    return io.run_until(
        [&] { return viewer.last("plan") != nullptr && (*viewer.last("plan"))["strategy"] == strategy; });
  }
  bool ends(const FakeViewer& viewer, const std::string& reason) {
    return run_until_state(viewer,
                           [&](const Value& state) { return state["mode"] == "stand" && state["reason"] == reason; });
  }
};

TEST_F(Strategies, EveryOneIsAnnouncedAndDrives) {
  open(exploring_room(choices, executor, 4.0));
  const std::vector<std::string> modes = room->modes();
  for (const std::string_view mode : strategy_modes()) EXPECT_NE(std::ranges::find(modes, mode), modes.end()) << mode;
  FakeViewer viewer(*room, 1);
  for (const char* mode : {"frontier", "gvg", "wall-left", "wall-right"}) {
    viewer.say(ModeMessage{mode, {}, {}});
    EXPECT_TRUE(drives_by(viewer, mode)) << mode;
    EXPECT_FALSE((*viewer.last("state"))["detail"].get<std::string>().empty()) << mode;
    EXPECT_TRUE(plans_by(viewer, mode)) << mode;
    EXPECT_EQ(viewer.last("error"), nullptr) << mode;
  }
  viewer.say(Stop{});
  EXPECT_TRUE(ends(viewer, "stopped"));
  EXPECT_TRUE(plans_by(viewer, "")) << "who stands plans nothing";
}

TEST_F(Strategies, WithoutNavigationNoneIsAnnounced) {
  open(scene_room(choices, executor));
  EXPECT_EQ(room->modes(), (std::vector<std::string>{"goto", "stand", "drive"}));
  {
    FakeViewer viewer(*room, 1);
    viewer.say(ModeMessage{"frontier", {}, {}});
    EXPECT_NE(viewer.last("error"), nullptr);
  }
  room.reset();
  open(log_room(choices, executor, 1.0));
  EXPECT_TRUE(room->modes().empty());
}

TEST_F(Strategies, StartingOneNeedsTheSameRightAsAnyMode) {
  open(exploring_room(choices, executor, 1.0));
  FakeViewer watcher(*room, 1, false);
  watcher.say(ModeMessage{"frontier", {}, {}});
  ASSERT_NE(watcher.last("error"), nullptr);
  FakeViewer driver(*room, 2);
  FakeViewer other(*room, 3);
  driver.say(Take{});
  other.say(ModeMessage{"home", {}, {}});
  EXPECT_NE(other.last("error"), nullptr) << "somebody else drives";
  for (const ModeMessage& message : {ModeMessage{"goto", {}, {}}, ModeMessage{"manual-script", {}, {}}}) {
    driver.forget();
    driver.say(message);
    EXPECT_NE(driver.last("error"), nullptr) << message.mode;
  }
}

TEST_F(Strategies, GoesToAPointByAPlanAndBackHome) {
  open(exploring_room(choices, executor, 8.0));
  FakeViewer viewer(*room, 1);
  viewer.say(ModeMessage{"goto", 4.5, 1.0});
  ASSERT_TRUE(drives_by(viewer, "goto"));
  EXPECT_EQ((*viewer.last("state"))["goal"], Value::array({4.5, 1.0}));
  ASSERT_TRUE(io.run_until([&] { return viewer.last("plan") && !(*viewer.last("plan"))["path"].empty(); }));
  EXPECT_EQ((*viewer.last("plan"))["nodes"][0], Value::parse(R"({"at":[4.5,1.0],"kind":"goal"})"));
  ASSERT_TRUE(ends(viewer, "finished")) << (*viewer.last("state")).dump();
  EXPECT_LT(norm(position_in(*viewer.last("state")) - Vec2{4.5, 1.0}), 0.3);
  EXPECT_EQ((*viewer.last("state"))["strategy"], "goto") << "that ended";
  EXPECT_FALSE((*viewer.last("state"))["detail"].get<std::string>().empty());
  viewer.say(ModeMessage{"home", {}, {}});
  ASSERT_TRUE(drives_by(viewer, "home"));
  EXPECT_TRUE((*viewer.last("state"))["goal"].is_array());
  ASSERT_TRUE(ends(viewer, "finished")) << (*viewer.last("state")).dump();
  EXPECT_LT(norm(position_in(*viewer.last("state")) - Vec2{1.0, 2.0}), 0.3);
}

TEST_F(Strategies, GoalThatCannotBeReachedIsGivenUpWithAReason) {
  open(exploring_room(choices, executor, 8.0));
  FakeViewer viewer(*room, 1);
  viewer.say(ModeMessage{"goto", 9.0, 2.0});  // behind the wall
  ASSERT_TRUE(ends(viewer, "failed"));
  EXPECT_FALSE((*viewer.last("state"))["detail"].get<std::string>().empty());
  EXPECT_TRUE(plans_by(viewer, ""));
}

TEST_F(Strategies, GoesOnWhenEverybodyLeavesUnlessAttended) {
  for (const bool attended : {false, true}) {
    RoomSetup setup = exploring_room(choices, executor, 8.0);
    setup.attended = attended;
    open(std::move(setup));
    {
      FakeViewer viewer(*room, 1);
      viewer.say(ModeMessage{"frontier", {}, {}});
      ASSERT_TRUE(drives_by(viewer, "frontier"));
    }
    {
      FakeViewer late(*room, 2);
      ASSERT_TRUE(run_until_state(late, [&](const Value& state) {
        return attended ? state["reason"] == "dead man" && state["v"] == 0.0 : state["mode"] == "frontier";
      }));
      EXPECT_TRUE(attended || plans_by(late, "frontier")) << "who comes later is told the plan, too";
    }
    room.reset();
  }
}

TEST_F(Strategies, SlowViewerGetsTheNewestPlanAlone) {
  open(exploring_room(choices, executor, 4.0));
  FakeViewer fast(*room, 1);
  FakeViewer slow(*room, 2);
  ASSERT_TRUE(run_until_heard(slow, "history"));
  slow.slow = true;
  fast.say(ModeMessage{"frontier", {}, {}});
  ASSERT_TRUE(io.run_until([&] { return fast.count("plan") >= 4; }));
  slow.forget();
  slow.slow = false;
  slow.offer();
  EXPECT_EQ(slow.count("plan"), 1U);
  EXPECT_EQ(*slow.last("plan"), *fast.last("plan"));
}

TEST_F(Strategies, PlansComeAtMostTwiceASecond) {
  open(exploring_room(choices, executor, 4.0));
  FakeViewer viewer(*room, 1);
  viewer.say(ModeMessage{"frontier", {}, {}});
  ASSERT_TRUE(plans_by(viewer, "frontier"));
  const std::size_t plans = viewer.count("plan");
  const std::size_t states = viewer.count("state");
  ASSERT_TRUE(io.run_until([&] { return viewer.count("state") >= states + 20; }));
  EXPECT_LE(viewer.count("plan") - plans, (viewer.count("state") - states) / ControlLoop::ticks_per_plan + 1);
}

TEST_F(Strategies, SessionLogNamesTheMode) {
  const echoarc::test::TempFolder folder;
  RoomSetup setup = exploring_room(choices, executor, 1.0);
  Log header;
  header.robot = setup.source->description().robot;
  setup.log = std::make_unique<SessionWriter>(io::SessionLog::create(folder.path(), header).value());
  open(std::move(setup));
  {
    FakeViewer viewer(*room, 1);
    viewer.say(ModeMessage{"wall-left", {}, {}});
    ASSERT_TRUE(drives_by(viewer, "wall-left"));
  }
  room.reset();
  std::vector<std::string> modes;
  const auto read = io::read_session(folder.path(), [&](const io::SessionLine& line) {
    const auto* other = std::get_if<io::OtherLine>(&line);
    if (other == nullptr) return;
    const Value said = Value::parse(other->json);
    if (said["type"] == "command") modes.push_back(said["mode"]);
  });
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NE(std::ranges::find(modes, "wall-left"), modes.end());
}

}  // namespace
}  // namespace echoarc::server::test
