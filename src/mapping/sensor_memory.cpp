// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/sensor_memory.hpp"

#include <cassert>
#include <vector>

namespace echoarc {

void SensorMemory::leaves(const Reading& reading, const Remains& remains) {
  Sensor& sensor = sensors_[key_of(reading)];
  assert(!sensor.in_ring.empty());
  sensor.in_ring.pop_front();
  if (remains.dead) return;
  sensor.left.push_back({remains.arc().t_begin(), remains.arc().t_end()});
  if (sensor.left.size() > arcs_) sensor.left.pop_front();
}

std::optional<SurvivalProfile> SensorMemory::profile(const Reading& reading, const CarvedRing& ring,
                                                     Angle half_width) const {
  const auto found = sensors_.find(key_of(reading));
  if (found == sensors_.end()) return std::nullopt;
  const Sensor& sensor = found->second;
  std::vector<AngleInterval> newest;
  for (auto slot = sensor.in_ring.rbegin(); slot != sensor.in_ring.rend() && newest.size() < arcs_; ++slot) {
    const Remains& remains = ring.remains(*slot);
    if (!remains.dead && remains.carved()) newest.push_back({remains.arc().t_begin(), remains.arc().t_end()});
  }
  for (auto left = sensor.left.rbegin(); left != sensor.left.rend() && newest.size() < arcs_; ++left)
    newest.push_back(*left);
  if (newest.size() < least_) return std::nullopt;
  return SurvivalProfile::of(newest, half_width);
}

void SensorMemory::save(ByteWriter& out) const {
  out.put<std::uint64_t>(sensors_.size());
  for (const auto& [key, sensor] : sensors_) {
    out.put(key);
    out.put_vector(std::vector<AngleInterval>(sensor.left.begin(), sensor.left.end()));
  }
}

bool SensorMemory::restore(ByteReader& in) {
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    const auto key = in.get<std::uint64_t>();
    const auto left = in.get_vector<AngleInterval>();
    if (left.size() > arcs_) return false;
    sensors_[key].left.assign(left.begin(), left.end());
  }
  return in.ok();
}

}  // namespace echoarc
