// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/mapping_loop.hpp"

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>

#include "unit/live/mapper_fixture.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

const std::vector<live::MethodChoice> choices{{"evidence", {}}, {"atm_mod", {}}};

/// A loop over the records of the short drive, and what it published.
class Mapping : public testing::Test {
 protected:
  Mapping()
      : played(live::test::play(short_drive())),
        loop(live::Mapper::make(played.description, {}, choices, executor).value(),
             live::ScoreKeeper(played.description),
             {[this](SharedPublication publication) {
                {
                  const std::lock_guard lock(mutex);
                  publications.push_back(std::move(publication));
                }
                wake.notify_all();
              },
              [] { return std::string(R"({"state":"off","bytes":0,"message":""})"); }}) {}

  void add(std::size_t begin, std::size_t end) {
    const auto first = played.records.begin();
    loop.add({first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end)});
  }
  void add_all() { add(0, played.records.size()); }
  template <class Wanted>
  SharedPublication wait(const Wanted& wanted) {
    std::unique_lock lock(mutex);
    const bool came = wake.wait_for(lock, std::chrono::seconds(60),
                                    [&] { return !publications.empty() && wanted(*publications.back()); });
    EXPECT_TRUE(came);
    return publications.empty() ? std::make_shared<Publication>() : publications.back();
  }
  /// When all records are mapped, and the maps of all of them are published.
  SharedPublication wait_for_all() {
    std::promise<std::pair<std::size_t, std::uint64_t>> mapped;
    loop.post([&](MappingLoop::Access& access) {
      access.changed = true;
      const std::lock_guard lock(mutex);
      mapped.set_value({access.mapper.readings().size(), publications.empty() ? 0 : publications.back()->second});
    });
    const auto [readings, second] = mapped.get_future().get();
    return wait([&](const Publication& p) { return p.readings.size() == readings && p.second > second; });
  }

  InlineExecutor executor;
  live::test::Played played;
  std::mutex mutex;
  std::condition_variable wake;
  std::vector<SharedPublication> publications;
  MappingLoop loop;
};

TEST_F(Mapping, PublishesTheMethodsBeforeTheFirstRecord) {
  const SharedPublication first = wait([](const Publication&) { return true; });
  ASSERT_TRUE(first->methods);
  const Value methods = Value::parse(first->methods->bytes);
  EXPECT_EQ(message_schema().message_fault("FromServer", methods), "");
  EXPECT_EQ(methods["running"].size(), 2U);
  EXPECT_GT(first->methods_version, 0U);
  EXPECT_EQ(first->readings.size(), 0U);
  EXPECT_EQ(first->laser, nullptr);
}

TEST_F(Mapping, DeltasFollowEachOtherWithoutAGap) {
  for (std::size_t begin = 0; begin < played.records.size(); begin += 1000) {
    add(begin, std::min(begin + 1000, played.records.size()));
    (void)wait_for_all();
  }
  const std::lock_guard lock(mutex);
  std::map<std::string, std::uint32_t> at;
  std::map<std::string, MapDelta> newest;
  for (const SharedPublication& publication : publications)
    for (const MapDelta& delta : publication->deltas) {
      const MapDelta& before = newest[delta.method];
      if (delta.tiles == before.tiles && delta.points == before.points && delta.to == before.to) continue;  // still due
      EXPECT_EQ(delta.from, at[delta.method]) << delta.method;
      if (delta.tiles || delta.points)
        EXPECT_GT(delta.to, delta.from);
      else
        EXPECT_EQ(delta.to, delta.from) << "looked at again, and nothing was new";
      at[delta.method] = delta.to;
      newest[delta.method] = delta;
    }
  EXPECT_GT(at["evidence"], 1U);
  EXPECT_GT(at["atm_mod"], 1U);
}

TEST_F(Mapping, PathIsThinnedAndWhole) {
  add_all();
  const SharedPublication last = wait_for_all();
  const std::vector<Vec2>& path = *last->path;
  ASSERT_GT(path.size(), 10U);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_GE(norm(path[i] - path[i - 1]), 0.02);
  EXPECT_EQ(path.front(), short_drive().odometry.front().T_world_robot.position);
  EXPECT_LT(norm(path.back() - short_drive().odometry.back().T_world_robot.position), 0.03);
}

TEST_F(Mapping, RestartBeginsAnotherRun) {
  add_all();
  const SharedPublication before = wait_for_all();
  const std::size_t readings = before->readings.size();
  ASSERT_GT(readings, 100U);
  loop.restart();
  add(0, 500);
  const SharedPublication after = wait([&](const Publication& p) { return p.run > before->run; });
  EXPECT_EQ(after->run, before->run + 1);
  EXPECT_LT(after->readings.size(), 500U);
  EXPECT_LT(after->path->size(), before->path->size());
  EXPECT_EQ(before->readings.size(), readings) << "copies stay as they were";
}

TEST_F(Mapping, RecordsThatWaitedAreForgottenByARestart) {
  add_all();
  loop.restart();
  const SharedPublication after = wait([](const Publication& p) { return p.run == 2; });
  EXPECT_EQ(after->readings.size(), 0U);
}

TEST_F(Mapping, CatchUpIsWhatManyDeltasAre) {
  add(0, played.records.size() / 2);
  (void)wait_for_all();
  PageMaps page;
  page.take_methods({"evidence", "atm_mod"});
  std::map<std::string, std::uint32_t> since;
  const auto catch_up = [&] {
    std::promise<MappingLoop::CatchUp> caught;
    loop.catch_up({{"evidence", since["evidence"]}, {"atm_mod", since["atm_mod"]}, {"unheard_of", 7}},
                  [&](MappingLoop::CatchUp answer) { caught.set_value(std::move(answer)); });
    const MappingLoop::CatchUp answer = caught.get_future().get();
    EXPECT_EQ(answer.deltas.size(), 2U);
    EXPECT_TRUE(answer.methods);
    for (const MapDelta& delta : answer.deltas) {
      EXPECT_EQ(delta.from, since[delta.method]);
      since[delta.method] = delta.to;
      for (const SharedFrame& frame : {delta.tiles, delta.points})
        if (frame) page.take(*frame);
    }
  };
  catch_up();
  const PageMaps half = page;
  EXPECT_FALSE(half.maps.at("evidence").tiles.empty());
  add(played.records.size() / 2, played.records.size());
  (void)wait_for_all();
  catch_up();
  EXPECT_FALSE(page.maps == half.maps);
  const PageMaps in_two_steps = page;
  page = PageMaps();
  page.take_methods({"evidence", "atm_mod"});
  since.clear();
  catch_up();
  EXPECT_EQ(page.maps, in_two_steps.maps);
}

TEST_F(Mapping, TellsEverySecondWhatItCounted) {
  add_all();
  const SharedPublication mapped = wait_for_all();
  const SharedPublication later = wait([&](const Publication& p) { return p.second > mapped->second; });
  const Value counters = Value::parse(later->counters + "3}");
  EXPECT_EQ(message_schema().message_fault("FromServer", counters), "");
  EXPECT_EQ(counters["pings"], short_drive().pings.size());
  EXPECT_EQ(counters["sensors"].size(), 16U);
  EXPECT_EQ(counters["dropped"], 3);
  for (const SharedFrame& frame : {later->scores, later->timeline}) {
    ASSERT_TRUE(frame);
    EXPECT_EQ(message_schema().message_fault("FromServer", Value::parse(frame->bytes)), "") << frame->bytes;
  }
}

TEST_F(Mapping, ChangedMethodsGetAnotherVersion) {
  const SharedPublication before = wait([](const Publication&) { return true; });
  loop.post([](MappingLoop::Access& access) {
    EXPECT_TRUE(access.mapper.add_method({"vt", {}}));
    access.changed = true;
  });
  const SharedPublication after =
      wait([&](const Publication& p) { return p.methods_version > before->methods_version; });
  EXPECT_EQ(after->deltas.size(), 3U);
  EXPECT_EQ(Value::parse(after->methods->bytes)["running"][2]["method"], "vt");
}

TEST_F(Mapping, IsCrowdedByWhatWaits) {
  std::promise<void> begun;
  std::promise<void> go_on;
  loop.post([&](MappingLoop::Access&) {
    begun.set_value();
    go_on.get_future().wait();
  });
  begun.get_future().wait();
  EXPECT_FALSE(loop.crowded());
  loop.add(std::vector<live::Record>(30'000, live::CommandNote{}));
  EXPECT_TRUE(loop.crowded());
  go_on.set_value();
  (void)wait_for_all();
  EXPECT_FALSE(loop.crowded());
}

}  // namespace
}  // namespace echoarc::server::test
