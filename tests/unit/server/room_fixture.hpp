// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/live/replay_source.hpp"
#include "echoarc/live/simulated_source.hpp"
#include "echoarc/sim/simulate.hpp"
#include "server/room.hpp"
#include "unit/live/robot_fixture.hpp"
#include "unit/server/json_schema.hpp"
#include "unit/server/page_maps.hpp"

namespace echoarc::server::test {

/// A drive through a plain room: half a minute of records.
inline const Log& short_drive() {
  static const Log log = [] {
    sim::Scene scene = live::plain_room();
    scene.drive.legs = {{.to = Vec2{4.5, 2.0}}, {.to = Vec2{4.5, 1.0}}, {.to = Vec2{2.0, 1.0}}};
    return sim::simulate(scene, 1).value().log;
  }();
  return log;
}

inline RoomSetup furnished(std::string kind, std::unique_ptr<live::Source> source,
                           const std::vector<live::MethodChoice>& methods, Executor& executor) {
  live::Mapper mapper = live::Mapper::make(source->description(), {}, methods, executor).value();
  live::ScoreKeeper scores(source->description());
  return RoomSetup{"main", std::move(kind), std::move(source), std::move(mapper), std::move(scores)};
}
inline RoomSetup log_room(const std::vector<live::MethodChoice>& methods, Executor& executor, double speed) {
  RoomSetup setup = furnished("log", live::ReplaySource::make(short_drive()).value(), methods, executor);
  setup.speed = speed;
  return setup;
}
inline RoomSetup scene_room(const std::vector<live::MethodChoice>& methods, Executor& executor) {
  return furnished("scene", live::SimulatedSource::make(live::plain_room(), 1).value(), methods, executor);
}
/// The same with a robot that finds its way by itself, so many times faster than real time.
inline RoomSetup exploring_room(const std::vector<live::MethodChoice>& methods, Executor& executor, double speed) {
  RoomSetup setup = scene_room(methods, executor);
  setup.navigation.emplace(Navigation{live::Navigator::make(setup.source->description()).value(), std::nullopt});
  setup.speed = speed;
  return setup;
}

/// The thread of input and output: the test's own.
class IoThread {
 public:
  Room::Post post() {
    return [this](std::function<void()> job) {
      {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(std::move(job));
      }
      wake_.notify_one();
    };
  }
  /// Does what is posted until `done` says so. False: it never did.
  template <class Done>
  [[nodiscard]] bool run_until(const Done& done, double limit_s = 60.0) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
    while (!done()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::vector<std::function<void()>> jobs;
      {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, std::chrono::milliseconds(20), [&] { return !jobs_.empty(); });
        jobs.swap(jobs_);
      }
      for (const auto& job : jobs) job();
    }
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<std::function<void()>> jobs_;
};

/// A viewer without a socket: takes what it is offered, unless it is `slow`, and holds every text against the schema.
class FakeViewer final : public Viewer {
 public:
  FakeViewer(Room& room, ViewerId number, bool with_token = true) : room_(room) {
    id = number;
    name = "viewer " + std::to_string(number);
    may_drive = with_token;
    room_.join(*this);
  }
  FakeViewer(const FakeViewer&) = delete;
  FakeViewer& operator=(const FakeViewer&) = delete;
  ~FakeViewer() override { leave(); }
  void leave() { room_.leave(*this); }

  void offer() override {
    if (slow)
      ++dropped;
    else
      send(room_.take(*this));
  }
  void send(std::string text) override { hear(text); }
  void send(std::vector<SharedFrame> frames) override {
    for (const SharedFrame& frame : frames) {
      if (!frame->binary)
        hear(frame->bytes);
      else if (number_at<std::uint32_t>(frame->bytes, 12) == 0)
        page.take(*frame);
      else
        answers.push_back(frame);
    }
  }
  void dismiss(std::string_view reason) override { dismissed = reason; }

  void say(const ClientMessage& message) { room_.hear(*this, message); }
  /// The last message of a type since `forget`; null: none.
  [[nodiscard]] const Value* last(const std::string& type) const {
    const auto found = messages_.find(type);
    return found == messages_.end() || found->second.empty() ? nullptr : &found->second.back();
  }
  [[nodiscard]] std::size_t count(const std::string& type) const {
    const auto found = messages_.find(type);
    return found == messages_.end() ? 0 : found->second.size();
  }
  void forget() { messages_.clear(), answers.clear(); }

  bool slow = false;
  PageMaps page;
  std::vector<SharedFrame> answers;  ///< binary frames with the id of a question
  std::string dismissed;

 private:
  void hear(const std::string& text) {
    const Value message = Value::parse(text, nullptr, false);
    EXPECT_EQ(message_schema().message_fault("FromServer", message), "") << text.substr(0, 400);
    const std::string type = message.value("type", "");
    if (type == "methods") {
      std::vector<std::string> names;
      for (const Value& method : message.at("running")) names.push_back(method.at("method"));
      page.take_methods(names);
    }
    messages_[type].push_back(message);
  }

  Room& room_;
  std::map<std::string, std::vector<Value>> messages_;
};

/// A room, its thread and an executor.
class RoomTest : public testing::Test {
 protected:
  void open(RoomSetup setup) { room = Room::open(std::move(setup), io.post()); }
  /// What `ask` makes of the mapper, on its thread.
  template <class Ask>
  auto with_mapper(Ask ask) {
    using Answer = decltype(ask(std::declval<MappingLoop::Access&>()));
    auto answer = std::make_shared<std::optional<Answer>>();
    room->with_mapper([answer, ask, post = io.post()](MappingLoop::Access& access) {
      post([answer, said = ask(access)] { *answer = said; });
    });
    EXPECT_TRUE(io.run_until([&] { return answer->has_value(); }));
    return answer->value_or(Answer());
  }
  bool run_until_heard(const FakeViewer& viewer, const std::string& type) {
    return io.run_until([&] { return viewer.last(type) != nullptr; });
  }
  /// Until a state says so.
  template <class Wanted>
  bool run_until_state(const FakeViewer& viewer, const Wanted& wanted) {
    return io.run_until([&] { return viewer.last("state") != nullptr && wanted(*viewer.last("state")); });
  }

  InlineExecutor executor;
  IoThread io;
  std::shared_ptr<Room> room;
};

}  // namespace echoarc::server::test
