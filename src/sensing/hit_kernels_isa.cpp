// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Plain loops that compilers turn into vector code;
// every operation is exact or correctly rounded in all instruction sets, so that all give the same number.

#include "sensing/hit_kernels.hpp"

#define ECHOARC_TEXT_OF(x) #x
#define ECHOARC_TEXT(x) ECHOARC_TEXT_OF(x)

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

constexpr std::size_t lanes = hit_lanes;

/// The smallest of `measure(dx, dy)` over the points inside the cone; dx, dy from the apex. A NaN fails every test.
template <class Measure>
inline double smallest(const BeamCone& cone, const double* x, const double* y, std::size_t count, Measure&& measure) {
  const BeamCone c = cone;
  double best[lanes];
  for (std::size_t l = 0; l < lanes; ++l) best[l] = __builtin_inf();
  for (std::size_t k = 0; k < count; k += lanes)
    for (std::size_t l = 0; l < lanes; ++l) {
      const double dx = x[k + l] - c.apex_x;
      const double dy = y[k + l] - c.apex_y;
      const double along = dx * c.axis_x + dy * c.axis_y;
      const double reach = c.slope * along;
      const double across = c.axis_x * dy - c.axis_y * dx;
      double value = measure(dx, dy);
      value = along > 0.0 ? value : __builtin_inf();
      value = across <= reach ? value : __builtin_inf();
      value = -across <= reach ? value : __builtin_inf();
      best[l] = value < best[l] ? value : best[l];
    }
  double least = best[0];
  for (std::size_t l = 1; l < lanes; ++l) least = best[l] < least ? best[l] : least;
  return least;
}

double nearest(const BeamCone& cone, const double* x, const double* y, std::size_t count) {
  const BeamCone c = cone;
  const double inf = __builtin_inf();
  if (c.focal_x == 0.0 && c.focal_y == 0.0) {
    const double nearest_squared = c.nearest_m * c.nearest_m;
    return __builtin_sqrt(smallest(c, x, y, count, [=](double dx, double dy) {
      const double squared = dx * dx + dy * dy;
      return squared >= nearest_squared ? squared : inf;
    }));
  }
  return smallest(c, x, y, count, [=](double dx, double dy) {
    const double tx = dx + c.focal_x;
    const double ty = dy + c.focal_y;
    const double rx = dx - c.focal_x;
    const double ry = dy - c.focal_y;
    const double half_path = 0.5 * (__builtin_sqrt(tx * tx + ty * ty) + __builtin_sqrt(rx * rx + ry * ry));
    return half_path >= c.nearest_m ? half_path : inf;
  });
}

}  // namespace

extern const HitKernels hit_table;
const HitKernels hit_table = {ECHOARC_TEXT(ECHOARC_ISA), &nearest};

}  // namespace echoarc::kernels::ECHOARC_ISA
