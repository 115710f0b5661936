// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "maps/bit_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
void thin(const BitRows&, std::size_t, int, std::uint64_t*);
void dilate(const BitRows&, std::size_t, std::uint64_t*);
constexpr BitKernels bits{"plain", thin, dilate};
}  // namespace plain
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
void thin(const BitRows&, std::size_t, int, std::uint64_t*);
void dilate(const BitRows&, std::size_t, std::uint64_t*);
constexpr BitKernels bits{"avx2", thin, dilate};
}  // namespace avx2
#endif

std::size_t available_bit_kernels(const BitKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::bits;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::bits;
#endif
  return count;
}

const BitKernels& bit_kernels() {
  static const BitKernels* const best = [] {
    const BitKernels* list[2];
    return list[available_bit_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
