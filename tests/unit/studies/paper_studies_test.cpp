// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/studies/choset2003.hpp"
#include "echoarc/studies/numakura.hpp"
#include "echoarc/studies/silver2004.hpp"
#include "echoarc/studies/yamauchi.hpp"
#include "unit/sim/small_scene.hpp"

namespace echoarc::studies {
namespace {

// Every scene a small room, so that the studies run from end to end in a moment; their figures mean nothing here.
Result<StudyScene> small_scene(std::string_view name) {
  StudyScene small;
  if (name == "alcove" || name == "rcd") {
    small.scene = sim::room_scene(16);
    small.scene.drive.legs = {{.turn = degrees(20.0)}};
    small.scene.drive.stop_turn = degrees(10.0);
  } else {
    small.scene = sim::driving_scene(16);
  }
  if (name == "alcove") {
    small.scene.robot.lasers = {LaserMount{}};
    small.scene.lasers = {{.laser = 0, .angle_min = degrees(-180.0), .angle_step = degrees(2.0), .beams = 180}};
  }
  small.scoring.region = {{-1.0, -1.0}, {5.0, 4.0}};
  return small;
}

StudyReport run(Result<StudyReport> (*study)(const StudyHost&)) {
  InlineExecutor executor;
  StudyHost host;
  host.executor = &executor;
  host.scene = &small_scene;
  host.seeds = 1;
  Result<StudyReport> report = study(host);
  EXPECT_TRUE(report) << report.error().message;
  return std::move(*report);
}

void expect_whole(const StudyReport& report, std::size_t sections) {
  EXPECT_EQ(report.sections.size(), sections);
  std::set<std::string> claims;
  for (const StudySection& section : report.sections) {
    EXPECT_FALSE(section.id.empty());
    for (const Claim& claim : section.claims) EXPECT_TRUE(claims.insert(claim.id).second) << claim.id;
    for (const PictureFigure& figure : section.pictures)
      EXPECT_EQ(figure.image.rgb.size(), std::size_t(figure.image.width) * std::size_t(figure.image.height) * 3);
  }
  EXPECT_FALSE(claims.empty());
}

TEST(PaperStudies, Choset) {
  const StudyReport report = run(&choset2003);
  expect_whole(report, 4);
  const StudyTable& numbers = report.sections.front().tables.front();
  EXPECT_NEAR(numbers.rows[0].ours.mean, 10.5, 0.05) << "gain in resolution";
  EXPECT_NEAR(numbers.rows[1].ours.mean, 3.73, 0.005) << "interval in inches";
  EXPECT_NEAR(numbers.rows[2].ours.mean, 25.88, 0.005) << "half the travel in inches";
}

TEST(PaperStudies, Numakura) {
  expect_whole(run(&numakura), 2);
}

TEST(PaperStudies, Yamauchi) {
  const StudyReport report = run(&yamauchi);
  expect_whole(report, 1);
  const std::vector<StudyRow>& rows = report.sections.front().tables.front().rows;
  EXPECT_LT(rows[3].ours.mean, rows[0].ours.mean) << "the laser sees all walls of a small room";
}

TEST(PaperStudies, Silver) {
  expect_whole(run(&silver2004), 3);
}

TEST(PaperStudies, AMissingSceneIsAnError) {
  InlineExecutor executor;
  StudyHost host;
  host.executor = &executor;
  host.scene = [](std::string_view) { return Result<StudyScene>(Error{ErrorCode::not_found, "none", "", ""}); };
  host.seeds = 1;
  for (const auto study : {&choset2003, &numakura, &yamauchi, &silver2004}) EXPECT_FALSE(study(host));
}

}  // namespace
}  // namespace echoarc::studies
