// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/statistics.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/timing.hpp"

namespace echoarc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Statistics, Median) {
  EXPECT_EQ(median(std::vector{3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median(std::vector{4.0, 1.0, 3.0, 2.0}), 2.5);
  EXPECT_EQ(median(std::vector{7.0}), 7.0);
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_TRUE(std::isnan(median(std::vector{1.0, nan})));
}

TEST(Statistics, PercentileIsOneOfTheValues) {
  std::vector<double> values(20);
  std::iota(values.rbegin(), values.rend(), 1.0);  // 20 ... 1
  EXPECT_EQ(percentile(values, 0.95), 19.0) << "19 of 20 values do not exceed 19";
  EXPECT_EQ(percentile(values, 0.951), 20.0);
  EXPECT_EQ(percentile(values, 1.0), 20.0);
  EXPECT_EQ(percentile(values, 0.01), 1.0);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5)));
  EXPECT_TRUE(std::isnan(percentile(std::vector{nan, 1.0}, 0.5)));
}

TEST(Statistics, Mean) {
  EXPECT_EQ(mean(std::vector{1.0, 2.0, 6.0}), 3.0);
  EXPECT_TRUE(std::isnan(mean({})));
}

TEST(Timing, MediansAreTakenFigureByFigure) {
  const std::vector<Timing> runs = {{1.0, 0.5, 1000}, {2.0, 0.1, 1000}, {9.0, 0.3, 1000}};
  const TimingSummary summary = summarise(runs);
  EXPECT_EQ(summary.runs, 3U);
  EXPECT_EQ(summary.readings, 1000U);
  EXPECT_EQ(summary.insert_cpu_s, 2.0);
  EXPECT_EQ(summary.finish_cpu_s, 0.3);
  EXPECT_NEAR(summary.total_cpu_s, 2.1, 1e-12) << "of 1.5, 2.1 and 9.3; not the sum of the medians";
  EXPECT_NEAR(summary.per_reading_s, 0.0021, 1e-12);
}

TEST(Timing, WithoutReadingsOrRunsThereIsNoFigure) {
  EXPECT_TRUE(std::isnan(Timing{}.per_reading_s()));
  const TimingSummary summary = summarise({});
  EXPECT_EQ(summary.runs, 0U);
  EXPECT_TRUE(std::isnan(summary.total_cpu_s));
}

}  // namespace
}  // namespace echoarc
