// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/sim/scene.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// The table `[drive]` of a scene: `start = [x, y, heading_deg]`, `legs = [[x, y], { to = [x, y] }, { turn_deg = 90
/// }]`, and the options of sim::Drive. Errors stay in `scene`.
[[nodiscard]] sim::Drive read_drive(TomlFields& scene);

}  // namespace echoarc::io
