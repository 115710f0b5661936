// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/numakura_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
extern const AccumulationKernels accumulation_table;
}
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
extern const AccumulationKernels accumulation_table;
}
#endif

std::size_t available_accumulation_kernels(const AccumulationKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::accumulation_table;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::accumulation_table;
#endif
  return count;
}

const AccumulationKernels& accumulation_kernels() {
  static const AccumulationKernels* const best = [] {
    const AccumulationKernels* list[2];
    return list[available_accumulation_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
