// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <filesystem>

#include "echoarc/core/result.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::io {

/// Writes the values as a NumPy array (format 1.0, little-endian, C order) of shape (height, width): row 0 is the
/// lowest, as in the grid, so `array[j, i]` is cell (i, j). `numpy.load` reads it.
[[nodiscard]] Result<void> write_npy(const std::filesystem::path& path, const DenseGrid<float>& grid);
[[nodiscard]] Result<void> write_npy(const std::filesystem::path& path, const DenseGrid<std::uint16_t>& grid);

/// Writes where those cells lie, as JSON: `cell_m`, `origin` [x, y] (lower left corner of cell (0, 0), metres),
/// `width`, `height`.
[[nodiscard]] Result<void> write_grid_json(const std::filesystem::path& path, const GridGeometry& geometry,
                                           std::int32_t width, std::int32_t height);

}  // namespace echoarc::io
