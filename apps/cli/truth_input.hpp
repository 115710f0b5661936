// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "cli/log_input.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/directions.hpp"
#include "echoarc/eval/point_set.hpp"
#include "echoarc/eval/reference.hpp"

namespace echoarc::cli {

/// What maps are held against.
struct Truth {
  Reference reference;
  std::optional<DirectionSet> directions;  ///< of interest, where the truth names them
};

/// A scene, by its file or the name of one that the program carries along: the surfaces that are visible from `path`
/// (all without a path), and the directions of interest of its scoring. Anything else as `load_reference` has it.
[[nodiscard]] Result<Truth> load_truth(const LogArguments& arguments, const PointSet& path);

}  // namespace echoarc::cli
