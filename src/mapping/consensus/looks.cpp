// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/looks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "echoarc/core/arc.hpp"

namespace echoarc::consensus {
namespace {

std::optional<double> free_range_m(const Reading& reading) {
  if (const auto range_m = echo_range_m(reading.outcome)) return range_m;
  if (std::holds_alternative<NoEcho>(reading.outcome)) return std::min(reading.trusted_range_m, reading.range_max_m);
  return std::nullopt;
}

bool repeats(const Look& look, const Look& last, const ConsensusOptions& options) {
  return norm(look.origin - last.origin) < options.thin_move_m - eps_length_m &&
         dot(look.axis, last.axis) > cos(options.thin_turn) &&
         std::abs(look.range_m - last.range_m) <= options.thin_range_m;
}

bool is_sound(const Look& look) {
  return is_finite(look.origin) && is_finite(look.axis) && std::isfinite(look.range_m) && look.range_m > 0.0;
}

}  // namespace

void LookTable::add(const Reading& reading, const ConsensusOptions& options, std::size_t arcs) {
  const auto range_m = free_range_m(reading);
  if (!range_m || !reading.monostatic()) return;
  const Look look{reading.T_world_tx.position, unit(reading.T_world_tx.heading),
                  std::min(*range_m, options.range_max_m)};
  if (!is_sound(look)) return;
  const auto last = last_.find(reading.tx);
  if (last != last_.end() && repeats(look, last->second, options)) return;
  last_[reading.tx] = look;
  looks_.push_back(look);
  arcs_.push_back(std::uint32_t(arcs));
}

std::span<const Look> LookTable::since(std::size_t from) const {
  return std::span(looks_).subspan(std::size_t(std::ranges::lower_bound(arcs_, from) - arcs_.begin()));
}

void LookTable::forget(std::size_t count) {
  const auto old = std::ptrdiff_t(looks_.size() - since(count).size());
  looks_.erase(looks_.begin(), looks_.begin() + old);
  arcs_.erase(arcs_.begin(), arcs_.begin() + old);
  for (std::uint32_t& before : arcs_) before -= std::uint32_t(count);
}

void LookTable::save(ByteWriter& out) const {
  out.put_vector(looks_);
  out.put_vector(arcs_);
  out.put<std::uint64_t>(last_.size());
  for (const auto& [sensor, look] : last_) {
    out.put(sensor);
    out.put(look);
  }
}

bool LookTable::restore(ByteReader& in) {
  looks_ = in.get_vector<Look>();
  arcs_ = in.get_vector<std::uint32_t>();
  const auto sensors = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < sensors && in.ok(); ++k) {
    const auto sensor = in.get<SensorId>();
    last_[sensor] = in.get<Look>();
    if (!is_sound(last_[sensor])) return false;
  }
  return in.ok() && arcs_.size() == looks_.size() && std::ranges::is_sorted(arcs_) &&
         std::ranges::all_of(looks_, &is_sound);
}

}  // namespace echoarc::consensus
