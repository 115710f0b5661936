// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/inquiry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "echoarc/live/cell_layer.hpp"
#include "unit/live/formula_value.hpp"
#include "unit/live/mapper_fixture.hpp"

namespace echoarc::live {
namespace {

/// An echo heard by a sensor that is the robot itself.
JudgedPing echo_of(PingId ping, Vec2 sensor, double axis_deg, double range_m, double beam_deg = 22.5) {
  JudgedPing judged;
  Reading& reading = judged.reading;
  reading.ping = ping;
  reading.time_s = 0.1 * double(ping);
  reading.scan = std::uint32_t(ping);
  reading.tx = reading.rx = SensorId(ping);
  reading.T_world_robot = reading.T_world_tx = reading.T_world_rx = {sensor, degrees(axis_deg)};
  reading.beam_width = degrees(beam_deg);
  reading.range_min_m = 0.057;
  reading.outcome = Echo{range_m};
  judged.raw_range_m = range_m;
  return judged;
}

/// The pings, and the newest map of each method, as a batch makes it.
Evidence evidence_of(const std::vector<JudgedPing>& pings, const std::vector<MethodChoice>& methods) {
  Evidence evidence;
  for (const JudgedPing& ping : pings) evidence.readings.append(ping);
  evidence.methods = methods;
  std::vector<std::string> names;
  for (const MethodChoice& choice : methods) names.push_back(choice.name);
  evidence.maps = map_at(evidence, names, 1e9).value().maps;
  return evidence;
}

/// [Barshan07] 3.6 by hand: five sensors that hear one point at (0, 2.5).
std::vector<JudgedPing> five_sensors() {
  return {echo_of(0, {-1.0, 0.0}, 67.5, 2.6924), echo_of(1, {-0.5, 0.0}, 90.0, 2.54),
          echo_of(2, {0.0, 0.0}, 90.0, 2.4892), echo_of(3, {0.5, 0.0}, 90.0, 2.54),
          echo_of(4, {1.0, 0.0}, 112.5, 2.6924)};
}

std::size_t index_of_ping(const Evidence& evidence, PingId ping) {
  const auto points = evidence.maps[0]->points.points();
  const auto lies_on = [&](const MapPoint& point) { return own_ping(evidence.maps[0]->points, point) == ping; };
  return std::size_t(std::ranges::find_if(points, lies_on) - points.begin());
}

TEST(Inquiry, AMedianIsExplainedByItsCrossings) {
  const Evidence evidence = evidence_of(five_sensors(), {{"atm_org", {{"theta_t_deg", 13.0}}}});
  const auto answer = explain_point(evidence, "atm_org", index_of_ping(evidence, 0));
  ASSERT_TRUE(answer);
  EXPECT_NEAR(answer->position.x, 0.0158, 5e-5);
  EXPECT_NEAR(answer->position.y, 2.4934, 5e-5);
  ASSERT_EQ(answer->support.size(), 3U);
  std::vector<double> bearings;
  for (const Support& support : answer->support) {
    bearings.push_back((answer->arc->axis() + *support.t).deg());
    EXPECT_GE(support.crossing_angle->deg(), 13.0);
    EXPECT_NEAR(norm(*support.crossing - answer->arc->point_at(*support.t)), 0.0, 1e-9);
  }
  std::ranges::sort(bearings);
  EXPECT_NEAR(bearings[0], 67.5895, 5e-5);
  EXPECT_NEAR(bearings[1], 67.8343, 5e-5);
  EXPECT_NEAR(bearings[2], 68.1970, 5e-5);
  EXPECT_EQ(std::ranges::count_if(answer->support, [](const Support& s) { return !s.note.empty(); }), 1);
  EXPECT_EQ(answer->sentence, "The median of 3 crossings on the arc of ping 0.");
  EXPECT_EQ(answer->searched, 5U);
}

TEST(Inquiry, EveryPingIsEitherBehindThePointOrToldWhyNot) {
  std::vector<JudgedPing> pings = five_sensors();
  pings.push_back(echo_of(5, {0.1, 0.0}, 90.0, 2.5));
  pings.back().rejected = Rejection::invalid;
  pings.push_back(echo_of(6, {0.1, 0.0}, 90.0, 2.5));
  pings.back().reading.outcome = NoEcho{};
  pings.push_back(echo_of(7, {9.0, 0.0}, 90.0, 1.0));
  const Evidence evidence = evidence_of(pings, {{"atm_mod", {{"theta_t_deg", 30.0}}}});
  const auto answer = explain_point(evidence, "atm_mod", index_of_ping(evidence, 0));
  ASSERT_TRUE(answer);
  std::set<PingId> behind;
  for (const Support& support : answer->support) behind.insert(support.ping.reading.ping);
  EXPECT_EQ(behind.size(), 2U);
  std::uint64_t unused = 0;
  for (const UnusedPings& group : answer->unused) unused += group.count;
  EXPECT_EQ(behind.size() + unused + 1, pings.size());
}

TEST(Inquiry, ACarvedPointIsExplainedByWhatCutIt) {
  const Evidence evidence =
      evidence_of({echo_of(0, {0.0, 0.0}, 90.0, 2.0), echo_of(1, {0.2, 0.0}, 90.0, 2.0)}, {{"carve", {}}});
  const auto answer = explain_point(evidence, "carve", index_of_ping(evidence, 0));
  ASSERT_TRUE(answer);
  ASSERT_EQ(answer->support.size(), 1U);
  EXPECT_EQ(answer->support[0].ping.reading.ping, 1U);
  EXPECT_EQ(answer->support[0].note, "cut 8.4° on the right");
  EXPECT_NEAR(answer->arc->t_begin().deg() + 90.0, 87.1340, 5e-5);
  EXPECT_NEAR(2.0 * answer->bound_t->deg(), 14.1160, 1e-4);
  EXPECT_NEAR(answer->position.x, -0.14620, 5e-6);
  const auto uncut = explain_point(evidence, "carve", index_of_ping(evidence, 1));
  EXPECT_TRUE(uncut->support.empty());
}

TEST(Inquiry, ACenterlinePointHasOnePingAndItsDistanceFromTheWall) {
  Evidence evidence = evidence_of(five_sensors(), {{"centerline", {}}});
  evidence.walls = {{{-3.0, 2.0}, {3.0, 2.0}}};
  const auto answer = explain_point(evidence, "centerline", 2);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->sentence, "The middle of the beam of ping 2, nothing else.");
  EXPECT_NEAR(*answer->off_wall_m, 0.4892, 1e-12);
  EXPECT_FALSE(explain_point(evidence, "centerline", 99));
  EXPECT_FALSE(explain_point(evidence, "carve", 0));
}

/// V3.6 of the worked numbers: a cell 1 m away sees two echoes at 1 m and one at 2 m.
TEST(Inquiry, TheHistoryOfACellIsThatOfTheWorkedExample) {
  const MethodChoice choice{"evidence", {{"cell_m", 0.01}, {"origin_x_m", -0.005}, {"origin_y_m", -0.005}}};
  const Evidence evidence = evidence_of(
      {echo_of(0, {0, 0}, 0.0, 1.0, 25.0), echo_of(1, {0, 0}, 5.0, 1.0, 25.0), echo_of(2, {0, 0}, 0.0, 2.0, 25.0)},
      {choice});
  const auto answer = explain_cell(evidence, "evidence", {1.001, 0.001});
  ASSERT_TRUE(answer);
  const CellHistory& cell = *answer->cell;
  ASSERT_EQ(cell.changes.size(), 3U);
  EXPECT_EQ(cell.changes[0].before, 0.0);
  EXPECT_NEAR(cell.changes[0].after, 1.734601, 5e-4);
  EXPECT_NEAR(cell.changes[1].after, 2.855482, 5e-4);
  EXPECT_NEAR(cell.changes[2].after, 1.756870, 8e-4);
  EXPECT_EQ(cell.changes[0].where, CellHistoryEntry::Where::on);
  EXPECT_EQ(cell.changes[2].where, CellHistoryEntry::Where::before);
  EXPECT_NEAR(*cell.probability, (0.705634 + 1.0) / 2.0, 1e-3);
}

/// Evidence of a drive through the demo scene.
Evidence driven(const std::vector<MethodChoice>& methods, double until_s) {
  const test::Played played = test::play(test::demo_log_until(until_s));
  InlineExecutor executor;
  auto mapper = Mapper::make(played.description, {}, methods, executor).value();
  for (const Record& record : played.records) mapper.push(record);
  mapper.end_of_records();
  (void)mapper.refresh();
  Evidence evidence;
  evidence.readings = mapper.readings();
  evidence.methods = methods;
  for (const RunningMethod& method : mapper.methods()) evidence.maps.push_back(method.map);
  return evidence;
}

TEST(Inquiry, TheHistoryOfACellSumsToTheValueThatTheMapHolds) {
  for (const char* name : {"evidence", "vt", "bu", "himm", "numakura", "carved_grid"}) {
    const Evidence evidence = driven({{name, {}}}, 8.0);
    const auto points = evidence.maps[0]->points.points();
    ASSERT_GT(points.size(), 20U) << name;
    for (std::size_t k = 0; k < points.size(); k += points.size() / 5) {
      const auto answer = explain_point(evidence, name, k);
      ASSERT_TRUE(answer) << name;
      const auto& changes = answer->cell->changes;
      ASSERT_FALSE(changes.empty()) << name;
      for (std::size_t i = 1; i < changes.size(); ++i)
        EXPECT_NEAR(changes[i].before, changes[i - 1].after, 1e-6) << name;
      const MapExport& map = *evidence.maps[0];
      const Cell cell = map.states.geometry().cell_of(points[k].position);
      const auto* reals = std::get_if<DenseGrid<float>>(&map.values);
      const double held =
          reals != nullptr ? double(reals->at(cell)) : std::get<DenseGrid<std::uint16_t>>(map.values).at(cell);
      EXPECT_NEAR(answer->cell->value, held, 1e-5) << name;
    }
  }
}

TEST(Inquiry, FormulasYieldTheTermsThatTheySay) {
  for (const char* name : {"evidence", "bu", "vt", "carved_grid"}) {
    const Evidence evidence = driven({{name, {}}}, 4.0);
    std::map<std::string, int> checked;
    for (std::size_t k = evidence.readings.size() / 2; k < evidence.readings.size(); k += 7) {
      const auto step = step_ping(evidence, name, evidence.readings[k].reading.ping);
      ASSERT_TRUE(step);
      for (const CellChange& cell : step->cells)
        for (const FormulaLine& line : step->formulas) {
          const auto result = std::ranges::find(cell.terms, line.result, &Term::name);
          if (result == cell.terms.end() || std::abs(cell.after) > 7.99) continue;
          // One unit of the grid's fixed point is all that rounding may take.
          EXPECT_NEAR(test::formula_value(line.tree, cell.terms), result->value, 6e-4) << name << ": " << line.tree;
          ++checked[line.result];
        }
    }
    EXPECT_FALSE(checked.empty()) << name;
    if (std::string_view(name) == "evidence") {
      EXPECT_GT(checked["p_band"], 10);
      EXPECT_GT(checked["p_free"], 100);
      EXPECT_GT(checked["angular_factor"], 100);
      EXPECT_GT(checked["log_odds_added"], 100);
      EXPECT_GT(checked["after"], 100);
    }
  }
}

TEST(Inquiry, ConstantsOfFormulasCarryTheirUnits) {
  const Evidence evidence = evidence_of({echo_of(0, {0, 0}, 90.0, 1.5)}, {{"evidence", {{"range_sigma_m", 0.03}}}});
  const auto step = step_ping(evidence, "evidence", 0);
  ASSERT_TRUE(step);
  std::map<std::string, std::string> trees;
  for (const FormulaLine& line : step->formulas) trees[line.result] = line.tree;
  EXPECT_NE(trees["angular_factor"].find(R"(["val","theta"],["num",5.625,"deg"])"), std::string::npos)
      << trees["angular_factor"];
  EXPECT_NE(trees["p_band"].find(R"(["sub",["val","sigma"],["num",1.5,"m"]],["num",0.03,"m"])"), std::string::npos)
      << trees["p_band"];
  EXPECT_NE(trees["p_band"].find(R"(["num",0.5])"), std::string::npos) << "a number alone has none";
}

TEST(Inquiry, AStepShowsTheMapBeforeThePingAndTheArcsItMeets) {
  const Evidence cut = evidence_of({echo_of(0, {0, 0}, 90.0, 2.0), echo_of(1, {0.2, 0.0}, 90.0, 2.0)}, {{"carve", {}}});
  const auto step = step_ping(cut, "carve", 1);
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->used);
  EXPECT_EQ(step->before->points.size(), 1U);
  ASSERT_EQ(step->arcs.size(), 1U);
  EXPECT_EQ(step->arcs[0].what, TouchedArc::What::cut);
  EXPECT_NEAR(step->arcs[0].left->t_begin().deg() + 90.0, 87.1340, 5e-5);
  const Evidence crossed = evidence_of(five_sensors(), {{"atm_mod", {{"theta_t_deg", 30.0}}}});
  const auto crossing = step_ping(crossed, "atm_mod", 4);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->arcs.size(), 2U);
}

TEST(Inquiry, APingThatWasNotUsedSaysWhy) {
  std::vector<JudgedPing> pings = five_sensors();
  pings[3].rejected = Rejection::implausible_range;
  Evidence evidence = evidence_of(pings, {{"evidence", {}}});
  evidence.sensors_off.insert(4);
  const auto rejected = step_ping(evidence, "evidence", 3);
  EXPECT_FALSE(rejected->used);
  EXPECT_EQ(rejected->reason, info(Rejection::implausible_range).explanation);
  EXPECT_EQ(step_ping(evidence, "evidence", 4)->reason, "its sensor is turned off");
  EXPECT_FALSE(step_ping(evidence, "evidence", 77));
}

TEST(Inquiry, TheConsensusNamesTheVoicesBehindAPoint) {
  const Evidence evidence = driven({{"consensus", {}}}, 20.0);
  const auto points = evidence.maps[0]->points.points();
  const auto wall = std::ranges::find(points, PointLabel::wall, &MapPoint::label);
  ASSERT_NE(wall, points.end());
  const auto answer = explain_point(evidence, "consensus", std::size_t(wall - points.begin()));
  ASSERT_TRUE(answer);
  EXPECT_GT(answer->support.size(), 2U);
  EXPECT_LE(answer->support.size(), 15U);
  EXPECT_NE(answer->sentence.find("place the echo of ping"), std::string::npos) << answer->sentence;
}

}  // namespace
}  // namespace echoarc::live
