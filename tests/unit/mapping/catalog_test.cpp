// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/catalog.hpp"

#include <set>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

TEST(Catalog, NamesAreUniqueAndEntriesComplete) {
  std::set<std::string_view> names;
  for (const MethodEntry& entry : catalog()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(find_method(entry.name), &entry);
    EXPECT_FALSE(entry.title.empty());
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_FALSE(entry.source.empty());
    for (const OptionSpec& spec : entry.specs()) {
      EXPECT_FALSE(spec.doc.empty()) << entry.name << "." << spec.name;
      EXPECT_TRUE(check_option(spec, spec.default_value)) << entry.name << "." << spec.name << ": default out of range";
    }
  }
  for (const std::string_view name : {"centerline", "vt", "dm", "mp", "bu", "evidence", "himm", "numakura", "limited",
                                      "atm_org", "atm_mod", "atm_silver", "carve", "carved_grid", "combined"})
    EXPECT_TRUE(names.contains(name)) << name << " is in files and URLs: it must not go away";
}

TEST(Catalog, MakesMethodsWithOptionsAndRestoresThem) {
  for (const MethodEntry& entry : catalog()) {
    InlineExecutor here;
    Reading reading;
    reading.outcome = Echo{1.0};
    auto method = make_method(entry.name);
    ASSERT_TRUE(method) << entry.name;
    EXPECT_EQ(method->name(), entry.name);
    method->insert(std::span(&reading, 1), here);
    method->finish(here);
    EXPECT_EQ(method->counters().used, 1U);
    const auto again = entry.restore(method->save());
    ASSERT_TRUE(again) << entry.name;
    EXPECT_EQ(again->save(), method->save());
    EXPECT_EQ(again->options(), method->options());
  }
}

TEST(Catalog, RefusesUnknownNamesAndValues) {
  const auto unknown = make_method("magic");
  ASSERT_FALSE(unknown);
  for (const MethodEntry& entry : catalog())
    EXPECT_NE(unknown.error().remedy.find(entry.name), std::string::npos) << entry.name;
  const auto bad = make_method("evidence", {{"cell_m", -1.0}});
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().where, "cell_m");
}

}  // namespace
}  // namespace echoarc
