// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/registers.hpp"

#include <algorithm>
#include <cmath>

#include "sim/silence.hpp"

namespace echoarc::sim {

Registers::Registers(const SensorArray& array, double speed_of_sound_m_s)
    : array_(&array), speed_of_sound_m_s_(speed_of_sound_m_s) {
  for (const Sensor& sensor : array.sensors()) values_m_.push_back(silence_m(sensor.model));
}

void Registers::hear(const Ping& ping) {
  if (ping.echo_index > 0) return;
  const Sensor* sensor = array_->find(ping.rx);
  const double flight_s =
      std::isnan(ping.time_of_flight_s) ? 2.0 * sensor->model.range_max_m / speed_of_sound_m_s_ : ping.time_of_flight_s;
  const Update update{ping.time_s + flight_s, static_cast<std::size_t>(sensor - array_->sensors().data()),
                      ping.range_m};
  updates_.insert(std::ranges::upper_bound(updates_, update.time_s, {}, &Update::time_s), update);
}

const std::vector<double>& Registers::at(double time_s) {
  for (; !updates_.empty() && updates_.front().time_s <= time_s; updates_.pop_front())
    values_m_[updates_.front().sensor] = updates_.front().value_m;
  return values_m_;
}

std::vector<Poll> poll_registers(const SensorArray& array, std::span<const Ping> pings, double rate_hz, double end_s,
                                 double speed_of_sound_m_s) {
  Registers registers(array, speed_of_sound_m_s);
  std::vector<Poll> polls;
  auto next = pings.begin();
  for (std::uint64_t k = 0; static_cast<double>(k) <= end_s * rate_hz; ++k) {
    const double time_s = static_cast<double>(k) / rate_hz;
    for (; next != pings.end() && next->time_s <= time_s; ++next) registers.hear(*next);
    polls.push_back({.time_s = time_s, .ranges_m = registers.at(time_s)});
  }
  return polls;
}

}  // namespace echoarc::sim
