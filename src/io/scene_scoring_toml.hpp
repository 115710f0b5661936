// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/eval/scene_scoring.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// The table `[scoring]` of a scene: `region = [[x, y], [x, y]]`, directions of interest as `[[scoring.span]]` (from,
/// to, depth_m), `axis_deg` or `polar_centre`, and the options of SceneScoring. Errors stay in `scene`.
[[nodiscard]] std::optional<SceneScoring> read_scoring(TomlFields& scene);

}  // namespace echoarc::io
