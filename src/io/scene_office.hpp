// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/sim/scene.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// The table `[office]` of a scene: the options of sim::OfficeFloorOptions, and the materials `smooth` and `rough`. Its
/// walls are added to the scene's; its tour is the scene's drive, where that gives neither start nor legs. Errors stay
/// in `fields`.
void read_office(TomlFields& fields, sim::Scene& scene);

}  // namespace echoarc::io
