// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/vote_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
void find_blocks(const CountRows&, std::uint16_t**);
void count(const CountRows&, std::uint16_t* const*);
constexpr VoteKernels votes{"plain", find_blocks, count};
}  // namespace plain
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
void find_blocks(const CountRows&, std::uint16_t**);
void count(const CountRows&, std::uint16_t* const*);
constexpr VoteKernels votes{"avx2", find_blocks, count};
}  // namespace avx2
#endif

std::size_t available_vote_kernels(const VoteKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::votes;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::votes;
#endif
  return count;
}

const VoteKernels& vote_kernels() {
  static const VoteKernels* const best = [] {
    const VoteKernels* list[2];
    return list[available_vote_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
