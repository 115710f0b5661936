// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/log_input.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/point_set.hpp"
#include "echoarc/eval/reference.hpp"

namespace echoarc::cli {

/// A map to be scored.
struct NamedMap {
  std::string name;
  PointSet points;
  std::optional<PointSet> cells;  ///< centres of the cells it is drawn with, where `points` are exact
};

/// The maps behind `path`: every method of an output folder of `map`, one method's folder, or a map.yaml. Of a grid the
/// centres of its occupied cells, of a method of points the points themselves.
[[nodiscard]] Result<std::vector<NamedMap>> load_maps(const std::filesystem::path& path);

/// What the maps are held against: a polyline CSV, a map.yaml (or the folder it lies in), or else a log with a laser.
[[nodiscard]] Result<Reference> load_reference(const LogArguments& arguments);

/// "axis:90" of --doi: 90 degrees. Errors: anything else.
[[nodiscard]] Result<Angle> parse_direction(const std::string& text);

/// Where the robot was: from `given`, else from the path.csv of the output folder `maps` lies in. Without either the
/// set is empty.
[[nodiscard]] Result<PointSet> load_path(const std::filesystem::path& maps, const std::filesystem::path& given);

}  // namespace echoarc::cli
