// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "maps/raster_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
void sector_rows(const SectorShape&, std::int32_t, std::size_t, std::int32_t*, std::int32_t*);
void arc_samples(const ArcShape&, std::size_t, std::uint64_t*, std::uint64_t*);
void arc_rows(const ArcRowShape&, std::size_t, std::int32_t*, std::int32_t*, std::int32_t*);
constexpr RasterKernels table{"plain", sector_rows, arc_samples, arc_rows};
}  // namespace plain
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
void sector_rows(const SectorShape&, std::int32_t, std::size_t, std::int32_t*, std::int32_t*);
void arc_samples(const ArcShape&, std::size_t, std::uint64_t*, std::uint64_t*);
void arc_rows(const ArcRowShape&, std::size_t, std::int32_t*, std::int32_t*, std::int32_t*);
constexpr RasterKernels table{"avx2", sector_rows, arc_samples, arc_rows};
}  // namespace avx2
#endif

std::size_t available_raster_kernels(const RasterKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::table;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::table;
#endif
  return count;
}

const RasterKernels& raster_kernels() {
  static const RasterKernels* const best = [] {
    const RasterKernels* list[2];
    return list[available_raster_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
