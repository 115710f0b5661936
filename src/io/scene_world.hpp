// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/sim/world.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// What stands in a scene, out of its tables (docs/scenes.md): `[materials.NAME]`, `[[wall]]`, `[[box]]`, `[[disc]]`,
/// `[[curve]]`, `[[slats]]`, `[[moving]]` and `[world]`. Errors stay in `scene`.
[[nodiscard]] sim::WorldDescription read_world(TomlFields& scene);

}  // namespace echoarc::io
