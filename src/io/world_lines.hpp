// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/sim/scene.hpp"

/// A simulated world as pictures draw it.
namespace echoarc::io {

using Polylines = std::vector<std::vector<Vec2>>;

/// Walls, outlines of discs, curves.
[[nodiscard]] Polylines surfaces_of(const sim::WorldDescription& world);
/// The discs that move where they start and where they end, and the way between.
[[nodiscard]] Polylines movers_of(const sim::WorldDescription& world);
/// One line of ASCII.
[[nodiscard]] std::string title_of(const sim::Scene& scene);

}  // namespace echoarc::io
