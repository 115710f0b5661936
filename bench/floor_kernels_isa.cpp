// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name.

#include "floor_kernels.hpp"  // beside this file

#define ECHOARC_TEXT_OF(x) #x
#define ECHOARC_TEXT(x) ECHOARC_TEXT_OF(x)

namespace echoarc::bench::ECHOARC_ISA {
namespace {

void add(float* cells, std::size_t count, float value) {
  for (std::size_t k = 0; k < count; ++k) cells[k] += value;
}

}  // namespace

extern const FloorKernels floor_table;
const FloorKernels floor_table{ECHOARC_TEXT(ECHOARC_ISA), add};

}  // namespace echoarc::bench::ECHOARC_ISA
