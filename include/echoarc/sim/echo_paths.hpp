// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/echo_cause.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// One way that sound takes from a transmitter to a receiver. Bearings in the world frame, without any beam: the level
/// at which it is heard is the matter of `acoustics`.
struct EchoPath {
  double length_m = 0.0;
  Angle departure;       ///< bearing of the first leg at the transmitter
  Angle arrival;         ///< bearing from the receiver to where the last leg comes from
  double gain_db = 0.0;  ///< reflections, curvature, diffraction; <= 0 but for concave curves
  EchoCause cause = EchoCause::wall;
  std::uint8_t reflections = 1;
};

/// A transducer as the search sees it: paths that leave or arrive further than `half_window` off its axis are not
/// looked for.
struct Transducer {
  Vec2 position;
  Angle axis;
  Angle half_window = degrees(25.0);
};

struct PathLimits {
  static constexpr int highest_order = 6;
  int max_order = 3;           ///< most reflections on walls, 1 ... highest_order
  double max_length_m = 21.4;  ///< longer paths are not looked for
  double edge_gain_db = -15.0;
};

/// Finds the echo paths of pings by the method of images. One per thread: it keeps its buffers.
class PathFinder {
 public:
  /// Images tried per ping at most; beyond it the search ends and `truncated` counts. The bound on the work of a ping.
  static constexpr std::size_t max_images = 100'000;

  /// `world` must outlive the finder.
  explicit PathFinder(const World& world) : world_(&world) {}

  /// All paths from `transmitter` to `receiver`, in the order of their lengths (ties: by cause, then departure).
  /// Valid until the next call.
  [[nodiscard]] std::span<const EchoPath> find(const Transducer& transmitter, const Transducer& receiver,
                                               const PathLimits& limits, std::span<const Disc> moving = {});

  [[nodiscard]] std::uint64_t truncated() const { return truncated_; }

 private:
  const World* world_;
  std::vector<EchoPath> paths_;
  std::uint64_t truncated_ = 0;
};

}  // namespace echoarc::sim
