// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/control_loop.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

/// What a loop told its host.
class Host {
 public:
  ControlLoop::Host callbacks() {
    return {[this](std::vector<live::Record>&& said) {
              const std::lock_guard lock(mutex_);
              records_.insert(records_.end(), said.begin(), said.end());
            },
            [this] {
              const std::lock_guard lock(mutex_);
              records_.clear();
              ++restarts_;
            },
            [this](std::shared_ptr<const RobotStatus> status) {
              {
                const std::lock_guard lock(mutex_);
                ticks_.push_back(std::move(status));
              }
              wake_.notify_all();
            },
            [this] {
              const std::lock_guard lock(mutex_);
              return crowded_;
            }};
  }
  /// Until a tick says so; `before_each` runs before every look.
  template <class Wanted>
  bool wait(const Wanted& wanted, const std::function<void()>& before_each = [] {}) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    std::unique_lock lock(mutex_);
    for (;;) {
      lock.unlock();
      before_each();
      lock.lock();
      if (!ticks_.empty() && wanted(*ticks_.back())) return true;
      if (wake_.wait_until(lock, end) == std::cv_status::timeout) return false;
    }
  }
  bool wait_ticks(std::size_t count) {
    const std::size_t enough = ticks().size() + count;
    return wait([&](const RobotStatus&) { return ticks_.size() >= enough; });
  }
  std::vector<std::shared_ptr<const RobotStatus>> ticks() {
    const std::lock_guard lock(mutex_);
    return ticks_;
  }
  std::vector<live::Record> records() {
    const std::lock_guard lock(mutex_);
    return records_;
  }
  int restarts() {
    const std::lock_guard lock(mutex_);
    return restarts_;
  }
  void crowd(bool crowded) {
    const std::lock_guard lock(mutex_);
    crowded_ = crowded;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<std::shared_ptr<const RobotStatus>> ticks_;
  std::vector<live::Record> records_;
  int restarts_ = 0;
  bool crowded_ = false;
};

std::unique_ptr<live::Source> simulated() {
  return live::SimulatedSource::make(live::plain_room(), 1).value();
}
std::unique_ptr<live::Source> played() {
  return live::ReplaySource::make(short_drive()).value();
}
std::size_t pings_of(const std::vector<live::Record>& records) {
  return static_cast<std::size_t>(
      std::ranges::count_if(records, [](const live::Record& r) { return std::holds_alternative<Ping>(r); }));
}

TEST(ControlLoop, TicksTenTimesASecondAndKeepsToRealTime) {
  Host host;
  ControlLoop loop(simulated(), {}, 1.0, host.callbacks());
  ASSERT_TRUE(host.wait_ticks(15));
  const auto ticks = host.ticks();
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i]->tick, ticks[i - 1]->tick + 1);
    EXPECT_GT(ticks[i]->mono_us, ticks[i - 1]->mono_us);
    EXPECT_GE(ticks[i]->time_s, ticks[i - 1]->time_s);
  }
  const double host_s = 1e-6 * static_cast<double>(ticks.back()->mono_us - ticks.front()->mono_us);
  EXPECT_GT(host_s, 14 * ControlLoop::tick_s - 0.15) << "not more often";
  EXPECT_LT(ticks.back()->time_s - ticks.front()->time_s, host_s + 0.05) << "the robot does not run ahead";
  EXPECT_GT(ticks.back()->time_s, ticks.front()->time_s);
  EXPECT_GT(pings_of(host.records()), 0U);
  EXPECT_TRUE(ticks.back()->T_world_true && ticks.back()->T_world_robot);
}

TEST(ControlLoop, CommandReachesTheRobotAndEndsWithTheDeadMan) {
  Host host;
  ControlLoop loop(simulated(), {}, 1.0, host.callbacks());
  std::uint32_t seq = 0;
  const auto drive = [&] { loop.drive({0.2, radians(0.1)}, ++seq); };
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return s.velocity.forward_m_s > 0.1; }, drive));
  const auto driven = host.ticks().back();
  EXPECT_EQ(driven->control.mode, live::Mode::drive);
  ASSERT_TRUE(driven->drive_seq);
  EXPECT_LE(*driven->drive_seq, seq);
  EXPECT_GT(driven->drive_us, 0);
  EXPECT_LE(driven->drive_us, driven->mono_us);
  EXPECT_TRUE(host.wait([](const RobotStatus& s) {
    return s.control.reason == live::Reason::dead_man && s.velocity.forward_m_s == 0.0;
  }));
  EXPECT_GT(host.ticks().back()->travelled_m, 0.01);
}

TEST(ControlLoop, DriverWhoIsGoneLetsItBrake) {
  Host host;
  live::ControlOptions patient;
  patient.dead_man_s = 3600.0;
  ControlLoop loop(simulated(), patient, 1.0, host.callbacks());
  loop.drive({0.2, {}}, 1);
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return s.velocity.forward_m_s > 0.05; }));
  loop.control([](live::RobotControl& control) { control.driver_gone(); });
  EXPECT_TRUE(host.wait([](const RobotStatus& s) {
    return s.control.reason == live::Reason::dead_man && s.velocity.forward_m_s == 0.0;
  }));
}

TEST(ControlLoop, LogCannotBeDriven) {
  Host host;
  ControlLoop loop(played(), {}, 1.0, host.callbacks());
  bool asked = false;
  loop.drive({0.2, {}}, 1);
  loop.control([&](live::RobotControl&) { asked = true; });
  ASSERT_TRUE(host.wait_ticks(2));
  EXPECT_FALSE(host.ticks().back()->drive_seq);
  EXPECT_FALSE(asked);
}

TEST(ControlLoop, LogIsPlayedOnceAndSaysWhenItEnds) {
  Host host;
  ControlLoop loop(played(), {}, 50.0, host.callbacks());
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return s.ended; }));
  EXPECT_EQ(pings_of(host.records()), short_drive().pings.size());
  ASSERT_TRUE(host.wait_ticks(3));
  EXPECT_EQ(pings_of(host.records()), short_drive().pings.size()) << "and then nothing";
  EXPECT_EQ(host.ticks().back()->speed, 50.0);
}

TEST(ControlLoop, PausedLogStandsStill) {
  Host host;
  ControlLoop loop(played(), {}, 1.0, host.callbacks());
  loop.play(false);
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return !s.playing; }));
  const double held_s = host.ticks().back()->time_s;
  ASSERT_TRUE(host.wait_ticks(4));
  EXPECT_EQ(host.ticks().back()->time_s, held_s);
  loop.play(true);
  ASSERT_TRUE(host.wait([&](const RobotStatus& s) { return s.time_s > held_s + 0.2; }));
  EXPECT_LT(host.ticks().back()->time_s, held_s + 30.0) << "the pause is not made up for";
}

TEST(ControlLoop, SeekingBackStartsAnewAndForwardDoesNot) {
  Host host;
  ControlLoop loop(played(), {}, 1.0, host.callbacks());
  loop.play(false);
  const auto pings_until = [](double time_s) {
    return static_cast<std::size_t>(
        std::ranges::count_if(short_drive().pings, [&](const Ping& ping) { return ping.time_s <= time_s; }));
  };
  const auto seek = [&](double time_s) {
    loop.seek(time_s);
    ASSERT_TRUE(host.wait([&](const RobotStatus& s) { return s.time_s == time_s; })) << time_s;
    EXPECT_EQ(pings_of(host.records()), pings_until(time_s)) << "everything until then, once";
  };
  seek(6.0);
  EXPECT_EQ(host.restarts(), 0);
  seek(8.0);
  EXPECT_EQ(host.restarts(), 0);
  seek(3.0);
  EXPECT_EQ(host.restarts(), 1);
  seek(9.0);
  EXPECT_EQ(host.restarts(), 1);
  const double begin_s = played()->description().begin_s;
  loop.seek(-1e9);
  ASSERT_TRUE(host.wait([&](const RobotStatus& s) { return s.time_s == begin_s; })) << "held to the log's begin";
  loop.seek(1e9);
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return s.ended; }));
  EXPECT_EQ(pings_of(host.records()), short_drive().pings.size());
  loop.seek(2.0);
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return !s.ended && s.time_s == 2.0; })) << "from behind its end";
}

TEST(ControlLoop, CrowdHoldsALogButNoRobot) {
  Host host;
  host.crowd(true);
  ControlLoop log(played(), {}, 1.0, host.callbacks());
  ASSERT_TRUE(host.wait_ticks(5));
  EXPECT_EQ(host.ticks().back()->time_s, played()->description().begin_s);
  EXPECT_TRUE(host.ticks().back()->playing);
  host.crowd(false);
  EXPECT_TRUE(host.wait([](const RobotStatus& s) { return s.time_s > 0.5; }));
  Host other;
  other.crowd(true);
  ControlLoop robot(simulated(), {}, 1.0, other.callbacks());
  EXPECT_TRUE(other.wait([](const RobotStatus& s) { return s.time_s > 0.5; }));
}

/// Says nothing, and breaks after a while.
class Breaking final : public live::Source {
 public:
  [[nodiscard]] const live::SourceDescription& description() const override { return description_; }
  [[nodiscard]] double time_s() const override { return time_s_; }
  [[nodiscard]] Result<void> advance(double until_s, std::vector<live::Record>&) override {
    time_s_ = until_s;
    if (until_s > 0.1) return Error{ErrorCode::unreadable, "the cable is loose", "", "push it in"};
    return {};
  }

 private:
  live::SourceDescription description_;
  double time_s_ = 0.0;
};

TEST(ControlLoop, BrokenSourceIsToldAndLeftAlone) {
  Host host;
  ControlLoop loop(std::make_unique<Breaking>(), {}, 1.0, host.callbacks());
  ASSERT_TRUE(host.wait([](const RobotStatus& s) { return s.broken == "the cable is loose"; }));
  const double time_s = host.ticks().back()->time_s;
  ASSERT_TRUE(host.wait_ticks(3));
  EXPECT_EQ(host.ticks().back()->time_s, time_s);
}

}  // namespace
}  // namespace echoarc::server::test
