// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/maps/neighbour_filter.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

bool has_neighbour_filter(const MethodEntry& entry) {
  return std::ranges::any_of(entry.specs(), [](const OptionSpec& spec) { return spec.name == "min_neighbours"; });
}

PointMap points_of(const MethodEntry& entry, const OptionMap& options) {
  AnyMethod method = *entry.make(options);
  Rng rng(3);
  InlineExecutor executor;
  method.insert(test::wall_drive(rng, 40), executor);
  method.finish(executor);
  return method.export_map()->points;
}

TEST(NeighbourOption, IsOfferedByTheMethodsWhoseMapIsPoints) {
  std::set<std::string_view> offering;
  for (const MethodEntry& entry : catalog())
    if (has_neighbour_filter(entry)) offering.insert(entry.name);
  EXPECT_EQ(offering, (std::set<std::string_view>{"centerline", "atm_org", "atm_mod", "atm_silver", "carve", "tbf",
                                                  "combined", "consensus"}));
}

TEST(NeighbourOption, HandsOutThePointsThatHaveCompany) {
  for (const MethodEntry& entry : catalog()) {
    if (!has_neighbour_filter(entry)) continue;
    const PointMap all = points_of(entry, {});
    const PointMap kept = points_of(entry, {{"min_neighbours", 3.0}, {"neighbour_radius_m", 0.05}});
    const PointMap expected = with_neighbours(all, {.min_neighbours = 3, .radius_m = 0.05});
    ASSERT_EQ(kept.size(), expected.size()) << entry.name;
    EXPECT_LT(kept.size(), all.size()) << entry.name;
    EXPECT_GT(kept.size(), 0U) << entry.name;
    for (std::size_t k = 0; k < kept.size(); ++k)
      EXPECT_EQ(kept.points()[k].position, expected.points()[k].position) << entry.name;
  }
}

}  // namespace
}  // namespace echoarc
