// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "echoarc/core/bytes.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/mapping/consensus_options.hpp"

namespace echoarc::consensus {

/// A sensor looked there and heard nothing from nearer than `range_m`.
struct Look {
  Vec2 origin;  ///< the sensor, world
  Vec2 axis;    ///< unit vector
  double range_m = 0.0;
};

/// The looks of a drive, echoes and silence alike, thinned as step A thins arcs. A bistatic reading is none.
class LookTable {
 public:
  /// After `arcs` arcs. Silence counts as far as it is trusted; what is beyond `range_max_m` does not matter.
  void add(const Reading& reading, const ConsensusOptions& options, std::size_t arcs);

  [[nodiscard]] std::size_t size() const { return looks_.size(); }
  /// Those from arc `from` on.
  [[nodiscard]] std::span<const Look> since(std::size_t from) const;
  /// Forgets those before arc `count`; arcs after it move up.
  void forget(std::size_t count);

  void save(ByteWriter& out) const;
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  std::vector<Look> looks_;
  std::vector<std::uint32_t> arcs_;  // before each look
  std::map<SensorId, Look> last_;    // kept of a sensor
};

}  // namespace echoarc::consensus
