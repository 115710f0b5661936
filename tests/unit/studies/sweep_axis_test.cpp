// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/sweep_axis.hpp"

#include <gtest/gtest.h>

#include "echoarc/mapping/carve.hpp"
#include "echoarc/mapping/voting.hpp"

namespace echoarc::studies {
namespace {

using Values = std::vector<OptionValue>;

OptionSpec spec_named(const std::vector<OptionSpec>& specs, std::string_view name) {
  for (const OptionSpec& spec : specs)
    if (spec.name == name) return spec;
  return {};
}

const OptionSpec threshold = spec_named(option_specs<VotingOptions>(), "threshold");
const OptionSpec guard = spec_named(option_specs<CarveOptions>(), "guard_m");
const OptionSpec archive = spec_named(option_specs<CarveOptions>(), "archive");

TEST(SweepValues, RangesHaveBothEnds) {
  EXPECT_EQ(*parse_values(threshold, "1:4:1"),
            (Values{std::int64_t{1}, std::int64_t{2}, std::int64_t{3}, std::int64_t{4}}));
  EXPECT_EQ(*parse_values(threshold, "5:1:-2"), (Values{std::int64_t{5}, std::int64_t{3}, std::int64_t{1}}));
  EXPECT_EQ(*parse_values(threshold, "1:4:2"), (Values{std::int64_t{1}, std::int64_t{3}}));
  EXPECT_EQ(*parse_values(guard, "0:0.3:0.1"), (Values{0.0, 0.1, 0.2, 0.3}));  // not 0.30000000000000004
  EXPECT_EQ(parse_values(guard, "0.99:1:0.001")->size(), 11U);
}

TEST(SweepValues, ListsAreTakenAsTheyStand) {
  EXPECT_EQ(*parse_values(threshold, "4,1,9"), (Values{std::int64_t{4}, std::int64_t{1}, std::int64_t{9}}));
  EXPECT_EQ(*parse_values(archive, "true,false"), (Values{true, false}));
}

TEST(SweepValues, RefusesWhatIsNoRange) {
  for (const char* text : {"5:1:1", "1:5:0", "1:5", "1:5:1:1", "a:b:c", "1:nan:1", "1:inf:1", "0:1e9:1", ":::", ""})
    EXPECT_FALSE(parse_values(threshold, text)) << text;
  EXPECT_FALSE(parse_values(threshold, "1:2:0.5"));  // 1.5 arcs
  EXPECT_FALSE(parse_values(threshold, "0:4:1"));    // below the least threshold
  EXPECT_FALSE(parse_values(threshold, "1,,2"));
  EXPECT_FALSE(parse_values(archive, "0:1:1:"));
}

TEST(SweepAxis, FindsTheOwnerOfAnOption) {
  const std::vector<std::string> methods{"vt", "dm"};
  const auto axis = parse_axis("threshold=1:3:1", methods, true);
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->group, "method");
  EXPECT_EQ(axis->unit, "arcs");
  EXPECT_EQ(axis->key(), "threshold");
  EXPECT_EQ(parse_axis("method.threshold=4", methods, true)->key(), "threshold");
  EXPECT_EQ(parse_axis("dm.axis_deg=90", methods, true)->key(), "dm.axis_deg");
  EXPECT_EQ(parse_axis("range_cut_m=3,4", methods, true)->group, "sensing");
  EXPECT_EQ(parse_axis("sensing.range_cut_m=3,4", methods, false)->group, "sensing");
  EXPECT_EQ(parse_axis("sonar.threshold_db=30:40:5", methods, true)->values.size(), 3U);
  EXPECT_EQ(parse_axis("odometry.perfect=true,false", methods, true)->group, "odometry");
  EXPECT_EQ(parse_axis("scoring.cell_m=0.01,0.02", methods, true)->group, "scoring");
}

TEST(SweepAxis, SaysWhatIsWrong) {
  const std::vector<std::string> methods{"vt", "centerline"};
  EXPECT_NE(parse_axis("threshold=1", methods, true).error().message.find("centerline has no option"),
            std::string::npos);
  EXPECT_NE(parse_axis("treshold=1", methods, true).error().remedy.find("threshold"), std::string::npos);
  EXPECT_NE(parse_axis("dm.threshold=1", methods, true).error().message.find("not among the methods"),
            std::string::npos);
  EXPECT_NE(parse_axis("sonar.threshold_db=30", methods, false).error().message.find("a log has no"),
            std::string::npos);
  EXPECT_NE(parse_axis("nobody.x=1", methods, true).error().remedy.find("sensing, sonar"), std::string::npos);
  EXPECT_FALSE(parse_axis("threshold", methods, true));
  EXPECT_FALSE(parse_axis("=1", methods, true));
  EXPECT_FALSE(parse_axis("sonar.=1", methods, true));
  EXPECT_FALSE(parse_axis("threshold=1", std::vector<std::string>{"vd"}, true));
}

TEST(SweepAxis, ReachesEveryTableOfAScene) {
  StudyScene scene;
  scene.scene.lasers.resize(2);
  const std::vector<std::string> methods{"vt"};
  for (const char* text : {"sonar.threshold_db=41", "drive.speed_m_s=0.4", "odometry.rate_hz=7", "polling.polled=true",
                           "laser.beams=3", "scoring.cell_m=0.05"}) {
    const auto axis = parse_axis(text, methods, true);
    ASSERT_TRUE(axis) << text;
    EXPECT_TRUE(is_scene_group(axis->group));
    EXPECT_TRUE(set_scene_option(scene, *axis, axis->values.front()));
  }
  EXPECT_EQ(scene.scene.sonar.threshold_db, 41.0);
  EXPECT_EQ(scene.scene.drive.speed_m_s, 0.4);
  EXPECT_EQ(scene.scene.odometry.rate_hz, 7.0);
  EXPECT_TRUE(scene.scene.polling.polled);
  EXPECT_EQ(scene.scene.lasers[1].beams, 3);
  EXPECT_EQ(scene.scoring.cell_m, 0.05);
}

}  // namespace
}  // namespace echoarc::studies
