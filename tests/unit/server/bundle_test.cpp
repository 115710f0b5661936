// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/bundle.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::server {
namespace {

class QuietViewer final : public Viewer {
 public:
  void offer() override {}
  void send(std::string) override {}
  void send(std::vector<SharedFrame>) override {}
  void dismiss(std::string_view) override {}
};

SharedFrame text(std::string bytes) {
  return std::make_shared<const Frame>(Frame{std::move(bytes), false});
}

/// Publications as a mapping loop makes them, with frames that can be told apart.
class Bundles : public testing::Test {
 protected:
  Bundles() { greeted.cursor.greeted = true; }

  void append_pings(int count) {
    for (int i = 0; i < count; ++i) {
      live::JudgedPing ping;
      ping.reading.ping = readings.size();
      ping.reading.time_s = 0.05 * static_cast<double>(readings.size());
      readings.append(ping);
    }
  }
  std::shared_ptr<Publication> publication() {
    auto made = std::make_shared<Publication>();
    made->readings = readings;
    made->path = std::make_shared<std::vector<Vec2>>(path);
    made->run = run;
    made->methods_version = 1;
    made->methods = text("methods");
    made->second = 1;
    made->counters = R"({"type":"counters","dropped":)";
    return made;
  }
  std::vector<SharedFrame> take(Viewer& viewer) {
    behind.clear();
    return bundler.take(viewer, text("state"), behind);
  }
  static const SharedFrame* find(const std::vector<SharedFrame>& frames, FrameKind kind) {
    for (const SharedFrame& frame : frames)
      if (frame->binary && frame->bytes[0] == static_cast<char>(kind)) return &frame;
    return nullptr;
  }
  static bool holds(const std::vector<SharedFrame>& frames, const std::string& wanted) {
    return std::ranges::any_of(frames, [&](const SharedFrame& frame) { return frame->bytes == wanted; });
  }
  static std::uint32_t records(const SharedFrame& frame) {
    std::uint32_t count = 0;
    std::memcpy(&count, frame->bytes.data() + 4, sizeof count);
    return count;
  }
  static bool forgets(const SharedFrame& frame) { return (frame->bytes[2] & 1) != 0; }

  live::ReadingLog readings;
  std::vector<Vec2> path;
  std::uint64_t run = 1;
  Bundler bundler;
  QuietViewer greeted;
  std::map<std::string, std::uint32_t> behind;
};

TEST_F(Bundles, BeforeTheWelcomeThereIsTheStateAlone) {
  append_pings(3);
  bundler.set(publication());
  QuietViewer stranger;
  const auto frames = take(stranger);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0]->bytes, "state");
}

TEST_F(Bundles, EachPingIsSentOnce) {
  append_pings(10);
  bundler.set(publication());
  const auto first = take(greeted);
  ASSERT_NE(find(first, FrameKind::pings), nullptr);
  EXPECT_EQ(records(*find(first, FrameKind::pings)), 10U);
  EXPECT_TRUE(forgets(*find(first, FrameKind::pings)));
  EXPECT_EQ(find(take(greeted), FrameKind::pings), nullptr);
  append_pings(4);
  bundler.set(publication());
  const auto second = take(greeted);
  ASSERT_NE(find(second, FrameKind::pings), nullptr);
  EXPECT_EQ(records(*find(second, FrameKind::pings)), 4U);
  EXPECT_FALSE(forgets(*find(second, FrameKind::pings)));
}

TEST_F(Bundles, NewcomerGetsTheLastMinuteAlone) {
  append_pings(3000);  // 150 s
  bundler.set(publication());
  const auto frames = take(greeted);
  ASSERT_NE(find(frames, FrameKind::pings), nullptr);
  EXPECT_NEAR(records(*find(frames, FrameKind::pings)), Bundler::first_pings_s / 0.05, 1.0);
}

TEST_F(Bundles, WhatSeveralLackIsEncodedOnce) {
  append_pings(10);
  path = {{0, 0}, {1, 0}};
  bundler.set(publication());
  QuietViewer other;
  other.cursor.greeted = true;
  const auto a = take(greeted);
  const auto b = take(other);
  EXPECT_EQ(find(a, FrameKind::pings)->get(), find(b, FrameKind::pings)->get());
  EXPECT_EQ(find(a, FrameKind::path)->get(), find(b, FrameKind::path)->get());
}

TEST_F(Bundles, NewcomerForgetsAndFollowerDoesNotWhereTheyBeginAtTheSamePing) {
  append_pings(1800);  // 90 s: a newcomer begins 60 s before the last
  bundler.set(publication());
  QuietViewer newcomer;
  newcomer.cursor.greeted = true;
  const auto first = take(newcomer);
  const std::size_t begin = 1800U - records(*find(first, FrameKind::pings));
  greeted.cursor.run = run;
  greeted.cursor.pings = begin;
  const auto follower = take(greeted);
  ASSERT_NE(find(follower, FrameKind::pings), nullptr);
  EXPECT_TRUE(forgets(*find(first, FrameKind::pings)));
  EXPECT_FALSE(forgets(*find(follower, FrameKind::pings)));
}

TEST_F(Bundles, PathGoesOn) {
  path = {{0, 0}, {1, 0}};
  bundler.set(publication());
  EXPECT_TRUE(forgets(*find(take(greeted), FrameKind::path)));
  path.push_back({2, 0});
  bundler.set(publication());
  const auto frames = take(greeted);
  ASSERT_NE(find(frames, FrameKind::path), nullptr);
  EXPECT_EQ(records(*find(frames, FrameKind::path)), 1U);
  EXPECT_FALSE(forgets(*find(frames, FrameKind::path)));
}

TEST_F(Bundles, AnotherRunStartsAnew) {
  append_pings(10);
  path = {{0, 0}};
  bundler.set(publication());
  (void)take(greeted);
  readings.clear();
  append_pings(2);
  run = 2;
  bundler.set(publication());
  const auto frames = take(greeted);
  ASSERT_NE(find(frames, FrameKind::pings), nullptr);
  EXPECT_EQ(records(*find(frames, FrameKind::pings)), 2U);
  EXPECT_TRUE(forgets(*find(frames, FrameKind::pings)));
  EXPECT_TRUE(forgets(*find(frames, FrameKind::path)));
}

TEST_F(Bundles, DeltaGoesToWhoHasWhatIsBeforeIt) {
  auto made = publication();
  made->deltas = {{"consensus", 4, 5, nullptr, text("points 4 to 5")}};
  bundler.set(made);
  greeted.cursor.maps["consensus"] = 4;
  EXPECT_TRUE(holds(take(greeted), "points 4 to 5"));
  EXPECT_TRUE(behind.empty());
  EXPECT_EQ(greeted.cursor.maps["consensus"], 5U);
  EXPECT_FALSE(holds(take(greeted), "points 4 to 5")) << "twice";
}

TEST_F(Bundles, WhoMissedStatesIsToldToCatchUp) {
  auto made = publication();
  made->deltas = {{"consensus", 4, 5, nullptr, text("points 4 to 5")}};
  bundler.set(made);
  greeted.cursor.maps["consensus"] = 2;
  EXPECT_FALSE(holds(take(greeted), "points 4 to 5"));
  EXPECT_EQ(behind, (std::map<std::string, std::uint32_t>{{"consensus", 2}}));
  greeted.cursor.caught =
      MappingLoop::CatchUp{1, text("methods"), {{"consensus", 2, 5, nullptr, text("points 2 to 5")}}};
  const auto frames = take(greeted);
  EXPECT_TRUE(holds(frames, "points 2 to 5"));
  EXPECT_FALSE(holds(frames, "points 4 to 5"));
  EXPECT_TRUE(behind.empty());
}

TEST_F(Bundles, MapsThatNobodyAskedForAreLeftOut) {
  auto made = publication();
  made->deltas = {{"consensus", 4, 5, nullptr, text("consensus")}, {"evidence", 4, 5, text("evidence"), nullptr}};
  bundler.set(made);
  greeted.subscribed = {{"evidence"}};
  greeted.cursor.maps = {{"consensus", 4}, {"evidence", 4}};
  const auto frames = take(greeted);
  EXPECT_TRUE(holds(frames, "evidence"));
  EXPECT_FALSE(holds(frames, "consensus"));
}

TEST_F(Bundles, MethodsComeBeforeTheirMapsAndOnce) {
  auto made = publication();
  made->deltas = {{"consensus", 4, 5, nullptr, text("points")}};
  bundler.set(made);
  greeted.cursor.maps["consensus"] = 4;
  const auto frames = take(greeted);
  const auto place = [&](const std::string& bytes) {
    return std::ranges::find_if(frames, [&](const SharedFrame& frame) { return frame->bytes == bytes; });
  };
  ASSERT_NE(place("points"), frames.end());
  EXPECT_LT(place("methods"), place("points"));
  EXPECT_FALSE(holds(take(greeted), "methods"));
}

TEST_F(Bundles, CountersSayWhatThisViewerWasSpared) {
  bundler.set(publication());
  greeted.dropped = 12;
  EXPECT_TRUE(holds(take(greeted), R"({"type":"counters","dropped":12})"));
  EXPECT_FALSE(holds(take(greeted), R"({"type":"counters","dropped":12})")) << "once a second";
}

}  // namespace
}  // namespace echoarc::server
