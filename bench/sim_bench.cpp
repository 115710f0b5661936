// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Echo paths of one ping, sender and receiver in one place: on a small floor and in a building a hundred times as
// large, smooth and rough. Levels are computed, too: what the simulator asks for every ping.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/sim/acoustics.hpp"
#include "echoarc/sim/office_floor.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;
using namespace echoarc::sim;

constexpr double max_length_m = 21.4;
constexpr std::size_t places = 4096;

/// The smallest floor tried that has this many walls.
std::shared_ptr<const World> office(double walls, bool rough) {
  WorldDescription description{.materials = {{}, {.rough_db = -18.0}}};
  OfficeFloorOptions options{.area_m2 = 100.0, .rough_share = rough ? 1.0 : 0.0};
  do {
    options.area_m2 *= 1.1;
    description.walls = make_office_floor(options, 0, 1).value().walls;
  } while (static_cast<double>(description.walls.size()) < walls);
  return std::make_shared<const World>(World::make(std::move(description)).value());
}

/// Where a robot may stand, and any direction.
std::vector<Transducer> stands(const World& world, Angle half_window) {
  Vec2 low = world.description().walls.front().a;
  Vec2 high = low;
  for (const Wall& wall : world.description().walls) {
    low = {std::min(low.x, wall.a.x), std::min(low.y, wall.a.y)};
    high = {std::max(high.x, wall.a.x), std::max(high.y, wall.a.y)};
  }
  Rng rng(1);
  std::vector<Transducer> result;
  while (result.size() < places) {
    const Vec2 place{rng.uniform(low.x, high.x), rng.uniform(low.y, high.y)};
    if (world.clearance(place, 0.3) >= 0.25)
      result.push_back({place, degrees(rng.uniform(-180.0, 180.0)), half_window});
  }
  return result;
}

void ping(benchmark::State& state, const World& world, int max_order) {
  const Acoustics acoustics{SonarOptions{.max_order = max_order}};
  const std::vector<Transducer> ears = stands(world, acoustics.half_window());
  const PathLimits limits = acoustics.limits(max_length_m);
  PathFinder finder(world);
  double loudest_db = -1e9;
  std::size_t paths = 0;
  for (auto _ : state)
    for (const Transducer& ear : ears) {
      const auto found = finder.find(ear, ear, limits);
      paths += found.size();
      for (const EchoPath& path : found)
        loudest_db = std::max(loudest_db, acoustics.level_db(path, ear.axis, ear.axis));
    }
  consume(loudest_db);
  const double pings = static_cast<double>(state.iterations()) * static_cast<double>(places);
  state.counters["pings_per_second"] = benchmark::Counter(pings, benchmark::Counter::kIsRate);
  state.counters["paths"] = static_cast<double>(paths) / pings;
  state.counters["walls"] = static_cast<double>(world.description().walls.size());
}

void add(const std::string& name, const std::shared_ptr<const World>& world, int max_order) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    ping(state, *world, max_order);
  })->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  const auto building = office(20'000.0, false);
  add("sim_200_walls", office(200.0, false), 2);
  add("sim_20000_walls", building, 2);
  add("sim_20000_walls_order_3", building, 3);
  add("sim_200_rough_walls", office(200.0, true), 2);
  add("sim_20000_rough_walls", office(20'000.0, true), 2);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
