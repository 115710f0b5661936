// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name: a plain loop over whole numbers that compilers
// turn into vector code.

#include "mapping/numakura_kernels.hpp"

#define ECHOARC_TEXT_OF(x) #x
#define ECHOARC_TEXT(x) ECHOARC_TEXT_OF(x)

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

constexpr std::int32_t tile_size = 64;
constexpr std::int32_t lanes = 8;

/// As many zeros as a tile's row has cells, then as many -1 (all bits): from 64 - k on, the cells l >= k of a row.
struct Steps {
  alignas(64) std::int32_t values[2 * tile_size] = {};

  constexpr Steps() {
    for (std::int32_t k = tile_size; k < 2 * tile_size; ++k) values[k] = -1;
  }
};
constexpr Steps steps;

void raise(const TileRun* runs, std::size_t count, std::int32_t step, std::int32_t ceiling) {
  for (std::size_t k = 0; k < count; ++k) {
    const TileRun run = runs[k];
    std::int32_t* const cells = run.row;
    const std::int32_t* const from_begin = steps.values + tile_size - run.begin;
    const std::int32_t* const from_end = steps.values + tile_size - run.end;
    // Whole vectors, masked at the ends of the run: cells outside it get a step of 0 and are far below the ceiling.
    for (std::int32_t block = run.begin & ~(lanes - 1); block < run.end; block += lanes) {
#pragma GCC ivdep  // the masks are no cells
      for (std::int32_t l = block; l < block + lanes; ++l) {
        const std::int32_t sum = cells[l] + (step & from_begin[l] & ~from_end[l]);
        cells[l] = sum < ceiling ? sum : ceiling;
      }
    }
  }
}

}  // namespace

extern const AccumulationKernels accumulation_table;
const AccumulationKernels accumulation_table = {ECHOARC_TEXT(ECHOARC_ISA), &raise};

}  // namespace echoarc::kernels::ECHOARC_ISA
