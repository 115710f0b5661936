// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/measure.hpp"

#include <cstdio>

#include <sched.h>
#include <time.h>

namespace echoarc::bench {

bool pin_to_one_core() {
  const int core = sched_getcpu();
  if (core < 0) return false;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  return sched_setaffinity(0, sizeof set, &set) == 0;
}

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

void print_json(const std::vector<Figure>& figures) {
  std::printf("[");
  const char* separator = "\n";
  for (const Figure& figure : figures) {
    std::printf("%s  {\"figure\": \"%s\", \"unit\": \"%s\", \"samples\": [", separator, figure.name.c_str(),
                figure.unit.c_str());
    for (std::size_t k = 0; k < figure.samples.size(); ++k)
      std::printf("%s%.6g", k == 0 ? "" : ", ", figure.samples[k]);
    std::printf("]}");
    separator = ",\n";
  }
  std::printf("\n]\n");
}

}  // namespace echoarc::bench
