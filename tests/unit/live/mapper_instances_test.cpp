// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// One method several times over, with different options.

#include <gtest/gtest.h>

#include "echoarc/live/inquiry.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/live/scores.hpp"
#include "unit/live/mapper_fixture.hpp"

namespace echoarc::live {
namespace {

using test::demo_log_until;
using test::play;
using test::Played;
using test::same_map;

const OptionMap no_test{{"geometry_test", false}, {"consistency_test", false}};
const OptionMap test_1{{"geometry_test", true}, {"consistency_test", false}};

const Played& short_drive() {
  static const Played played = play(demo_log_until(15.0));
  return played;
}

Mapper fed(const std::vector<MethodChoice>& methods, Executor& executor) {
  auto mapper = Mapper::make(short_drive().description, {}, methods, executor);
  EXPECT_TRUE(mapper) << mapper.error().message;
  for (const Record& record : short_drive().records) mapper->push(record);
  mapper->end_of_records();
  (void)mapper->refresh();
  return std::move(*mapper);
}

TEST(Instances, EachHasTheMapThatItsOptionsGiveAlone) {
  InlineExecutor executor;
  const Mapper together = fed({{"numakura", {}}, {"numakura", no_test, "numakura-no-test"}, {"carve", {}}}, executor);
  ASSERT_EQ(together.methods().size(), 3U);
  EXPECT_EQ(together.methods()[0].id(), "numakura");
  EXPECT_EQ(together.methods()[1].id(), "numakura-no-test");
  EXPECT_EQ(together.methods()[1].choice.name, "numakura");
  const Mapper plain = fed({{"numakura", {}}}, executor);
  const Mapper without = fed({{"numakura", no_test}}, executor);
  EXPECT_TRUE(same_map(*together.final_map("numakura"), *plain.final_map("numakura")));
  EXPECT_TRUE(same_map(*together.final_map("numakura-no-test"), *without.final_map("numakura")));
  EXPECT_FALSE(same_map(*plain.final_map("numakura"), *without.final_map("numakura"))) << "the tests do something";
}

TEST(Instances, OptionsAndRemovalReachOneAlone) {
  InlineExecutor executor;
  Mapper mapper = fed({{"numakura", {}}}, executor);
  ASSERT_TRUE(mapper.add_method({"numakura", {}, "numakura-2"}));
  ASSERT_TRUE(mapper.set_options("numakura-2", test_1));
  while (mapper.work(10'000)) {
  }
  EXPECT_EQ(mapper.methods()[0].options.at("consistency_test"), OptionValue(true));
  EXPECT_EQ(mapper.methods()[1].options.at("consistency_test"), OptionValue(false));
  EXPECT_EQ(mapper.methods()[1].choice.name, "numakura");
  EXPECT_TRUE(same_map(*mapper.final_map("numakura-2"), *fed({{"numakura", test_1}}, executor).final_map("numakura")));
  ASSERT_TRUE(mapper.remove_method("numakura"));
  ASSERT_EQ(mapper.methods().size(), 1U);
  EXPECT_EQ(mapper.methods()[0].id(), "numakura-2");
  EXPECT_FALSE(mapper.set_options("numakura", {}));
  ASSERT_TRUE(mapper.add_method({"numakura", {}}));
}

TEST(Instances, ScoresAreToldById) {
  InlineExecutor executor;
  const Mapper mapper = fed({{"atm_mod", {}}, {"atm_mod", {{"theta_t_deg", 60.0}}, "steep"}}, executor);
  ScoreKeeper keeper(short_drive().description);
  for (const Record& record : short_drive().records) keeper.push(record);
  const Scores& scores = keeper.update(mapper);
  ASSERT_EQ(scores.methods.size(), 2U);
  EXPECT_EQ(scores.methods[0].method, "atm_mod");
  EXPECT_EQ(scores.methods[1].method, "steep");
  EXPECT_LT(scores.methods[1].points, scores.methods[0].points);
}

TEST(Instances, IdsThatAreTakenOrNoneAreRefused) {
  InlineExecutor executor;
  auto mapper = Mapper::make(short_drive().description, {}, {}, executor).value();
  ASSERT_TRUE(mapper.add_method({"vt", {}, "vt-2"})) << "the first of a method may have any id";
  for (const char* id : {"vt-2", "dm", "Vt", "-vt", "../vt", "v t", "vt.2", "vt/2", "v\xc3\xa4"}) {
    const auto added = mapper.add_method({"vt", {}, id});
    ASSERT_FALSE(added) << id;
    EXPECT_EQ(added.error().code, ErrorCode::bad_value) << id;
    EXPECT_FALSE(added.error().remedy.empty()) << id;
  }
  EXPECT_FALSE(mapper.add_method({"vt", {}, std::string(65, 'v')}));
  EXPECT_TRUE(mapper.add_method({"vt", {}, std::string(64, 'v')}));
  EXPECT_TRUE(mapper.add_method({"vt", {}, ""})) << "its id is its name then";
  EXPECT_FALSE(mapper.add_method({"unheard_of", {}, "x"}));
  EXPECT_EQ(mapper.methods().size(), 3U);
}

TEST(Instances, AreNoMoreThanFramesCanTellApart) {
  InlineExecutor executor;
  auto mapper = Mapper::make(short_drive().description, {}, {}, executor).value();
  for (std::size_t k = 0; k < Mapper::max_methods; ++k)
    ASSERT_TRUE(mapper.add_method({"centerline", {}, "c" + std::to_string(k)})) << k;
  const auto refused = mapper.add_method({"centerline", {}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(mapper.methods().size(), Mapper::max_methods);
}

TEST(Instances, QuestionsAreAnsweredByTheOneThatIsAsked) {
  InlineExecutor executor;
  const std::vector<MethodChoice> choices{
      {"carve", {}}, {"carve", {{"guard_m", 0.2}}, "careful"}, {"evidence", {}, "grid"}};
  const Mapper mapper = fed(choices, executor);
  Evidence evidence;
  evidence.readings = mapper.readings();
  evidence.methods = choices;
  evidence.truth = mapper.truth();
  for (const RunningMethod& method : mapper.methods()) evidence.maps.push_back(method.map);
  const PingId ping = evidence.readings[evidence.readings.size() / 2].reading.ping;
  for (const MethodChoice& choice : choices) {
    const auto step = step_ping(evidence, choice.key(), ping);
    ASSERT_TRUE(step) << choice.key();
    EXPECT_EQ(step->method, choice.key());
    const auto past = map_at(evidence, std::vector{choice.key()}, 5.0);
    ASSERT_TRUE(past) << choice.key();
    EXPECT_EQ(past->maps.size(), 1U);
  }
  const auto point = explain_point(evidence, "careful", 0);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->method, "careful");
  ASSERT_TRUE(point->cell);
  EXPECT_EQ(point->cell->method, "grid") << "the first with cells, by its id";
  const auto cell = explain_cell(evidence, "grid", point->position);
  ASSERT_TRUE(cell);
  EXPECT_EQ(cell->method, "grid");
  EXPECT_FALSE(explain_cell(evidence, "evidence", point->position)) << "that id does not run";
}

}  // namespace
}  // namespace echoarc::live
