// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

class Questions : public RoomTest {
 protected:
  /// A room whose log has been played to its end.
  void SetUp() override {
    open(log_room({{"evidence", {}}, {"atm_mod", {}}, {"consensus", {}}}, executor, 100.0));
    viewer = std::make_unique<FakeViewer>(*room, 1, false);
    ASSERT_TRUE(run_until_state(*viewer, [](const Value& state) { return state["reason"] == "end of log"; }));
    ASSERT_TRUE(io.run_until([&] {
      return !viewer->page.maps["consensus"].points.empty() && !viewer->page.maps["evidence"].tiles.empty();
    }));
  }
  void TearDown() override { viewer.reset(); }
  const Value& answer(const ClientMessage& question, const std::string& type) {
    static const Value none;
    viewer->forget();
    viewer->say(question);
    EXPECT_TRUE(run_until_heard(*viewer, type)) << (viewer->last("error") ? viewer->last("error")->dump() : "nothing");
    return viewer->last(type) != nullptr ? *viewer->last(type) : none;
  }
  [[nodiscard]] static std::uint32_t records(const SharedFrame& frame) {
    return number_at<std::uint32_t>(frame->bytes, 4);
  }
  [[nodiscard]] static std::uint8_t kind(const SharedFrame& frame) { return number_at<std::uint8_t>(frame->bytes, 0); }

  std::unique_ptr<FakeViewer> viewer;
};

TEST_F(Questions, WhyAPointIsThere) {
  const auto& points = viewer->page.maps["consensus"].points;
  const auto [slot, bytes] = *points.begin();
  const Value said = answer(Explain{.id = 5, .method = "consensus", .slot = slot}, "explanation");
  EXPECT_EQ(said["id"], 5);
  EXPECT_EQ(said["kind"], "point");
  EXPECT_FALSE(said["sentence"].get<std::string>().empty());
  EXPECT_NEAR(said["x"], number_at<float>(bytes, 0), 1e-5);
  EXPECT_NEAR(said["y"], number_at<float>(bytes, 4), 1e-5);
}

TEST_F(Questions, WhyACellHoldsWhatItHolds) {
  const Value said = answer(Explain{.id = 6, .method = "evidence", .x_m = 3.0, .y_m = 2.0}, "explanation");
  EXPECT_EQ(said["kind"], "cell");
  ASSERT_TRUE(said["cell"].is_object());
  EXPECT_GT(said["cell"]["changes"].size(), 0U) << "the robot drove through";
  EXPECT_LT(said["cell"]["probability"], 0.5);
}

TEST_F(Questions, WhatAPingChanged) {
  const auto first_echo = with_mapper([](MappingLoop::Access& access) {
    const live::ReadingLog& readings = access.mapper.readings();
    for (std::size_t i = readings.size() / 2; i < readings.size(); ++i)
      if (echo_range_m(readings[i].reading.outcome)) return readings[i].reading.ping;
    return PingId{0};
  });
  for (const char* method : {"evidence", "atm_mod"}) {
    const Value said = answer(StepMessage{8, method, static_cast<std::uint32_t>(first_echo)}, "stepped");
    EXPECT_EQ(said["id"], 8);
    EXPECT_EQ(said["ping"]["ping"], first_echo);
    EXPECT_EQ(said["used"], true);
    ASSERT_FALSE(viewer->answers.empty()) << "the map before it";
    for (const SharedFrame& frame : viewer->answers) EXPECT_EQ(number_at<std::uint32_t>(frame->bytes, 12), 8U);
  }
}

TEST_F(Questions, PingsById) {
  (void)answer(PingsMessage{9, 100, 50}, "pings_end");
  ASSERT_EQ(viewer->answers.size(), 1U);
  const std::string& bytes = viewer->answers[0]->bytes;
  EXPECT_EQ(kind(viewer->answers[0]), 1);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 12), 9U);
  EXPECT_EQ(records(viewer->answers[0]), 50U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 16 + 8), 100U);
  (void)answer(PingsMessage{10, 4'000'000'000U, 50}, "pings_end");
  ASSERT_EQ(viewer->answers.size(), 1U);
  EXPECT_EQ(records(viewer->answers[0]), 0U) << "there are none so far";
}

TEST_F(Questions, MapsOfThePast) {
  const Value said = answer(Snapshot{11, 5.0, {"consensus", "evidence"}}, "snapshot_end");
  EXPECT_EQ(said["id"], 11);
  const std::size_t all = viewer->page.pings.size() / 64;
  EXPECT_GT(said["pings"], 0);
  EXPECT_LT(said["pings"], all);
  ASSERT_TRUE(said["pose"].is_array());
  std::uint32_t tiles = 0;
  for (const SharedFrame& frame : viewer->answers) tiles += kind(frame) == 2 ? records(frame) : 0;
  EXPECT_GT(tiles, 0U);
  const Value before = answer(Snapshot{12, -10.0, {"evidence"}}, "snapshot_end");
  EXPECT_EQ(before["pings"], 0);
}

TEST_F(Questions, WhatCannotBeAnsweredIsRefusedWithItsId) {
  for (const ClientMessage& question :
       {ClientMessage(Explain{.id = 20, .method = "nonsense", .slot = 1}),
        ClientMessage(Explain{.id = 20, .method = "nonsense", .x_m = 1.0, .y_m = 1.0}),
        ClientMessage(Explain{.id = 20, .method = "consensus", .slot = 4'000'000'000U}),
        ClientMessage(StepMessage{20, "evidence", 4'000'000'000U}), ClientMessage(StepMessage{20, "nonsense", 0}),
        ClientMessage(Snapshot{20, 1.0, {"nonsense"}}), ClientMessage(OpenScene{20, "demo"})}) {
    const Value said = answer(question, "error");
    EXPECT_EQ(said["id"], 20);
    EXPECT_FALSE(said["message"].get<std::string>().empty());
    EXPECT_FALSE(said["remedy"].get<std::string>().empty()) << said["message"];
  }
}

}  // namespace
}  // namespace echoarc::server::test
