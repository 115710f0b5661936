// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/evidence_kernels.hpp"

namespace echoarc::kernels {

namespace plain {
extern const EvidenceKernels table;
}
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
extern const EvidenceKernels table;
}
#endif

std::size_t available_evidence_kernels(const EvidenceKernels** list, std::size_t room) {
  std::size_t count = 0;
  if (count < room) list[count++] = &plain::table;
#ifdef ECHOARC_HAVE_AVX2
  if (count < room && __builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::table;
#endif
  return count;
}

const EvidenceKernels& evidence_kernels() {
  static const EvidenceKernels* const best = [] {
    const EvidenceKernels* list[2];
    return list[available_evidence_kernels(list, 2) - 1];
  }();
  return *best;
}

}  // namespace echoarc::kernels
