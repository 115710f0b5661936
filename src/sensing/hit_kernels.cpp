// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sensing/hit_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
extern const HitKernels hit_table;
}
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
extern const HitKernels hit_table;
}
#endif

std::size_t available_hit_kernels(const HitKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::hit_table;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::hit_table;
#endif
  return count;
}

const HitKernels& hit_kernels() {
  static const HitKernels* const best = [] {
    const HitKernels* list[2];
    return list[available_hit_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
