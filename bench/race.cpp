// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/contestant.hpp"
#include "bench/measure.hpp"

namespace echoarc::bench {

RaceTimes race(std::span<const std::unique_ptr<Contestant>> contestants, std::span<const Reading> readings,
               std::size_t rounds) {
  const std::size_t block = readings.size() / rounds;
  for (const auto& contestant : contestants) {
    contestant->prepare(readings.first(block));
    contestant->insert();
  }
  RaceTimes times(contestants.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t k = (round + turn) % contestants.size();
      contestants[k]->prepare(readings.subspan(round * block, block));
      const double begin = thread_cpu_s();
      contestants[k]->insert();
      times[k].push_back(thread_cpu_s() - begin);
    }
  }
  return times;
}

}  // namespace echoarc::bench
