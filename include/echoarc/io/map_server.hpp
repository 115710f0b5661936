// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "echoarc/core/result.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::io {

/// Grey values of a map_server picture, as every ROS navigation stack writes and reads them.
inline constexpr int map_free = 254;
inline constexpr int map_unknown = 205;
inline constexpr int map_occupied = 0;
/// Darkness (255 - grey) / 255 above the first is occupied, below the second free. 205 has darkness 0.19608: with a
/// `free_thresh` of 0.25, widespread elsewhere, unknown cells would reload as free.
inline constexpr double map_occupied_threshold = 0.65;
inline constexpr double map_free_threshold = 0.196;

/// Largest picture that is read: as large as the largest export.
inline constexpr std::int64_t max_map_pixels = std::int64_t{1} << 28;

/// Writes `directory`/map.yaml and `directory`/map.pgm (binary, row 0 at the top). The picture's path in the YAML is
/// relative, yaw is 0, `origin` is the lower left corner of the grid in metres.
[[nodiscard]] Result<void> write_map(const std::filesystem::path& directory, const DenseGrid<CellState>& grid);

/// Reads a map.yaml and its picture (PGM binary or plain, or 8-bit PNG) into a grid of states.
///
/// Understood: `image`, `resolution`, `origin`, `negate`, `occupied_thresh`, `free_thresh`, `mode: trinary` (or
/// `scale`, read as trinary). Transparent pixels are unknown. Errors: a missing or repeated key, a
/// number out of range, yaw other than 0, `mode: raw`, a picture that is truncated, too large or of another format.
[[nodiscard]] Result<DenseGrid<CellState>> read_map_yaml(const std::filesystem::path& path);
/// The same from memory: the text of the YAML, whose `image` is not looked at, and the bytes of the picture. `source`
/// names the YAML in messages.
[[nodiscard]] Result<DenseGrid<CellState>> parse_map(std::string_view yaml, std::string_view image,
                                                     std::string_view source);

}  // namespace echoarc::io
