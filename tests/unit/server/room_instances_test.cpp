// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// One method several times over, as viewers, session logs and answers tell them apart.

#include "server/json_values.hpp"
#include "server/room_maker.hpp"
#include "server/room_messages.hpp"
#include "support/temp_folder.hpp"
#include "unit/live/mapper_fixture.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

using echoarc::test::TempFolder;

const OptionMap no_test{{"consistency_test", false}, {"geometry_test", false}};

class Instances : public RoomTest {
 protected:
  bool run_until_running(const FakeViewer& viewer, const std::vector<std::string>& ids) {
    return io.run_until([&] { return viewer.page.methods == ids; });
  }
};

TEST_F(Instances, AreToldWithIdNameAndLabel) {
  open(log_room({{"numakura", {}}}, executor, 100.0));
  FakeViewer viewer(*room, 1);
  viewer.say(MethodAdd{"numakura-no-test", "numakura", no_test});
  ASSERT_TRUE(run_until_running(viewer, {"numakura", "numakura-no-test"}));
  const Value running = (*viewer.last("methods"))["running"];
  EXPECT_EQ(running[0]["name"], "numakura");
  EXPECT_EQ(running[0]["label"], "Numakura");
  EXPECT_EQ(running[1]["name"], "numakura");
  EXPECT_EQ(running[1]["label"], "Numakura no test");
  EXPECT_EQ(running[1]["options"]["geometry_test"], false);
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["reason"] == "end of log"; }));
  ASSERT_TRUE(io.run_until([&] {
    return !viewer.page.maps["numakura"].tiles.empty() && !viewer.page.maps["numakura-no-test"].tiles.empty();
  }));
  ASSERT_TRUE(io.run_until([&] { return viewer.last("scores") && (*viewer.last("scores"))["methods"].size() == 2; }));
  EXPECT_EQ((*viewer.last("scores"))["methods"][1]["method"], "numakura-no-test");
}

TEST_F(Instances, LabelsSayWhatTheIdSays) {
  EXPECT_EQ(label_of({"carve", {}}), "Arc carving");
  EXPECT_EQ(label_of({"carve", {}, "carve"}), "Arc carving");
  EXPECT_EQ(label_of({"carve", {}, "carve-2"}), "Arc carving 2");
  EXPECT_EQ(label_of({"carve", {}, "carve_default"}), "Arc carving default");
  EXPECT_EQ(label_of({"carve", {}, "mine"}), "Arc carving: mine");
  EXPECT_EQ(label_of({"carve", {}, "carve-"}), "Arc carving: carve ");
}

TEST_F(Instances, RefusalsOfIdsReachWhoAsked) {
  open(scene_room({{"vt", {}}}, executor));
  FakeViewer viewer(*room, 1);
  viewer.say(MethodAdd{"vt"});
  viewer.say(MethodAdd{"../vt", "vt"});
  viewer.say(MethodAdd{"dm", "vt"});
  viewer.say(MethodAdd{"vt-2"});
  ASSERT_TRUE(io.run_until([&] { return viewer.count("error") == 4; }));
  EXPECT_EQ(viewer.page.methods.size(), 1U);
}

/// Frames of an answer say by their place in the question which method they are of, whatever else runs by then.
TEST_F(Instances, AnswersAreOfTheMethodsThatWereAskedAbout) {
  open(log_room({{"centerline", {}}, {"evidence", {}}, {"carve", {}}}, executor, 100.0));
  FakeViewer viewer(*room, 1);
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["reason"] == "end of log"; }));
  viewer.say(MethodRemove{"centerline"});
  viewer.say(Snapshot{5, 1e6, {"carve", "evidence"}});
  ASSERT_TRUE(run_until_heard(viewer, "snapshot_end"));
  std::set<std::pair<int, int>> kinds;
  for (const SharedFrame& frame : viewer.answers)
    if (number_at<std::uint32_t>(frame->bytes, 4) > 0)
      kinds.emplace(number_at<std::uint8_t>(frame->bytes, 1), number_at<std::uint8_t>(frame->bytes, 0));
  EXPECT_EQ(kinds, (std::set<std::pair<int, int>>{{0, 3}, {1, 2}})) << "points of the first, tiles of the second";
  viewer.forget();
  viewer.say(StepMessage{6, "evidence", 200});
  ASSERT_TRUE(run_until_heard(viewer, "stepped"));
  EXPECT_TRUE((*viewer.last("stepped"))["true_pose"].is_array());
  ASSERT_FALSE(viewer.answers.empty());
  for (const SharedFrame& frame : viewer.answers) EXPECT_EQ(number_at<std::uint8_t>(frame->bytes, 1), 0);
}

SceneRoom plain(const std::filesystem::path& session) {
  SceneRoom room;
  room.scene = live::plain_room();
  room.scene_name = "plain";
  room.speed = 8.0;
  room.session = session;
  return room;
}

TEST_F(Instances, AreResumedWithIdsAndOptions) {
  const TempFolder folder;
  const MappingChoice mapping{{{"carve", {}}, {"carve", {{"guard_m", 0.05}}, "careful"}}, {}};
  open(make_scene_room(plain(folder.path()), mapping, executor).value());
  {
    FakeViewer viewer(*room, 1);
    viewer.say(ModeMessage{"goto", 4.0, 2.0});
    viewer.say(MethodAdd{"numakura-2", "numakura", no_test});
    viewer.say(MethodAdd{"vt"});
    viewer.say(OptionsMessage{"careful", {{"guard_m", 0.1}}});
    ASSERT_TRUE(run_until_running(viewer, {"carve", "careful", "numakura-2", "vt"}));
    ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["t"] > 1.0; }));
  }
  room.reset();
  const Result<SessionStart> start = read_session_start(folder.path());
  ASSERT_TRUE(start);
  ASSERT_EQ(start->mapping.methods.size(), 2U);
  EXPECT_EQ(start->mapping.methods[0].key(), "carve");
  EXPECT_EQ(start->mapping.methods[1].key(), "careful");
  EXPECT_EQ(start->mapping.methods[1].name, "carve");
  const RoomSetup setup = resume_scene_room(plain(folder.path()), start->mapping, executor).value();
  const auto methods = setup.mapper.methods();
  ASSERT_EQ(methods.size(), 4U);
  EXPECT_EQ(methods[1].id(), "careful");
  EXPECT_EQ(methods[1].options.at("guard_m"), OptionValue(0.1));
  EXPECT_EQ(methods[2].id(), "numakura-2");
  EXPECT_EQ(methods[2].choice.name, "numakura");
  EXPECT_EQ(methods[2].choice.options, no_test);
  EXPECT_EQ(methods[3].id(), "vt");
}

TEST_F(Instances, PlanOfASceneIsToldWhereOneIsKnown) {
  const double interval_s = live::plain_room().sonar.interval_s;
  open(make_scene_room(plain({}), {}, executor).value());
  FakeViewer viewer(*room, 1);
  const ServerFacts facts{"0.1.0", "session", {}, 1000};
  Value welcome = Value::parse(welcome_message(facts, *room, viewer));
  EXPECT_NEAR(welcome["robot"]["sensors"][3]["rate_hz"], 1.0 / (16 * interval_s), 1e-9);
  viewer.leave();
  SceneRoom all = plain({});
  all.scene.sonar.listening = sim::Listening::all;
  open(make_scene_room(all, {}, executor).value());
  FakeViewer second(*room, 2);
  welcome = Value::parse(welcome_message(facts, *room, second));
  EXPECT_NEAR(welcome["robot"]["sensors"][3]["rate_hz"], 1.0 / interval_s, 1e-9) << "each hears every firing";
  second.leave();
  open(log_room({}, executor, 1.0));
  FakeViewer third(*room, 3);
  EXPECT_TRUE(Value::parse(welcome_message(facts, *room, third))["robot"]["sensors"][3]["rate_hz"].is_null());
}

/// Its last pings wait for odometry that does not come.
TEST_F(Instances, PingsThatWaitAreDecidedAtTheEndOfALog) {
  Log log = short_drive();
  const double last_s = log.pings.back().time_s;
  std::erase_if(log.odometry, [&](const Odometry& pose) { return pose.time_s > last_s - 1.0; });
  RoomSetup setup = furnished("log", live::ReplaySource::make(log).value(), {{"evidence", {}}}, executor);
  setup.speed = 100.0;
  open(std::move(setup));
  FakeViewer viewer(*room, 1);
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["reason"] == "end of log"; }));
  const auto waiting = [&] {
    return with_mapper([](MappingLoop::Access& access) { return access.mapper.report().waiting; });
  };
  EXPECT_EQ(waiting(), 0U);
  EXPECT_EQ(with_mapper([](MappingLoop::Access& access) { return access.mapper.readings().size(); }), log.pings.size());
  // It is played again: those of the new run wait anew, and are decided at its end.
  viewer.say(Playback{.seek_s = 2.0});
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["reason"] != "end of log"; }));
  viewer.forget();
  ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["reason"] == "end of log"; }));
  EXPECT_EQ(waiting(), 0U);
}

}  // namespace
}  // namespace echoarc::server::test
