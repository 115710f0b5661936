// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/features/feature.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc::io {

/// What the picture of a method's map shows beside the map.
struct MethodPicture {
  std::string title;
  std::span<const Vec2> path = {};                ///< positions of the robot, world
  std::span<const Feature> features = {};         ///< drawn over the map
  const DenseGrid<float>* probability = nullptr;  ///< see `PictureContent::probability`
};

/// Writes everything a method hands over into `directory` (made if absent): map.yaml, map.pgm, points.csv,
/// segments.csv (where the map has segments), map.png (unless the map is empty and there is no path), and, where the
/// method has cell values, grid.npy and grid.json.
[[nodiscard]] Result<void> write_method_output(const std::filesystem::path& directory, const MapExport& map,
                                               const MethodPicture& picture);

}  // namespace echoarc::io
