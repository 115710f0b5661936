// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/posterior_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
void add_walls(const PosteriorTerms&, const CirclePair*, std::int32_t, const PosteriorSums&);
void add_points(const PosteriorTerms&, const CirclePair*, std::int32_t, const PosteriorSums&);
float normalise(float*, std::int32_t, float);
constexpr PosteriorKernels posterior{"plain", add_walls, add_points, normalise};
}  // namespace plain
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
void add_walls(const PosteriorTerms&, const CirclePair*, std::int32_t, const PosteriorSums&);
void add_points(const PosteriorTerms&, const CirclePair*, std::int32_t, const PosteriorSums&);
float normalise(float*, std::int32_t, float);
constexpr PosteriorKernels posterior{"avx2", add_walls, add_points, normalise};
}  // namespace avx2
#endif

int available_posterior_kernels(const PosteriorKernels** list, int room) {
  int count = 0;
  if (count < room) list[count++] = &plain::posterior;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::posterior;
#endif
  return count;
}

const PosteriorKernels& posterior_kernels() {
  static const PosteriorKernels* const best = [] {
    const PosteriorKernels* list[2];
    return list[available_posterior_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
