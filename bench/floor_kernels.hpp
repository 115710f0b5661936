// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The floor's inner loop, compiled and dispatched like the library's own kernels (cmake/EchoarcKernels.cmake). Nothing
// with inline functions is included here.

#include <cstddef>

namespace echoarc::bench {

struct FloorKernels {
  const char* instruction_set;
  void (*add)(float* cells, std::size_t count, float value);
};

/// The kernels for this processor, chosen once.
const FloorKernels& floor_kernels();

}  // namespace echoarc::bench
