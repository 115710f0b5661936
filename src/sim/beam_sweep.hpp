// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/world_model.hpp"

namespace echoarc::sim {

/// A sector of sight: the points eye + z (forward + u aside) with z > 0 and low <= u <= high. `forward` and `aside` are
/// unit vectors at right angles. A reflected beam starts at its mirror.
struct Beam {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  Vec2 eye;
  Vec2 forward;
  Vec2 aside;
  double low = 0.0;
  double high = 0.0;
  double reach_m = 0.0;         ///< distance from the eye
  bool inward = false;          ///< sound comes to the eye: one-sided walls stop it that stand with their backs to it
  std::uint32_t mirror = none;  ///< the wall that the beam left last
  Vec2 mirror_point;
  Vec2 mirror_normal;  ///< towards the lit side

  /// Depth z and slope u of a point.
  struct Place {
    double z = 0.0;
    double u = 0.0;
  };
};

/// A straight piece as a beam sees it: from (u1, z1) to (u2, z2), u1 <= u2.
struct Sight {
  double u1 = 0.0;
  double z1 = 0.0;
  double u2 = 0.0;
  double z2 = 0.0;
};

/// How deep a beam is open, in slices of equal slope: what lies deeper stands behind a wall.
class BeamDepth {
 public:
  static constexpr int slices = 32;

  void open(const Beam& beam);
  /// Nothing passes this wall.
  void close(const Sight& wall);
  /// Whether something that stands no deeper than `sight` may be seen, and between which slopes, to whole slices.
  [[nodiscard]] bool may_see(const Sight& sight, double slack_m, double& low, double& high) const;
  [[nodiscard]] bool may_see(double u, double z) const;
  [[nodiscard]] double depth(int slice) const { return slice_[static_cast<std::size_t>(slice)].depth; }
  [[nodiscard]] double slope(int border) const { return low_ + border * width_; }

 private:
  struct Slice {
    double depth = 0.0;
    // Walls that cover a part of the slice from either of its borders; two that meet cover it together.
    double left_to = 0.0;
    double left_depth = 0.0;
    double right_from = 0.0;
    double right_depth = 0.0;
  };
  [[nodiscard]] int slice_at(double u) const;

  double low_ = 0.0;
  double width_ = 0.0;
  double per_width_ = 0.0;
  std::array<Slice, slices> slice_{};
};

/// Something that a beam may light.
struct Lit {
  std::uint32_t item = 0;
  double low = 0.0;  ///< slopes between which it may be lit
  double high = 0.0;
};

/// Finds what a beam may light: everything that is seen from its eye within it, and little else. Walks the grid from
/// near to far and stops where walls close the beam.
class BeamSweep {
 public:
  struct Found {
    std::uint32_t item = 0;
    Sight sight;
    double slack_m = 0.0;
  };

  explicit BeamSweep(const WorldModel& world);

  /// Items in the order found. Adds the number of items looked at to `work`.
  void sweep(const Beam& beam, BeamDepth& depth, std::vector<Lit>& lit, std::uint64_t& work);

 private:
  void look_at(const Beam& beam, BeamDepth& depth, std::uint32_t item);
  void look_at_wall(const Beam& beam, BeamDepth& depth, std::uint32_t item);
  void look_at_box(const Beam& beam, std::uint32_t item, Vec2 centre, double radius_m);

  const WorldModel* world_;
  std::vector<std::uint32_t> seen_in_;  // of every item, the last sweep that met it
  std::uint32_t sweep_ = 0;
  std::vector<Found> found_;
};

}  // namespace echoarc::sim
