// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "maps/sector_rows.hpp"

namespace echoarc::kernels {

namespace plain {
extern const SectorRowKernels sector_rows;
}
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
extern const SectorRowKernels sector_rows;
}
#endif

std::size_t available_sector_row_kernels(const SectorRowKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::sector_rows;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::sector_rows;
#endif
  return count;
}

const SectorRowKernels& sector_row_kernels() {
  static const SectorRowKernels* const best = [] {
    const SectorRowKernels* list[2];
    return list[available_sector_row_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
