// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/scan_numbering.hpp"

#include <gtest/gtest.h>

#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

TEST(ScanNumbering, ASensorThatComesAgainBeginsAScan) {
  ScanNumbering scans;
  std::vector<std::uint32_t> numbers;
  for (int k = 0; k < 9; ++k) numbers.push_back(scans.number(test::ping_at(0.04 * k, SensorId(k % 3), 1.0)));
  EXPECT_EQ(numbers, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1, 2, 2, 2}));
}

TEST(ScanNumbering, SensorsOfOneStampAreOneScan) {
  ScanNumbering scans;
  std::vector<std::uint32_t> numbers;
  // Rows of a table in which some cells are empty: sensors 0, 1 at t = 0, then 2, 3 at t = 1, then 0 ... 3 at t = 2.
  for (const auto& [t, sensor] : {std::pair{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 0}, {2, 1}, {2, 2}, {2, 3}})
    numbers.push_back(scans.number(test::ping_at(t, SensorId(sensor), 1.0)));
  EXPECT_EQ(numbers, (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2, 2, 2}));
}

TEST(ScanNumbering, AllReceiversOfASweepAreOneScan) {
  ScanNumbering scans;
  for (int sweep = 0; sweep < 3; ++sweep)
    for (SensorId tx = 0; tx < 3; ++tx)
      for (SensorId rx = 0; rx < 3; ++rx) {
        Ping ping = test::ping_at(0.12 * sweep + 0.04 * tx, rx, 1.0);
        ping.tx = tx;
        EXPECT_EQ(scans.number(ping), std::uint32_t(sweep)) << tx << " " << rx;
      }
}

TEST(ScanNumbering, RepeatsMeansSameTimeSensorsAndValue) {
  ScanNumbering scans;
  EXPECT_FALSE(scans.repeats(test::ping_at(1.0, 0, 2.0)));
  (void)scans.number(test::ping_at(1.0, 0, 2.0));
  (void)scans.number(test::ping_at(1.0, 1, test::nan));
  EXPECT_TRUE(scans.repeats(test::ping_at(1.0, 0, 2.0)));
  EXPECT_TRUE(scans.repeats(test::ping_at(1.0, 1, test::nan)));
  EXPECT_FALSE(scans.repeats(test::ping_at(1.0, 0, 2.1))) << "coarse stamps: two pings within one tick";
  EXPECT_FALSE(scans.repeats(test::ping_at(1.1, 0, 2.0)));
  EXPECT_FALSE(scans.repeats(test::ping_at(1.0, 2, 2.0)));
}

}  // namespace
}  // namespace echoarc
