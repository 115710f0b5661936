// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>

#include "mapping/carved_ring.hpp"
#include "mapping/survival_profile.hpp"

namespace echoarc {

/// The recent arcs of every sensor (of every pair of transmitter and receiver), for their survival profiles.
class SensorMemory {
 public:
  SensorMemory(std::size_t arcs, std::size_t least) : arcs_(arcs), least_(least) {}

  void entered(const Reading& reading, ArcSlot slot) { sensors_[key_of(reading)].in_ring.push_back(slot); }
  /// The sensor's oldest arc of the ring leaves it.
  void leaves(const Reading& reading, const Remains& remains);

  /// Of the sensor's newest arcs that were carved or have left the ring, and were not removed. None when there are too
  /// few.
  [[nodiscard]] std::optional<SurvivalProfile> profile(const Reading& reading, const CarvedRing& ring,
                                                       Angle half_width) const;

  [[nodiscard]] std::size_t memory_bytes() const { return sensors_.size() * (1024 + arcs_ * sizeof(AngleInterval)); }
  /// What has left the ring; the arcs in it `entered` again when it is restored.
  void save(ByteWriter& out) const;
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  struct Sensor {
    std::deque<ArcSlot> in_ring;     // oldest first
    std::deque<AngleInterval> left;  // oldest first
  };
  [[nodiscard]] static std::uint64_t key_of(const Reading& reading) {
    return (std::uint64_t{reading.tx} << 32U) | reading.rx;
  }

  std::size_t arcs_;
  std::size_t least_;
  std::map<std::uint64_t, Sensor> sensors_;
};

}  // namespace echoarc
