// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/registers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/silence.hpp"

namespace echoarc::sim {
namespace {

struct Update {
  double time_s = 0.0;
  std::size_t sensor = 0;
  double value_m = 0.0;
};

std::vector<Update> updates_of(const SensorArray& array, std::span<const Ping> pings, double speed_m_s) {
  std::vector<Update> updates;
  updates.reserve(pings.size());
  for (const Ping& ping : pings) {
    if (ping.echo_index > 0) continue;
    const Sensor* sensor = array.find(ping.rx);
    const double flight_s =
        std::isnan(ping.time_of_flight_s) ? 2.0 * sensor->model.range_max_m / speed_m_s : ping.time_of_flight_s;
    updates.push_back(
        {ping.time_s + flight_s, static_cast<std::size_t>(sensor - array.sensors().data()), ping.range_m});
  }
  std::ranges::stable_sort(updates, {}, &Update::time_s);
  return updates;
}

}  // namespace

std::vector<Poll> poll_registers(const SensorArray& array, std::span<const Ping> pings, double rate_hz, double end_s,
                                 double speed_of_sound_m_s) {
  const std::vector<Update> updates = updates_of(array, pings, speed_of_sound_m_s);
  std::vector<double> registers_m;
  for (const Sensor& sensor : array.sensors()) registers_m.push_back(silence_m(sensor.model));
  std::vector<Poll> polls;
  auto next = updates.begin();
  for (std::uint64_t k = 0; static_cast<double>(k) <= end_s * rate_hz; ++k) {
    const double time_s = static_cast<double>(k) / rate_hz;
    for (; next != updates.end() && next->time_s <= time_s; ++next) registers_m[next->sensor] = next->value_m;
    polls.push_back({.time_s = time_s, .ranges_m = registers_m});
  }
  return polls;
}

}  // namespace echoarc::sim
