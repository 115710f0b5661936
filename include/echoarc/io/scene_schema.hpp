// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace echoarc::io {

/// The JSON Schema (2020-12) of what a scene.toml holds, indented, with a newline at its end: schema/scene.schema.json.
/// Tables of options come from their fields; editors that know TOML complete and check scenes with it.
[[nodiscard]] std::string scene_schema();

}  // namespace echoarc::io
