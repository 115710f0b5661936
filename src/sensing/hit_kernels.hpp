// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The loop over laser returns, compiled once per instruction set (cmake/EchoarcKernels.cmake). This header and the
// kernel source include nothing that holds inline functions: two copies of one, compiled with different flags, must
// never meet in the linker.

#include <cstddef>

namespace echoarc::kernels {

inline constexpr std::size_t hit_lanes = 8;

/// A beam: what lies in front of the apex with |cross| <= slope dot of its axis.
struct BeamCone {
  double apex_x;
  double apex_y;
  double axis_x;  ///< unit vector
  double axis_y;
  double slope;    ///< tan of half the beam width
  double focal_x;  ///< from the apex to the receiver; (0, 0) for a monostatic beam
  double focal_y;
  double nearest_m;  ///< returns nearer than this are ignored
};

struct HitKernels {
  const char* instruction_set;
  /// Least half path |P - tx|/2 + |P - rx|/2 of the points inside the cone, infinity without any. `count` is a multiple
  /// of `hit_lanes`; NaN coordinates are no points.
  double (*nearest)(const BeamCone& cone, const double* x, const double* y, std::size_t count);
};

/// The kernels for this processor, chosen once. All of them give the same number.
const HitKernels& hit_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_hit_kernels(const HitKernels** list, std::size_t room);

}  // namespace echoarc::kernels
