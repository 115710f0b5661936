// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/limited_grid.hpp"

#include <algorithm>
#include <utility>

#include "mapping/saved_state.hpp"

namespace echoarc {

void LimitedGrid::insert(std::span<const Reading> readings, Executor& executor) {
  grid_.insert(readings, executor);
  limited_ += std::uint64_t(std::ranges::count(readings, true, &Reading::laser_limited));
}

std::vector<std::byte> LimitedGrid::save() const {
  ByteWriter out;
  save_head<LimitedGrid>(out, options(), counters());
  out.put(limited_);
  out.put_vector(grid_.save());
  return std::move(out).take();
}

Result<LimitedGrid> LimitedGrid::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<LimitedGrid>(in, options, counters)) return damaged_state(name);
  LimitedGrid method;
  method.limited_ = in.get<std::uint64_t>();
  auto grid = EvidenceGrid::restore(in.get_vector<std::byte>());
  if (!grid || !in.done()) return damaged_state(name);
  method.grid_ = std::move(*grid);
  return method;
}

}  // namespace echoarc
