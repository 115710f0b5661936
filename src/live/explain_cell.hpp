// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

#include "echoarc/live/inquiry.hpp"

namespace echoarc::live {

/// What every ping made of the cell at a position. `place`: of the method among those of the evidence. Error: a method
/// without cells.
[[nodiscard]] Result<CellHistory> cell_history(const Evidence& evidence, std::size_t place, Vec2 position);

}  // namespace echoarc::live
