// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <string>
#include <vector>

#include "echoarc/sim/world.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// The surfaces that every scene knows by name: wood, painted, cardboard, shade, brick, glass. The first is the one of
/// objects that name none.
[[nodiscard]] std::vector<sim::Material> builtin_materials();

/// The built-in materials and those of `[materials.NAME]`: loss_db, rough_db, rough_pitch_m, laser_ok. A table with the
/// name of a built-in material changes it. Errors stay in `scene`.
[[nodiscard]] std::vector<sim::Material> read_materials(TomlFields& scene);

/// The material that the key `material` of an object names, or the first.
[[nodiscard]] sim::MaterialId read_material_name(TomlFields& object, const std::vector<sim::Material>& materials);

}  // namespace echoarc::io
