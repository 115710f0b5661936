// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <string>
#include <vector>

#include "echoarc/sim/world.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// The surfaces that every scene knows by name: wood, painted, cardboard, shade, brick, glass. Objects
/// that name none are of wood.
[[nodiscard]] std::vector<sim::Material> builtin_materials();

/// The built-in materials and those of `[materials.NAME]`: loss_db, rough_db, rough_pitch_m, laser_ok. A table with the
/// name of a built-in material changes it. Errors stay in `scene`.
[[nodiscard]] std::vector<sim::Material> read_materials(TomlFields& scene);

/// The material that a key of an object names; `otherwise` where the key is absent.
[[nodiscard]] sim::MaterialId read_material_name(TomlFields& object, std::string_view key, std::string_view otherwise,
                                                 const std::vector<sim::Material>& materials);

}  // namespace echoarc::io
