// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/vec2.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// The samples of a `[[curve]]` table, at most 2 mm apart. One of
///
///     x = [from, to], y = constant, cosines = [[amplitude_m, rad_per_m, phase_rad], ...], sines = ..., polynomial =
///     [c0, c1, ...]                                     y(x) = y + the sum of all terms
///     centre = [x, y], radius, from_deg, to_deg         a part of a circle
///     points = [[x, y], ...]                            a smooth line through them (centripetal Catmull-Rom)
///
/// Errors stay in `fields`; the result is then empty.
[[nodiscard]] std::vector<Vec2> read_curve(TomlFields& fields);

}  // namespace echoarc::io
