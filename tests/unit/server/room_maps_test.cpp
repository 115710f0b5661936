// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Whoever watches, however slowly, and whatever is changed meanwhile, ends with the same maps.

#include <set>

#include "unit/live/mapper_fixture.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

const std::vector<live::MethodChoice> choices{{"evidence", {}}, {"atm_mod", {}}, {"carve", {}}};

class RoomMaps : public RoomTest {
 protected:
  /// What a page must hold by now.
  PageMaps newest() {
    return with_mapper([](MappingLoop::Access& access) {
      (void)access.mapper.refresh();
      PageMaps page;
      page.pings.resize(64 * access.mapper.readings().size());
      std::vector<std::string> names;
      for (const live::RunningMethod& method : access.mapper.methods()) names.push_back(method.choice.name);
      page.take_methods(names);
      for (std::size_t i = 0; i < names.size(); ++i) {
        const live::MapStore& store = access.mapper.methods()[i].store;
        FrameHead head{.method = static_cast<std::uint8_t>(i)};
        head.kind = FrameKind::tiles;
        if (const SharedFrame tiles = encode_tiles(head, store, 0)) page.take(*tiles);
        head.kind = FrameKind::points;
        if (const SharedFrame points = encode_points(head, store, 0)) page.take(*points);
      }
      return page;
    });
  }
  bool settled() {
    return with_mapper([](MappingLoop::Access& access) {
      return std::ranges::all_of(access.mapper.methods(), [](const live::RunningMethod& method) {
        return method.state == live::RunningMethod::State::ok && method.map;
      });
    });
  }
  void run_until_it_has_ended(const FakeViewer& viewer) {
    ASSERT_TRUE(run_until_state(viewer, [](const Value& state) { return state["reason"] == "end of log"; }));
    ASSERT_TRUE(io.run_until([&] { return settled(); }));
  }
  bool comes_to_hold_the_newest(const FakeViewer& viewer) {
    return io.run_until([&] {
      const PageMaps wanted = newest();
      return viewer.page.methods == wanted.methods && viewer.page.maps == wanted.maps &&
             viewer.page.pings.size() == wanted.pings.size();
    });
  }
  /// Lets a viewer be slow and quick by turns.
  bool run_with_pauses(FakeViewer& viewer, const std::function<bool()>& done) {
    int turn = 0;
    return io.run_until([&] {
      viewer.slow = ++turn % 40 != 0;
      return done();
    });
  }
};

TEST_F(RoomMaps, ViewerThatSkipsStatesHoldsTheSameMapsAsOneThatTakesEach) {
  open(log_room(choices, executor, 8.0));
  FakeViewer quick(*room, 1);
  FakeViewer seldom(*room, 2);
  const auto ended = [&] {
    const Value* state = quick.last("state");
    return state != nullptr && (*state)["reason"] == "end of log";
  };
  ASSERT_TRUE(run_with_pauses(seldom, ended));
  EXPECT_GT(seldom.dropped, quick.dropped + 10);
  seldom.slow = false;
  run_until_it_has_ended(quick);
  EXPECT_TRUE(comes_to_hold_the_newest(quick));
  EXPECT_TRUE(comes_to_hold_the_newest(seldom));
  FakeViewer newcomer(*room, 3);
  EXPECT_TRUE(comes_to_hold_the_newest(newcomer));
  EXPECT_FALSE(quick.page.maps["evidence"].tiles.empty());
  EXPECT_FALSE(quick.page.maps["atm_mod"].points.empty());
  EXPECT_EQ(quick.page.pings, seldom.page.pings);
  EXPECT_EQ(quick.page.pings, newcomer.page.pings) << "the drive is shorter than a minute";
  EXPECT_EQ(quick.page.path, newcomer.page.path);
  EXPECT_EQ(quick.page.path, seldom.page.path);
  EXPECT_FALSE(quick.page.path.empty());
}

TEST_F(RoomMaps, ChangedMethodsReachEverybody) {
  open(log_room(choices, executor, 8.0));
  FakeViewer quick(*room, 1);
  FakeViewer seldom(*room, 2);
  ASSERT_TRUE(run_until_state(quick, [](const Value& state) { return state["t"] > 3.0; }));
  seldom.slow = true;
  quick.say(OptionsMessage{"atm_mod", {}});
  quick.say(MethodRemove{"evidence"});
  quick.say(MethodAdd{"vt"});
  quick.say(MethodAdd{"evidence"});  // comes back with another place in the list
  ASSERT_TRUE(run_until_state(quick, [](const Value& state) { return state["t"] > 8.0; }));
  seldom.slow = false;
  quick.say(MethodRemove{"carve"});
  quick.say(SensorMessage{3, false});
  run_until_it_has_ended(quick);
  EXPECT_TRUE(comes_to_hold_the_newest(quick));
  EXPECT_TRUE(comes_to_hold_the_newest(seldom));
  EXPECT_EQ(quick.page.methods, (std::vector<std::string>{"atm_mod", "vt", "evidence"}));
  EXPECT_FALSE(seldom.page.maps["evidence"].tiles.empty());
  EXPECT_EQ(quick.last("error"), nullptr);
}

TEST_F(RoomMaps, MethodThatComesBackAtOnceIsSentAnew) {
  open(log_room({{"evidence", {}}}, executor, 20.0));
  FakeViewer viewer(*room, 1);
  run_until_it_has_ended(viewer);
  ASSERT_TRUE(comes_to_hold_the_newest(viewer));
  const auto before = viewer.page.maps["evidence"];
  viewer.say(MethodRemove{"evidence"});
  viewer.say(MethodAdd{"evidence"});
  viewer.say(OptionsMessage{"evidence", {{"cell_m", 0.2}}});
  ASSERT_TRUE(io.run_until([&] { return settled(); }));
  EXPECT_TRUE(comes_to_hold_the_newest(viewer));
  EXPECT_FALSE(viewer.page.maps["evidence"] == before);
}

TEST_F(RoomMaps, SubscriberGetsNoOtherMaps) {
  open(log_room(choices, executor, 20.0));
  FakeViewer viewer(*room, 1);
  viewer.say(Subscribe{{"carve"}});
  run_until_it_has_ended(viewer);
  const auto holds = [&](const std::string& method) {
    return io.run_until([&] { return viewer.page.maps[method] == newest().maps[method]; });
  };
  EXPECT_TRUE(holds("carve"));
  EXPECT_TRUE(viewer.page.maps["evidence"].tiles.empty());
  EXPECT_TRUE(viewer.page.maps["atm_mod"].points.empty());
  viewer.say(Subscribe{{"carve", "evidence"}});
  EXPECT_TRUE(holds("evidence")) << "what was not sent before is sent now";
  EXPECT_FALSE(viewer.page.maps["evidence"].tiles.empty());
}

TEST_F(RoomMaps, SeekingThereAndBackGivesTheMapOfPlainPlaying) {
  open(log_room(choices, executor, 30.0));
  FakeViewer viewer(*room, 1);
  const double end_s = short_drive().odometry.back().time_s;
  const auto seek = [&](double time_s) {
    viewer.say(Playback{.playing = false, .seek_s = time_s});
    ASSERT_TRUE(run_until_state(viewer, [&](const Value& state) {
      return state["playing"] == false && std::abs(state["t"].get<double>() - time_s) < 1e-6;
    })) << time_s;
  };
  for (const double share : {0.5, 0.2, 0.9, 0.0, 0.4}) seek(share * end_s);
  viewer.say(Playback{.playing = true, .speed = 100.0});
  run_until_it_has_ended(viewer);
  const live::test::Played played = live::test::play(short_drive());
  live::Mapper plain = live::Mapper::make(played.description, {}, choices, executor).value();
  for (const live::Record& record : played.records) plain.push(record);
  for (const live::MethodChoice& choice : choices) {
    const auto same = with_mapper([&](MappingLoop::Access& access) {
      const auto sought = access.mapper.final_map(choice.name);
      const auto wanted = plain.final_map(choice.name);
      return sought && wanted && wanted->points.size() > 10 && live::test::same_map(*sought, *wanted);
    });
    EXPECT_TRUE(same) << choice.name;
  }
  EXPECT_TRUE(comes_to_hold_the_newest(viewer));
  const auto readings = with_mapper([](MappingLoop::Access& access) { return access.mapper.readings().size(); });
  EXPECT_EQ(viewer.page.pings.size(), 64 * readings) << "what was before the jump is forgotten";
}

}  // namespace
}  // namespace echoarc::server::test
