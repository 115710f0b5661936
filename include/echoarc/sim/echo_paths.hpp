// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <span>

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
///
/// A transducer on a wall (within 1e-9 m of its line) hears nothing of that wall; one inside a disc hears nothing at
/// all from outside. Swapping transmitter and receiver swaps departures and arrivals and changes nothing else, as long
/// as no wall is one-sided.
class PathFinder {
 public:
  /// The bound on the work of a ping: images tried, and walls looked at in the search for them and for obstacles.
  /// Beyond either the search ends with what it has, and `truncated` counts.
  static constexpr std::uint64_t max_images = 100'000;
  static constexpr std::uint64_t max_items = 5'000'000;

  /// `world` must outlive the finder.
  explicit PathFinder(const World& world);
  PathFinder(PathFinder&& other) noexcept;
  PathFinder& operator=(PathFinder&& other) noexcept;
  ~PathFinder();

  /// All paths from `transmitter` to `receiver`, in the order of their lengths (ties: by cause, then departure).
  /// Valid until the next call. An order outside of 1 ... `highest_order` counts as the nearest legal one; a
  /// transducer without a finite place and axis hears nothing.
  ///
  /// Every way is listed once. From one place into an acute corner sound goes round both ways: two paths of one length,
  /// departures and arrivals swapped. Into a right corner both go through the apex and are one path.
  [[nodiscard]] std::span<const EchoPath> find(const Transducer& transmitter, const Transducer& receiver,
                                               const PathLimits& limits, std::span<const Disc> moving = {});

  /// Pings that met the bound.
  [[nodiscard]] std::uint64_t truncated() const { return truncated_; }

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
  std::uint64_t truncated_ = 0;
};

}  // namespace echoarc::sim
