// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "echoarc/io/delimited.hpp"

namespace echoarc::io {

enum class Dimension { none, time, length, angle };

[[nodiscard]] Dimension dimension_of(Quantity quantity);
/// SI units per `unit`; nothing for a unit that is unknown or of another dimension.
[[nodiscard]] std::optional<double> si_scale(Dimension dimension, std::string_view unit);
/// "mm, cm, dm, m, km, in or ft": for messages.
[[nodiscard]] std::string units_of(Dimension dimension);

}  // namespace echoarc::io
