// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Sensing on the logs of real robots.
#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "echoarc/sensing/sensing.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

const std::string data = ECHOARC_SOURCE_DIR "/../shared/data/";

/// Numbers of a table, row by row; lines that do not begin with a number are skipped. Commas count as blanks.
std::vector<std::vector<double>> numbers_of(const std::string& path) {
  std::vector<std::vector<double>> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream stream(line);
    std::vector<double> row;
    for (double value = 0.0; stream >> value;) row.push_back(value);
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

/// Columns first ... first + count - 1 as the pings of sensors 0, 1, ..., in metres.
std::vector<Ping> pings_of(const std::vector<std::vector<double>>& rows, std::size_t first, std::size_t count,
                           double unit_m) {
  std::vector<Ping> pings;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < count; ++k)
      pings.push_back(test::ping_at(double(i), SensorId(k), rows[i].at(first + k) * unit_m));
  return pings;
}

struct Tally {
  std::size_t echoes = 0;
  std::size_t silent = 0;
  std::size_t rejected = 0;
};

Tally tally_of(const SensorArray& array, std::span<const Ping> pings) {
  const auto decisions = decide_no_echo(array, pings);
  Tally tally;
  for (const Ping& ping : pings) {
    const DecodedRange decoded = decode_range(ping.range_m, decisions[ping.rx], array.find(ping.rx)->model);
    ++(decoded.rejection ? tally.rejected : is_no_echo(decoded.outcome) ? tally.silent : tally.echoes);
  }
  return tally;
}

SensorArray sensors(int count, double range_max_m) {
  return SensorArray::make(row(count, 0.1, 0.0, test::model_of(0.15, range_max_m))).value();
}

class Corridor : public testing::TestWithParam<int> {};

TEST_P(Corridor, The5110IsNoEchoWhateverTheDescribedMaximum) {
  const std::string path = data + "corridor/run" + std::to_string(GetParam()) + "/sonar.txt";
  const auto rows = numbers_of(path);
  if (rows.empty()) GTEST_SKIP() << path << " is absent";
  const std::vector<Ping> pings = pings_of(rows, 1, 8, 0.001);
  const auto code = [](const Ping& ping) { return ping.range_m == 5110 * 0.001; };
  const auto silent = static_cast<std::size_t>(std::ranges::count_if(pings, code));
  for (const double range_max_m : {10.7, 5.11}) {
    const Tally tally = tally_of(sensors(8, range_max_m), pings);
    EXPECT_EQ(tally.silent, silent) << range_max_m;
    EXPECT_EQ(tally.echoes, pings.size() - silent);
    EXPECT_EQ(tally.rejected, 0U);
  }
}
INSTANTIATE_TEST_SUITE_P(RealLogs, Corridor, testing::Values(1, 2, 3));

TEST_P(Corridor, EveryPingBecomesAReadingAtItsOwnOdometry) {
  const std::string run = data + "corridor/run" + std::to_string(GetParam());
  const auto odometry = numbers_of(run + "/od.txt");
  const auto sonar = numbers_of(run + "/sonar.txt");
  if (odometry.empty() || sonar.empty()) GTEST_SKIP() << run << " is absent";
  Log log;
  log.robot.sensors = sensors(8, 5.1);
  for (const auto& row : odometry)
    log.odometry.push_back(
        {.time_s = row[0] * 1e-3, .T_world_robot = {{row[1] * 1e-3, row[2] * 1e-3}, degrees(row[3] * 0.1)}});
  for (const auto& row : sonar)
    for (std::size_t k = 0; k < 8; ++k)
      log.pings.push_back(test::ping_at(row[0] * 1e-3, SensorId(k), row[k + 1] * 1e-3));
  const SensedLog sensed = sense(log);
  EXPECT_EQ(sensed.report.accepted(), log.pings.size());
  EXPECT_EQ(sensed.report.rejected_pings.total(), 0U);
  EXPECT_EQ(sensed.report.rejected_odometry.total(), 0U);
  for (const Reading& reading : sensed.readings) {
    EXPECT_EQ(reading.scan, reading.ping / 8) << "a row is a sweep";
    EXPECT_EQ(reading.T_world_robot, log.odometry[reading.ping / 8].T_world_robot);
  }
}

TEST(RealLogs, CorridorSentence) {
  const auto rows = numbers_of(data + "corridor/run1/sonar.txt");
  if (rows.empty()) GTEST_SKIP() << data << "corridor/run1 is absent";
  EXPECT_EQ(
      decide_no_echo(sensors(8, 10.7), pings_of(rows, 1, 8, 0.001))[4].sentence,
      "sensor 4: 5.11 m (332 of 413 readings) is read as no echo: the most frequent value and nothing lies beyond "
      "it");
}

TEST(RealLogs, CorridorReadInMillimetresIsRejected) {
  const auto rows = numbers_of(data + "corridor/run1/sonar.txt");
  if (rows.empty()) GTEST_SKIP() << data << "corridor/run1 is absent";
  const std::vector<Ping> pings = pings_of(rows, 1, 8, 1.0);
  EXPECT_EQ(tally_of(sensors(8, 10.7), pings).rejected, pings.size());
}

TEST(RealLogs, ScitosFiveMetresAreNoEcho) {
  const auto rows = numbers_of(data + "scitos/sensor_readings_24.data");
  if (rows.empty()) GTEST_SKIP() << data << "scitos is absent";
  const std::vector<Ping> pings = pings_of(rows, 0, 24, 1.0);
  const auto far = [](const Ping& ping) { return ping.range_m >= 4.9995; };
  const auto silent = static_cast<std::size_t>(std::ranges::count_if(pings, far));
  for (const double range_max_m : {10.7, 5.0}) {
    const Tally tally = tally_of(sensors(24, range_max_m), pings);
    EXPECT_EQ(tally.silent, silent) << range_max_m;
    EXPECT_EQ(tally.rejected, 0U);
  }
}

TEST(RealLogs, GardenFromFiveMetresIsNoEcho) {
  const auto rows = numbers_of(data + "garden/drive.csv");
  if (rows.empty()) GTEST_SKIP() << data << "garden is absent";
  const std::vector<Ping> pings = pings_of(rows, 3, 2, 0.01);
  const auto far = [](const Ping& ping) { return ping.range_m >= 5.0; };
  const auto silent = static_cast<std::size_t>(std::ranges::count_if(pings, far));
  ASSERT_GT(silent, 0U);
  EXPECT_EQ(tally_of(sensors(2, 5.0), pings).silent, silent);
  const SensorArray stated =
      SensorArray::make(row(2, 0.1, 0.0, test::model_of(0.02, 10.7, {NoEchoRule::Kind::above, 5.0}))).value();
  EXPECT_EQ(tally_of(stated, pings).silent, silent);
}

}  // namespace
}  // namespace echoarc
