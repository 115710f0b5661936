// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>

#include "echoarc/core/echo_cause.hpp"
#include "echoarc/features/feature.hpp"
#include "echoarc/maps/point_map.hpp"
#include "io/picture/canvas.hpp"

namespace echoarc::io::palette {

inline constexpr Color paper = rgb(0xF7F8FA);
inline constexpr Color frame = rgb(0xC9D0D8);
inline constexpr Color ink = rgb(0x18212B);
inline constexpr Color quiet_ink = rgb(0x465260);
inline constexpr Color unknown = rgb(0xE4E8ED);
inline constexpr Color free = rgb(0xFFFFFF);
inline constexpr Color occupied = rgb(0x1D2630);
inline constexpr Color grid_mark = rgb(0xB9C2CC);
inline constexpr Color surface = rgb(0x1D2630);
inline constexpr Color mover = rgb(0x8A96A3);
inline constexpr Color path = rgb(0x1763C6);
inline constexpr Color graph = rgb(0xC2185B);

/// One colour a label; told apart by people with red-green blindness, too.
[[nodiscard]] constexpr Color of(PointLabel label) {
  constexpr Color colors[point_label_count] = {rgb(0xBC7600), rgb(0x5B1F92), rgb(0x00786B), rgb(0x5B1F92),
                                               rgb(0xC2185B), rgb(0x2E86C1), rgb(0x1D2630), rgb(0xC2185B),
                                               rgb(0x8A97A5), rgb(0x2E86C1), rgb(0xE09F3E)};
  return colors[static_cast<std::size_t>(label)];
}

/// Drawn over cells and points, so told apart from both.
[[nodiscard]] constexpr Color of(FeatureKind kind) {
  constexpr Color colors[feature_kind_count] = {rgb(0xD55E00), rgb(0x7B2CBF), rgb(0x2E7D32),
                                                rgb(0x2E7D32), rgb(0xC2185B), rgb(0x6C7885)};
  return colors[static_cast<std::size_t>(kind)];
}

/// What is rightly heard in greens and blues, what misleads in warm colours, noise in grey.
[[nodiscard]] constexpr Color of(EchoCause cause) {
  constexpr std::array<Color, echo_cause_names.size()> colors = {
      rgb(0x6C7885), rgb(0x2A9D6F), rgb(0x5B1F92), rgb(0xD81B60), rgb(0x0077B6), rgb(0x00A5A5),
      rgb(0x9A6B00), rgb(0x8BB174), rgb(0xF28482), rgb(0xE07A00), rgb(0xD00000), rgb(0x8A8F98)};
  return colors[static_cast<std::size_t>(cause)];
}

}  // namespace echoarc::io::palette
