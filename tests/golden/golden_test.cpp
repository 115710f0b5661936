// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Whole runs over a made-up log of a ring of sonars in a room, pinned (it is older than the simulator and stays as it
// is): one line per method with its counts and a hash of everything it hands over, values rounded to 1e-6. The lines in
// room.txt were written by this program:
//
//     ECHOARC_GOLDEN=write build/dev/tests/golden/golden_test

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/io/read_log.hpp"
#include "echoarc/io/run_report.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/pipeline/pipeline.hpp"
#include "host/thread_pool.hpp"

namespace echoarc {
namespace {

const std::string expected_path = ECHOARC_SOURCE_DIR "/tests/golden/room.txt";
const std::string log_path = ECHOARC_SOURCE_DIR "/examples/demo/room.jsonl";

/// Feeds numbers to a hash, so rounded that the last bits of a compiler's arithmetic do not matter.
class RoundedHash {
 public:
  void add(std::int64_t value) { hash_.add({reinterpret_cast<const char*>(&value), sizeof(value)}); }
  void add(double value) {
    constexpr std::int64_t not_finite = std::int64_t{1} << 62;
    add(std::isfinite(value) ? std::int64_t{std::llround(1e6 * value)} : not_finite);
  }
  void add(const GridGeometry& geometry, std::int32_t width, std::int32_t height) {
    add(geometry.cell_m);
    add(geometry.origin.x);
    add(geometry.origin.y);
    add(std::int64_t{width});
    add(std::int64_t{height});
  }
  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  io::Fnv1a64 hash_;
};

void add_points(RoundedHash& hash, const PointMap& map) {
  for (const MapPoint& point : map.points()) {
    hash.add(point.position.x);
    hash.add(point.position.y);
    hash.add(static_cast<std::int64_t>(point.label));
    hash.add(point.bound_m);
    hash.add(point.time_s);
    hash.add(std::int64_t{point.sensor});
    hash.add(static_cast<std::int64_t>(point.ping));
    for (const PingId ping : map.support(point)) hash.add(static_cast<std::int64_t>(ping));
  }
}

template <class T>
void add_grid(RoundedHash& hash, const DenseGrid<T>& grid) {
  hash.add(grid.geometry(), grid.width(), grid.height());
  for (const T value : grid.values()) hash.add(static_cast<double>(value));
}
void add_grid(RoundedHash&, std::monostate) {}

/// "points occupied free hash"
std::string fingerprint(const MapExport& map) {
  RoundedHash hash;
  add_points(hash, map.points);
  hash.add(map.states.geometry(), map.states.width(), map.states.height());
  std::size_t free = 0;
  std::size_t occupied = 0;
  for (const CellState state : map.states.values()) {
    hash.add(static_cast<std::int64_t>(state));
    free += state == CellState::free ? 1 : 0;
    occupied += state == CellState::occupied ? 1 : 0;
  }
  std::visit([&](const auto& values) { add_grid(hash, values); }, map.values);
  std::ostringstream text;
  text << map.points.size() << ' ' << occupied << ' ' << free << ' ' << std::hex << hash.value();
  return text.str();
}

/// Fingerprint of every method of the catalogue with its defaults.
std::map<std::string, std::string> run_all(const Log& log, std::size_t threads) {
  std::vector<AnyMethod> methods;
  for (const MethodEntry& entry : catalog()) methods.push_back(make_method(entry.name).value());
  host::ThreadPool pool(threads);
  (void)run_log(log, {}, methods, pool);
  std::map<std::string, std::string> fingerprints;
  for (const AnyMethod& method : methods)
    fingerprints[std::string(method.name())] = fingerprint(method.export_map().value());
  return fingerprints;
}

std::map<std::string, std::string> read_expected() {
  std::map<std::string, std::string> expected;
  std::ifstream file(expected_path);
  for (std::string line; std::getline(file, line);)
    if (!line.starts_with('#')) expected[line.substr(0, line.find(' '))] = line.substr(line.find(' ') + 1);
  return expected;
}

void write_expected(const std::map<std::string, std::string>& fingerprints) {
  std::ofstream file(expected_path);
  file << "# Written by golden_test, see there. Method, points, occupied cells, free cells, hash.\n";
  for (const auto& [method, line] : fingerprints) file << method << ' ' << line << '\n';
}

constexpr const char* explanation =
    "\nThe map of this method on examples/demo/room.jsonl is no longer what it was (points, occupied cells, free "
    "cells, "
    "hash).\nIf the change is meant, say in the commit why the map is better, and write the new values with\n"
    "    ECHOARC_GOLDEN=write build/dev/tests/golden/golden_test\n"
    "If it is not, some commit since the last change of tests/golden/room.txt altered the result.";

TEST(Golden, DemoRoom) {
  const Result<Log> log = io::read_log(log_path);
  ASSERT_TRUE(log) << log.error().message;
  const std::map<std::string, std::string> one = run_all(*log, 1);
  EXPECT_EQ(run_all(*log, 2), one) << "the maps depend on the number of threads";
  EXPECT_EQ(run_all(*log, 8), one) << "the maps depend on the number of threads";
  const char* mode = std::getenv("ECHOARC_GOLDEN");
  if (mode != nullptr && std::string(mode) == "write") {
    write_expected(one);
    GTEST_SKIP() << "wrote " << expected_path;
  }
  const std::map<std::string, std::string> expected = read_expected();
  for (const MethodEntry& entry : catalog()) {
    const std::string name(entry.name);
    ASSERT_TRUE(expected.contains(name)) << name << " is not in " << expected_path << explanation;
    EXPECT_EQ(one.at(name), expected.at(name)) << name << explanation;
  }
  EXPECT_EQ(expected.size(), catalog().size()) << expected_path << " names a method that no longer exists";
}

}  // namespace
}  // namespace echoarc
