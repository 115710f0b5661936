// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace echoarc::bench {

/// Keeps the calling thread on the core it runs on, so that it does not lose its caches to a migration. False, and no
/// change, where the system does not allow it.
bool pin_to_one_core();

/// Processor time of the calling thread in seconds: on a shared machine the time others run is not counted.
[[nodiscard]] double thread_cpu_s();

/// Makes the compiler believe that \p value is used.
template <class T>
void consume(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// One figure of the report with every sample that was taken of it.
struct Figure {
  std::string name;
  std::string unit;
  std::vector<double> samples;
};

/// Prints figures as one JSON array, the form `run_all` reads.
void print_json(const std::vector<Figure>& figures);

}  // namespace echoarc::bench
