// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/room_maker.hpp"

#include "support/temp_folder.hpp"
#include "unit/live/mapper_fixture.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

using echoarc::test::contents;
using echoarc::test::put;
using echoarc::test::TempFolder;

const MappingChoice mapping{{{"evidence", {{"cell_m", 0.08}}}, {"atm_mod", {}}}, {}};

SceneRoom plain(const std::filesystem::path& session) {
  SceneRoom room;
  room.scene = live::plain_room();
  room.scene_name = "plain";
  room.seed = 5;
  room.session = session;
  return room;
}

class Sessions : public RoomTest {
 protected:
  /// Lets a robot drive for some time, changes the maps on the way and ends it; its maps are left in `maps`.
  void record(const std::filesystem::path& session) {
    open(make_scene_room(plain(session), mapping, executor).value());
    FakeViewer viewer(*room, 1);
    viewer.say(ModeMessage{"goto", 4.0, 2.0});
    ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["t"] > 1.5; }));
    viewer.say(MethodAdd{"carve"});
    viewer.say(OptionsMessage{"evidence", {{"cell_m", 0.16}}});
    viewer.say(SensorMessage{3, false});
    viewer.say(MethodRemove{"atm_mod"});
    ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["t"] > 3.0; }));
    room->end_control();
    maps = with_mapper([](MappingLoop::Access& access) {
      while (access.mapper.work(10'000)) {
      }
      return final_maps(access.mapper);
    });
  }
  static std::map<std::string, MapExport> final_maps(const live::Mapper& mapper) {
    std::map<std::string, MapExport> maps;
    for (const live::RunningMethod& method : mapper.methods())
      maps[method.choice.name] = mapper.final_map(method.choice.name).value();
    return maps;
  }
  struct Recorded {
    std::vector<live::Record> records;
    Odometry last_pose;
    Odometry last_truth;
  };
  static Recorded recorded(const std::filesystem::path& session) {
    Recorded all;
    const auto read = io::read_session(session, [&](const io::SessionLine& line) {
      if (const auto record = record_of(line)) all.records.push_back(*record);
      if (const auto* pose = std::get_if<Odometry>(&line)) all.last_pose = *pose;
      if (const auto* truth = std::get_if<io::TruthLine>(&line)) all.last_truth = truth->pose;
    });
    EXPECT_TRUE(read) << read.error().message;
    return all;
  }

  std::map<std::string, MapExport> maps;
  const TempFolder folder;
};

TEST_F(Sessions, SaysWhatItWasStartedWith) {
  SceneRoom wanted = plain(folder.path());
  wanted.speed = 2.0;
  {
    (void)make_scene_room(wanted, mapping, executor).value();
  }
  const Result<SessionStart> start = read_session_start(folder.path());
  ASSERT_TRUE(start) << start.error().message;
  EXPECT_EQ(start->scene, "plain");
  EXPECT_EQ(start->seed, 5U);
  EXPECT_EQ(start->speed, 2.0);
  ASSERT_EQ(start->mapping.methods.size(), 2U);
  EXPECT_EQ(start->mapping.methods[0].name, "evidence");
  EXPECT_EQ(start->mapping.methods[0].options, mapping.methods[0].options);
  EXPECT_EQ(option_values(start->mapping.sensing), option_values(SensingOptions{}));
}

TEST_F(Sessions, GoesOnWhereItEndedWithTheSameMaps) {
  record(folder.path());
  room.reset();
  const Recorded before = recorded(folder.path());
  ASSERT_GT(before.records.size(), 100U);
  // As if it had been killed in the middle of a line.
  put(folder / "session.jsonl", contents(folder / "session.jsonl") + R"({"type":"ping","t":3.)");
  RoomSetup setup = resume_scene_room(plain(folder.path()), mapping, executor).value();
  const std::map<std::string, MapExport> resumed = final_maps(setup.mapper);
  ASSERT_EQ(resumed.size(), 2U);
  for (const auto& [method, map] : maps) {
    ASSERT_TRUE(resumed.contains(method)) << method;
    EXPECT_GT(map.points.size(), 5U) << method;
    EXPECT_TRUE(live::test::same_map(map, resumed.at(method))) << method;
  }
  EXPECT_EQ(setup.mapper.sensors_off(), std::set<SensorId>{3});
  EXPECT_GT(setup.source->time_s(), before.last_truth.time_s);
  EXPECT_LT(setup.source->time_s(), before.last_truth.time_s + 1.0);
  EXPECT_LT(norm(setup.source->drivable()->T_world_base().position - before.last_pose.T_world_robot.position), 1e-6);
  EXPECT_FALSE(setup.starts_tour) << "it stands until somebody starts it";
  ASSERT_TRUE(setup.navigation && setup.navigation->home);
  EXPECT_LT(norm(*setup.navigation->home - Vec2{1.0, 2.0}), 1e-6) << "where the session began, not where it goes on";
  open(std::move(setup));
  {
    FakeViewer viewer(*room, 1);
    ASSERT_TRUE(
        run_until_state(viewer, [&](const Value& state) { return state["t"] > before.last_truth.time_s + 1.0; }));
  }
  room.reset();
  const Recorded after = recorded(folder.path());
  ASSERT_GT(after.records.size(), before.records.size() + 20);
  double newest_s = 0.0;
  for (const live::Record& record : after.records)
    if (const auto* pose = std::get_if<Odometry>(&record)) {
      EXPECT_GE(pose->time_s, newest_s);
      newest_s = pose->time_s;
    }
  EXPECT_LT(norm(after.last_pose.T_world_robot.position - before.last_pose.T_world_robot.position), 0.01)
      << "it stands where it stood";
}

TEST_F(Sessions, OtherRobotsAndOtherLogsAreRefused) {
  {
    (void)make_scene_room(plain(folder / "session"), mapping, executor).value();
  }
  SceneRoom other = plain(folder / "session");
  other.scene.robot.radius_m = 0.3;
  const auto resumed = resume_scene_room(std::move(other), mapping, executor);
  ASSERT_FALSE(resumed);
  EXPECT_EQ(resumed.error().code, ErrorCode::bad_format);
  EXPECT_FALSE(resume_scene_room(plain(folder / "none"), mapping, executor));
  EXPECT_FALSE(make_scene_room(plain(folder / "session"), mapping, executor)) << "a session lies there";
  EXPECT_FALSE(read_session_start(folder / "none"));
  Log header;
  header.robot = live::plain_room().robot;
  {
    io::SessionLog::create(folder / "plain", header)
        .value()
        .write("{\"type\":\"odom\",\"t\":0,\"x\":0,\"y\":0,\"yaw\":0}\n");
  }
  EXPECT_FALSE(read_session_start(folder / "plain")) << "nobody says what it was started with";
}

TEST_F(Sessions, DamagedSetupsHarmNobody) {
  {
    (void)make_scene_room(plain(folder.path()), mapping, executor).value();
  }
  const std::string sound = contents(folder / "session.jsonl");
  for (const char* line :
       {R"({"type":"setup","add":7})", R"({"type":"setup","add":"unheard_of"})", R"({"type":"setup","remove":[]})",
        R"({"type":"setup","options":{"cell_m":0.2}})", R"({"type":"setup","method":"evidence","options":3})",
        R"({"type":"setup","method":"evidence","options":{"cell_m":{}}})", R"({"type":"setup","on":true})",
        R"({"type":"setup","sensor":-1,"on":true})", R"({"type":"setup","sensor":99999,"on":"yes"})"}) {
    put(folder / "session.jsonl", sound + line + "\n");
    const auto resumed = resume_scene_room(plain(folder.path()), mapping, executor);
    ASSERT_TRUE(resumed) << line << resumed.error().message;
    EXPECT_EQ(resumed->mapper.methods().size(), 2U) << line;
    EXPECT_TRUE(resumed->mapper.sensors_off().empty()) << line;
  }
  const std::string header = sound.substr(0, sound.find('\n') + 1);
  for (const char* line : {R"({"type":"setup","scene":7,"seed":"a","speed":[],"methods":{},"sensing":1})",
                           R"({"type":"setup","scene":"plain","methods":[1,{"name":2,"options":"x"}]})",
                           R"({"type":"setup","scene":"plain","seed":-4})"}) {
    put(folder / "session.jsonl", header + line + "\n");
    const auto start = read_session_start(folder.path());
    ASSERT_TRUE(start) << line;
    EXPECT_EQ(start->seed, 1U);
  }
}

TEST_F(Sessions, LogIsPlayedAtItsSpeed) {
  RoomSetup setup = make_log_room("room-1", short_drive(), 4.0, mapping, executor).value();
  EXPECT_EQ(setup.name, "room-1");
  EXPECT_EQ(setup.kind, "log");
  EXPECT_EQ(setup.speed, 4.0);
  EXPECT_EQ(setup.log, nullptr);
  EXPECT_FALSE(make_log_room("room-2", Log(), 1.0, mapping, executor)) << "nothing to play";
  EXPECT_FALSE(make_log_room("room-3", short_drive(), 1.0, {{{"unheard_of", {}}}, {}}, executor));
}

}  // namespace
}  // namespace echoarc::server::test
