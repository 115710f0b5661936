// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/options.hpp"

#include <array>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

enum class Shape { round, square };
constexpr std::array<Choice<Shape>, 2> choices(Shape) {
  return {{{Shape::round, "round"}, {Shape::square, "square"}}};
}

struct SampleOptions {
  double cell_m = 0.05;
  int threshold = 4;
  bool strict = false;
  Angle beam_deg = degrees(25.0);
  Shape shape = Shape::round;

  static constexpr auto fields() {
    return std::tuple{
        field("cell_m", &SampleOptions::cell_m, {.unit = "m", .min = 0.001, .max = 10.0, .doc = "side of a cell"}),
        field("threshold", &SampleOptions::threshold, {.unit = "arcs", .min = 1, .max = 100, .doc = "votes"}),
        field("strict", &SampleOptions::strict, {.doc = "no mercy"}),
        field("beam_deg", &SampleOptions::beam_deg, {.unit = "deg", .min = 1, .max = 179, .doc = "full width"}),
        field("shape", &SampleOptions::shape, {.doc = "outline"})};
  }
};

TEST(Options, SpecsComeFromTheDeclaration) {
  const auto specs = option_specs<SampleOptions>();
  ASSERT_EQ(specs.size(), 5U);
  EXPECT_EQ(specs[0].name, "cell_m");
  EXPECT_EQ(legal_values(specs[0]), "0.001 to 10 m");
  EXPECT_EQ(to_text(specs[0].default_value), "0.05");
  EXPECT_EQ(legal_values(specs[2]), "true or false");
  EXPECT_EQ(to_text(specs[3].default_value), "25");
  EXPECT_EQ(legal_values(specs[4]), "round or square");
}

TEST(Options, SetFromTextAndReadBack) {
  SampleOptions options;
  for (const auto& [name, text] :
       {std::pair{"cell_m", "0.01"}, {"threshold", "7"}, {"strict", "true"}, {"beam_deg", "30"}, {"shape", "square"}}) {
    const auto specs = option_specs<SampleOptions>();
    const auto spec = std::ranges::find(specs, std::string_view(name), &OptionSpec::name);
    const auto value = parse_option(*spec, text);
    ASSERT_TRUE(value) << name;
    ASSERT_TRUE(set_option(options, name, *value)) << name;
  }
  EXPECT_EQ(options.cell_m, 0.01);
  EXPECT_EQ(options.threshold, 7);
  EXPECT_TRUE(options.strict);
  EXPECT_NEAR(options.beam_deg.deg(), 30.0, 1e-12);
  EXPECT_EQ(options.shape, Shape::square);
  const auto same = make_options<SampleOptions>(option_values(options));
  ASSERT_TRUE(same);
  EXPECT_EQ(option_values(*same), option_values(options));
}

TEST(Options, WrongValuesSayWhatIsLegal) {
  SampleOptions options;
  const auto out_of_range = set_option(options, "cell_m", 0.0);
  ASSERT_FALSE(out_of_range);
  EXPECT_EQ(out_of_range.error().message, "cell_m = 0 is not legal");
  EXPECT_EQ(out_of_range.error().remedy, "use 0.001 to 10 m (default 0.05)");
  EXPECT_FALSE(set_option(options, "threshold", 2.5));
  EXPECT_FALSE(set_option(options, "strict", 1.0));
  EXPECT_FALSE(set_option(options, "cell_m", std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(set_option(options, "shape", std::string("oval")));
  EXPECT_FALSE(parse_option(option_specs<SampleOptions>()[0], "0.1x"));
}

TEST(Options, UnknownNameSuggestsTheNearest) {
  SampleOptions options;
  const auto set = set_option(options, "treshold", std::int64_t{4});
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().remedy, "did you mean threshold?");
}

TEST(Options, ValidateFindsAFieldSetByHand) {
  EXPECT_TRUE(validate(SampleOptions{}));
  EXPECT_FALSE(validate(SampleOptions{.threshold = 0}));
}

}  // namespace
}  // namespace echoarc
