// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/config.hpp"

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

enum class Profile { gaussian, uniform };
constexpr std::array<Choice<Profile>, 2> choices(Profile) {
  return {{{Profile::gaussian, "gaussian"}, {Profile::uniform, "uniform"}}};
}

struct SampleOptions {
  double cell_m = 0.05;
  int threshold = 4;
  bool thin = true;
  Profile profile = Profile::gaussian;

  static constexpr auto fields() {
    return std::tuple{
        field("cell_m", &SampleOptions::cell_m, {.unit = "m", .min = 0.001, .max = 10.0, .doc = "side of a cell"}),
        field("threshold", &SampleOptions::threshold, {.min = 1, .doc = "votes", .source = "[Barshan07] 3.2"}),
        field("thin", &SampleOptions::thin, {.doc = "keep the middle"}),
        field("profile", &SampleOptions::profile, {.doc = "across the beam"})};
  }
};

const std::vector<OptionSection> sections = {{"evidence", option_specs<SampleOptions>()},
                                             {"sensing", option_specs<SampleOptions>()}};

TEST(Config, ReadsSections) {
  const test::TempFolder folder;
  test::put(folder / "config.toml",
            "[evidence]\ncell_m = 1\nprofile = \"uniform\"\n\n[sensing]\nthreshold = 7\nthin = false\n");
  const auto config = read_config_toml(folder / "config.toml", sections);
  ASSERT_TRUE(config) << config.error().message;
  const Config expected = {{"evidence", {{"cell_m", 1.0}, {"profile", std::string("uniform")}}},
                           {"sensing", {{"threshold", std::int64_t{7}}, {"thin", false}}}};
  EXPECT_EQ(*config, expected);
}

struct BadConfig {
  std::string_view text;
  std::string_view message;
  std::string_view where;
  std::string_view remedy;
};

TEST(Config, ErrorsNameLineAndRemedy) {
  const BadConfig cases[] = {
      {"[evidence]\n[evdence]\n", "there is no section evdence", "c.toml:2", "use one of evidence, sensing"},
      {"cell_m = 0.1\n", "there is no section cell_m", "c.toml:1", "use one of evidence, sensing"},
      {"evidence = 1\n", "evidence is no section", "c.toml:1",
       "write [evidence] on a line of its own, its options below"},
      {"[evidence]\ncel_m = 0.1\n", "there is no option cel_m", "c.toml:2", "did you mean cell_m?"},
      {"[evidence]\ncell_m = 0\n", "cell_m = 0 is not legal", "c.toml:2", "use 0.001 to 10 m (default 0.05)"},
      {"[evidence]\nthreshold = 2.5\n", "threshold = 2.5 is not legal", "c.toml:2", "use at least 1 (default 4)"},
      {"[evidence]\n\nthin = [true]\n", "thin has the wrong type", "c.toml:3", "use true or false"},
      {"[evidence]\nprofile = \"flat\"\n", "profile = flat is not legal", "c.toml:2",
       "use gaussian or uniform (default gaussian)"},
  };
  for (const BadConfig& bad : cases) {
    const auto config = parse_config_toml(bad.text, "c.toml", sections);
    ASSERT_FALSE(config) << bad.text;
    EXPECT_EQ(config.error().message, bad.message);
    EXPECT_EQ(config.error().where, bad.where);
    EXPECT_EQ(config.error().remedy, bad.remedy);
  }
  EXPECT_EQ(parse_config_toml("[evidence\n", "c.toml", sections).error().code, ErrorCode::bad_format);
}

TEST(Config, SettingsFromTheCommandLine) {
  const auto setting = parse_setting("evidence.cell_m=0.01", sections);
  ASSERT_TRUE(setting);
  EXPECT_EQ(setting->section, "evidence");
  EXPECT_EQ(setting->option, "cell_m");
  EXPECT_EQ(setting->value, OptionValue{0.01});
  EXPECT_EQ(parse_setting("sensing.threshold=3", sections)->value, OptionValue{std::int64_t{3}});
}

TEST(Config, BadSettingsSayWhatWouldBeLegal) {
  const BadConfig cases[] = {
      {"evidence.cell_m", "is not SECTION.OPTION=VALUE", "--set evidence.cell_m",
       "write it as in --set evidence.cell_m=0.01"},
      {"cell_m=0.01", "is not SECTION.OPTION=VALUE", "--set cell_m=0.01", "write it as in --set evidence.cell_m=0.01"},
      {"dm.cell_m=1", "there is no section dm", "--set dm.cell_m=1", "use one of evidence, sensing"},
      {"evidence.cel_m=1", "there is no option cel_m", "--set evidence.cel_m=1", "did you mean cell_m?"},
      {"evidence.cell_m=x.y", "cell_m = x.y is not legal", "--set evidence.cell_m=x.y",
       "use 0.001 to 10 m (default 0.05)"},
  };
  for (const BadConfig& bad : cases) {
    const auto setting = parse_setting(bad.text, sections);
    ASSERT_FALSE(setting) << bad.text;
    EXPECT_EQ(setting.error().message, bad.message);
    EXPECT_EQ(setting.error().where, bad.where);
    EXPECT_EQ(setting.error().remedy, bad.remedy);
  }
}

TEST(Config, OptionsAsJson) {
  EXPECT_EQ(options_json(option_values(SampleOptions{})),
            R"({"cell_m":0.05,"profile":"gaussian","thin":true,"threshold":4})");
}

TEST(Config, SchemaOfTheOptions) {
  const auto specs = option_specs<SampleOptions>();
  EXPECT_EQ(option_schema("evidence", specs), R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "evidence",
  "type": "object",
  "additionalProperties": false,
  "properties": {
    "cell_m": {
      "type": "number",
      "default": 0.05,
      "minimum": 0.001,
      "maximum": 10.0,
      "description": "side of a cell",
      "unit": "m"
    },
    "threshold": {
      "type": "integer",
      "default": 4,
      "minimum": 1,
      "description": "votes",
      "source": "[Barshan07] 3.2"
    },
    "thin": {
      "type": "boolean",
      "default": true,
      "description": "keep the middle"
    },
    "profile": {
      "type": "string",
      "default": "gaussian",
      "enum": [
        "gaussian",
        "uniform"
      ],
      "description": "across the beam"
    }
  }
}
)");
}

}  // namespace
}  // namespace echoarc::io
