// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/sim/echo_paths.hpp"
#include "sim/beam_sweep.hpp"
#include "sim/mirror.hpp"

namespace echoarc::sim {

/// What stands before a transducer: its window in sectors of at most 60 degrees, each swept once.
class View {
 public:
  struct Sector {
    Beam beam;
    BeamDepth depth;
    std::vector<Lit> lit;
  };

  /// `inward`: for what comes to the eye, not what goes out from it.
  void look(const Transducer& eye, bool inward, double reach_m, BeamSweep& sweep, std::uint64_t& work);
  [[nodiscard]] std::span<const Sector> sectors() const { return std::span(sectors_).first(count_); }
  /// False only for points that are outside of the window or hidden.
  [[nodiscard]] bool may_see(Vec2 point) const;

 private:
  std::vector<Sector> sectors_;  // kept with their buffers
  std::size_t count_ = 0;
};

/// The beam after its reflection on a wall of which it lights the slopes `low` to `high`.
[[nodiscard]] Beam reflected(const Beam& beam, std::uint32_t wall, const Mirror& mirror, double low, double high);

}  // namespace echoarc::sim
