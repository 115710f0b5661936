// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <bit>
#include <cstdint>

#include "echoarc/core/bytes.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::test {

struct FoldOptions {
  int salt = 1;
  static constexpr auto fields() {
    return std::tuple{field("salt", &FoldOptions::salt, {.min = 0, .max = 1000, .doc = "start of the fold"})};
  }
};

/// A method whose map is a number that depends on every reading and on their order, so that a reading lost, doubled or
/// swapped shows.
class Fold {
 public:
  using Options = FoldOptions;
  using Map = std::uint64_t;
  static constexpr std::string_view name = "fold";

  explicit Fold(Options options = {}) : options_(options), value_(std::uint64_t(options.salt)) {}

  void insert(std::span<const Reading> readings, Executor& executor) {
    std::vector<std::uint64_t> digests(readings.size());
    executor.run(readings.size(), [&](std::size_t i) { digests[i] = digest(readings[i]); });
    for (const std::uint64_t one : digests) value_ = (value_ ^ one) * 0x9e3779b97f4a7c15ULL + 1;
    counters_.used += readings.size();
  }
  void finish(Executor&) { ++finished_; }
  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] const Map& map() const { return value_; }
  [[nodiscard]] Result<MapExport> export_map() const { return MapExport{}; }
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] Trace trace(const Reading&) const { return {}; }
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const {
    const auto range_m = echo_range_m(reading.outcome);
    return range_m && std::abs(norm(position - reading.T_world_tx.position) - *range_m) < 0.05;
  }
  [[nodiscard]] std::vector<std::byte> save() const {
    ByteWriter writer;
    writer.put(value_);
    writer.put(finished_);
    return std::move(writer).take();
  }
  [[nodiscard]] static Result<Fold> restore(std::span<const std::byte>) { return Fold{}; }

 private:
  [[nodiscard]] static std::uint64_t digest(const Reading& reading) {
    std::uint64_t sum = reading.ping * 31 + reading.scan;
    for (const double part : {reading.time_s, reading.T_world_tx.position.x, reading.T_world_tx.heading.rad(),
                              echo_range_m(reading.outcome).value_or(-1.0)})
      sum = sum * 1099511628211ULL + std::bit_cast<std::uint64_t>(part);
    return sum;
  }

  Options options_;
  std::uint64_t value_ = 0;
  std::uint64_t finished_ = 0;
  InsertCounters counters_;
};
static_assert(MappingMethod<Fold>);

}  // namespace echoarc::test
