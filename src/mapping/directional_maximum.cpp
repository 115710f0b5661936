// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/directional_maximum.hpp"

#include <algorithm>

#include "mapping/counted_arc.hpp"
#include "mapping/doi/survivors.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

/// One bit out of seed and line (finaliser of SplitMix64).
bool coin(std::uint64_t seed, std::uint64_t line) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15ULL + line;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return ((z ^ (z >> 31)) & 1U) != 0;
}

bool takes_farther_middle(TieRule tie, std::uint64_t seed, std::uint64_t line) {
  switch (tie) {
    case TieRule::near: return false;
    case TieRule::far: return true;
    case TieRule::hash: return coin(seed, line);
  }
  return false;
}

DoiHistory history_for(const DirectionalMaximumOptions& options) {
  using D = DirectionOfInterest;
  const D doi = options.doi;
  const bool sights = doi == D::los || doi == D::pca || doi == D::automatic;
  const bool path = doi != D::axis && doi != D::los;
  return {sights, path, options.cell_m};
}

}  // namespace

std::optional<std::size_t> directional_maximum(std::span<const std::uint16_t> counts, int threshold, TieRule tie,
                                               std::uint64_t seed, std::uint64_t line) {
  if (counts.empty()) return std::nullopt;
  const std::uint16_t maximum = *std::ranges::max_element(counts);
  if (maximum < threshold) return std::nullopt;
  const auto maxima = std::ranges::count(counts, maximum);
  auto to_skip = (maxima - 1) / 2;  // the median; the nearer of two
  if (maxima % 2 == 0 && takes_farther_middle(tie, seed, line)) ++to_skip;
  std::size_t index = 0;
  while (counts[index] != maximum || to_skip-- > 0) ++index;
  return index;
}

DirectionalMaximum::DirectionalMaximum(Options options)
    : options_(options),
      map_{VoteGrid(geometry_of(options), memory_limit_bytes(options), options.sampling), {}},
      history_(history_for(options)) {}

void DirectionalMaximum::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) {
    const auto arc = counted_arc(reading, options_.beam_policy, counters_);
    if (!arc) continue;
    const std::size_t taken = map_.votes.counts().memory_bytes() + history_.memory_bytes();
    if (taken > memory_limit_bytes(options_) || !map_.votes.add(*arc)) {
      ++counters_.memory_limit;
      continue;
    }
    history_.add(reading, *arc);
    ++counters_.used;
  }
  map_.votes.settle();
}

void DirectionalMaximum::finish(Executor& /*executor*/) {
  map_.survivors = doi::survivors(map_.votes.counts(), history_, options_);
}

Result<MapExport> DirectionalMaximum::export_map() const {
  const auto state = [&](Cell cell, std::uint16_t) {
    return std::ranges::binary_search(map_.survivors, cell, std::less<>{}) ? CellState::occupied : CellState::unknown;
  };
  return export_grid<std::uint16_t>(map_.votes.counts(), name, state, [](std::uint16_t count) { return count; });
}

Trace DirectionalMaximum::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  if (trace.arc) trace.cells = map_.votes.changes(*trace.arc);
  return trace;
}

bool DirectionalMaximum::supports(const Reading& reading, Vec2 position) const {
  const auto arc = arc_of(reading, options_.beam_policy);
  return arc && map_.votes.crosses(*arc, position);
}

std::vector<std::byte> DirectionalMaximum::save() const {
  ByteWriter out;
  save_head<DirectionalMaximum>(out, options_, counters_);
  map_.votes.save(out);
  history_.save(out);
  out.put_vector(map_.survivors);
  return std::move(out).take();
}

Result<DirectionalMaximum> DirectionalMaximum::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<DirectionalMaximum>(in, options, counters)) return damaged_state(name);
  DirectionalMaximum method(options);
  method.counters_ = counters;
  if (!method.map_.votes.restore(in) || !method.history_.restore(in)) return damaged_state(name);
  method.map_.survivors = in.get_vector<Cell>();
  if (!in.done()) return damaged_state(name);
  return method;
}

}  // namespace echoarc
