// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include "echoarc/core/bytes.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/tiled_grid.hpp"

/// The common beginning of every saved method: its name, its options, its counters.
namespace echoarc {

inline constexpr std::uint32_t saved_state_version = 1;

[[nodiscard]] inline Error damaged_state(std::string_view method) {
  return {ErrorCode::bad_format, "this is no saved state of method " + std::string(method), std::string(method),
          "map the log again from its beginning"};
}

/// One field after another, so that padding bytes never reach the output.
template <OptionStruct S>
void save_options(ByteWriter& out, const S& options) {
  std::apply([&](const auto&... f) { (out.put(options.*f.member), ...); }, S::fields());
}

/// False when the bytes run out or hold a value outside its legal range.
template <OptionStruct S>
[[nodiscard]] bool restore_options(ByteReader& in, S& options) {
  const auto read = [&]<class T>(T& member) {
    if constexpr (std::same_as<T, bool>)
      member = in.get<std::uint8_t>() != 0;
    else
      member = in.get<T>();
  };
  std::apply([&](const auto&... f) { (read(options.*f.member), ...); }, S::fields());
  return in.ok() && validate(options);
}

template <class Method>
void save_head(ByteWriter& out, const typename Method::Options& options, const InsertCounters& counters) {
  out.put(saved_state_version);
  const std::string_view name = Method::name;
  out.put<std::uint64_t>(name.size());
  out.put_all(std::span<const char>(name));
  save_options(out, options);
  out.put(counters);
}

template <class Method>
[[nodiscard]] bool restore_head(ByteReader& in, typename Method::Options& options, InsertCounters& counters) {
  const std::string_view name = Method::name;
  std::string found(name.size(), '\0');
  if (in.get<std::uint32_t>() != saved_state_version || in.get<std::uint64_t>() != name.size()) return false;
  if (!in.get_all(std::span<char>(found)) || found != name || !restore_options(in, options)) return false;
  counters = in.get<InsertCounters>();
  return in.ok();
}

/// Restores a grid whose geometry and memory limit the options have already fixed: a saved grid with others is refused
/// before anything is allocated for it.
template <class T>
[[nodiscard]] bool restore_grid(ByteReader& in, TiledGrid<T>& grid) {
  ByteReader head = in;
  const bool same_geometry = head.get<GridGeometry>() == grid.geometry();
  return same_geometry && head.get<std::uint64_t>() == grid.memory_limit_bytes() && grid.restore(in);
}

}  // namespace echoarc
