// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/studies/experiment.hpp"

namespace echoarc::studies {

/// What the directional maximum makes of one drive along walls, by where its directions of interest came from.
struct DirectionScores {
  MapScore followed;  ///< at right angles to the way that was driven, to the side on which a wall was followed
  MapScore ideal;     ///< at right angles to the true walls
};

/// Both scores of a trial whose log names the wall that was followed ([Barshan07] 4.2); nothing if it does not, or if
/// the scoring has no walls. For the ideal the robot's place is moved to the line that runs beside the nearest wall at
/// its depth, while its sensors, and so all arcs, stay where they were. Errors: those of `run_methods`.
[[nodiscard]] Result<std::optional<DirectionScores>> score_directions(const Trial& trial);

}  // namespace echoarc::studies
