// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/io/delimited.hpp"

namespace echoarc::io {
namespace {

struct BadDescription {
  const char* toml;
  const char* place;
  const char* message;
};
class BadDescriptions : public testing::TestWithParam<BadDescription> {};

TEST_P(BadDescriptions, NameLineCauseAndRemedy) {
  const Result<DelimitedDescription> description = parse_description(GetParam().toml, "d.toml");
  ASSERT_FALSE(description);
  EXPECT_TRUE(description.error().where.starts_with(GetParam().place)) << description.error().where;
  EXPECT_NE(description.error().message.find(GetParam().message), std::string::npos) << description.error().message;
  EXPECT_FALSE(description.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Description, BadDescriptions,
    testing::Values(
        BadDescription{"", "d.toml", "no table"}, BadDescription{"join = 1\n= 2", "d.toml:2", "not valid TOML"},
        BadDescription{"\njoim = \"row\"\n", "d.toml:2", "joim"},
        BadDescription{"join = \"left\"\n", "d.toml:1", "no join \"left\""},
        BadDescription{"[robot]\nradios_m = 1\n", "d.toml:2", "radios_m"},
        BadDescription{"[robot]\n[[robot.sensors]]\nid = 1\n[[robot.sensors]]\nid = 1\n", "d.toml", "1"},
        BadDescription{"[robot.ring]\ncount = 1000000\nradius_m = 1\n", "d.toml:2", "count"},
        BadDescription{"[[table]]\nfile = \"x\"\n", "d.toml:1", "no columns"},
        BadDescription{"[[table]]\nfiel = \"x\"\ncolumns = [ {column = 1, quantity = \"time\"}, {column = 2, quantity "
                       "= \"range\", sensors = [0]} ]\n",
                       "d.toml:2", "fiel"},
        BadDescription{"[[table]]\ndelimiter = \"pipe\"\ncolumns = []\n", "d.toml:2", "no delimiter"},
        BadDescription{"[[table]]\nrate_hz = 0\ncolumns = []\n", "d.toml:2", "rate_hz"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"speed\"}]\n", "d.toml:3",
                       "no quantity \"speed\""},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1}]\n", "d.toml:3", "no quantity"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 0, quantity = \"time\"}]\n", "d.toml:3", "column = 0"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 70000, quantity = \"time\"}]\n", "d.toml:3",
                       "column = 70000"},
        BadDescription{"[[table]]\ncolumns = [\n{quantity = \"time\"}]\n", "d.toml:3", "must be said once"},
        BadDescription{"[[table]]\ncolumns = [\n{columns = [9, 2], quantity = \"range\"}]\n", "d.toml:3",
                       "first and a last"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"x\", unit = \"ms\"}]\n", "d.toml:3",
                       "\"ms\" is no unit"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"left_wheel\", unit = \"ticks\"}]\n",
                       "d.toml:3", "ticks"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"x\", scale = 0}]\n", "d.toml:3",
                       "scale of 0"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"x\", colour = 0}]\n", "d.toml:3", "colour"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"scan\"}]\n", "d.toml:3",
                       "bearing of its first beam"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"range\", sensors = [-1]}]\n", "d.toml:3",
                       "sensor id"},
        BadDescription{"[[table]]\ncolumns = [\n{column = 1, quantity = \"range\", sensors = [0], no_echo = true}]\n",
                       "d.toml:3", "no spelling"},
        BadDescription{
            "[[table]]\nrate_hz = 1\ncolumns = [ {column = 1, quantity = \"x\"}, {column = 2, quantity = \"y\"} ]\n",
            "d.toml:1", "no whole pose"},
        BadDescription{
            "[[table]]\nrate_hz = 1\ncolumns = [ {columns = [1, 3], quantity = \"range\", sensors = [0]} ]\n",
            "d.toml:1", "3 range column(s) name 1 sensor(s)"},
        BadDescription{"[[table]]\nrate_hz = 1\ncolumns = [ {column = \"a\", quantity = \"range\", sensors = [0]} ]\n",
                       "d.toml:1", "no header line"},
        BadDescription{"[[table]]\ncolumns = [ {column = 1, quantity = \"time\"} ]\n", "d.toml:1", "nothing but times"},
        BadDescription{"[[table]]\ncolumns = [ {column = 1, quantity = \"range\", sensors = [0]} ]\n", "d.toml",
                       "tells the time"}));

TEST(Description, ColumnThatStatesNoEchoSparesTheSensorsTheGuess) {
  const Result<DelimitedDescription> description = parse_description(R"(
[robot.ring]
count = 3
radius_m = 0.2
start_deg = 0
[[table]]
rate_hz = 1
no_echo = 5110
columns = [ { columns = [1, 2], quantity = "range", sensors = [0, 1] },
            { column = 3, quantity = "range", sensors = [2], no_echo = "far" } ]
)",
                                                                     "d.toml");
  ASSERT_TRUE(description) << description.error().message;
  ASSERT_EQ(description->robot.sensors.size(), 3U);
  for (const Sensor& sensor : description->robot.sensors.sensors())
    EXPECT_EQ(sensor.model.no_echo.kind, NoEchoRule::Kind::inf);
  const auto& columns = description->tables[0].columns;
  EXPECT_EQ(columns[0].no_echo.values, std::vector<double>{5110.0});
  EXPECT_EQ(columns[1].no_echo.words, std::vector<std::string>{"far"});
  EXPECT_TRUE(columns[1].no_echo.values.empty()) << "a column's own spelling replaces the table's";
}

TEST(Description, TheExamplesOfTheProjectRead) {
  for (const char* name : {"corridor", "garden", "scitos"}) {
    const auto description = read_description(std::string(ECHOARC_SOURCE_DIR "/descriptions/") + name + ".toml");
    ASSERT_TRUE(description) << description.error().where << ": " << description.error().message;
    EXPECT_FALSE(description->robot.sensors.empty());
  }
}

}  // namespace
}  // namespace echoarc::io
