// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <deque>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/arc_carving.hpp"
#include "echoarc/core/arc_crossing.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "support/random_readings.hpp"

/// What methods tell of the arcs in their history, held against lists that are looked through from end to end.
namespace echoarc {
namespace {

struct Known {
  Arc whole;
  Arc left;
  PingId ping = 0;
  bool carved = false;
  bool removed = false;
};

struct Seen {
  PingId ping = 0;
  bool crossed = false;
  bool carved = false;
  bool removed = false;
  double length_rad = 0.0;
  friend bool operator==(const Seen&, const Seen&) = default;
};

Seen seen_of(const ArcState& state) {
  return {state.source.ping, state.crossed, state.carved, state.removed,
          state.removed ? 0.0 : state.angular_length().rad()};
}

/// The history of a method, arc by arc.
class SlowHistory {
 public:
  SlowHistory(std::size_t capacity, bool carves, bool crosses, Angle theta_t)
      : capacity_(capacity), carves_(carves), crosses_(crosses), theta_t_(theta_t) {}

  void take(const Reading& reading) {
    const auto arc = arc_of(reading);
    if (!arc) return;
    if (arcs_.size() == capacity_) {
      left_.push_back(seen(0));
      arcs_.pop_front();
    }
    for (Known& older : arcs_) carve_one(older, *arc);
    arcs_.push_back({*arc, *arc, reading.ping, false, false});
  }

  [[nodiscard]] std::vector<Seen> now() const {
    std::vector<Seen> all;
    for (std::size_t k = 0; k < arcs_.size(); ++k) all.push_back(seen(k));
    return all;
  }
  [[nodiscard]] const std::vector<Seen>& left() const { return left_; }

 private:
  void carve_one(Known& older, const Arc& newer) const {
    if (!carves_ || older.removed) return;
    const Carving carving = carve(older.left, FreeSector(newer));
    if (carving.outcome > CarveOutcome::carved) older.removed = true;
    if (carving.outcome == CarveOutcome::carved) older.left.set_limits(carving.t_begin, carving.t_end);
    older.carved = older.carved || carving.outcome == CarveOutcome::carved;
  }

  [[nodiscard]] bool is_crossed(std::size_t index) const {
    for (std::size_t other = 0; other < arcs_.size(); ++other) {
      if (!crosses_ || other == index) continue;
      for (const ArcCrossing& crossing : crossings(CrossableArc(arcs_[index].whole), CrossableArc(arcs_[other].whole)))
        if (crossing.angle >= theta_t_) return true;
    }
    return false;
  }

  [[nodiscard]] Seen seen(std::size_t index) const {
    const Known& known = arcs_[index];
    return {known.ping, is_crossed(index), known.carved && !known.removed, known.removed,
            known.removed ? 0.0 : (known.left.t_end() - known.left.t_begin()).rad()};
  }

  std::size_t capacity_;
  bool carves_;
  bool crosses_;
  Angle theta_t_;
  std::deque<Known> arcs_;
  std::vector<Seen> left_;
};

struct Case {
  std::string method;
  std::string history_option;
  bool carves;
  bool crosses;
};

RC_GTEST_PROP(ArcStates, AreThoseOfASlowRecount, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Reading> readings = test::wall_drive(rng, 12);
  for (int k = 0; k < 40; ++k) readings.push_back(test::random_reading(rng, readings.size()));
  const std::vector<Case> cases{{"atm_silver", "history_arcs", false, true},
                                {"carve", "history", true, false},
                                {"combined", "history", true, true}};
  const Case& chosen = cases[rng.below(cases.size())];
  const std::size_t capacity = 1 + rng.below(40);
  auto method = make_method(chosen.method, {{chosen.history_option, std::int64_t(capacity)}});
  RC_ASSERT(method.has_value());
  SlowHistory slow(capacity, chosen.carves, chosen.crosses, degrees(30.0));
  std::vector<Seen> left;
  method->watch_leaving([&](const ArcState& state) { left.push_back(seen_of(state)); });
  InlineExecutor here;
  for (const Reading& reading : readings) {
    method->insert(std::span(&reading, 1), here);
    slow.take(reading);
    if (reading.ping % 7 != 0) continue;
    std::vector<Seen> now;
    method->visit_arcs([&](const ArcState& state) { now.push_back(seen_of(state)); });
    RC_ASSERT(now == slow.now());
    RC_ASSERT(method->history_full() == (now.size() == capacity));
  }
  RC_ASSERT(left == slow.left());
}

TEST(ArcStates, LookingChangesNothing) {
  for (const MethodEntry& entry : catalog()) {
    Rng rng(7);
    const std::vector<Reading> readings = test::wall_drive(rng, 70);
    auto watched = entry.make({});
    auto alone = entry.make({});
    InlineExecutor here;
    std::size_t seen = 0;
    watched->watch_leaving([&](const ArcState&) { ++seen; });
    for (std::size_t k = 0; k < readings.size(); k += 5) {
      watched->insert(std::span(readings).subspan(k, 5), here);
      watched->visit_arcs([&](const ArcState&) { ++seen; });
    }
    alone->insert(readings, here);
    EXPECT_EQ(watched->save(), alone->save()) << entry.name;
    EXPECT_EQ(watched->keeps_arcs(), seen > 0) << entry.name;
  }
}

}  // namespace
}  // namespace echoarc
