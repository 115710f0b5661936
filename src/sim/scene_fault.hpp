// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>

#include "echoarc/core/result.hpp"

namespace echoarc::sim {

/// An error of the scene. `where` becomes "line 12", or nothing for line 0; see `in_file`.
[[nodiscard]] Error scene_fault(std::string message, std::uint64_t line, std::string remedy);

/// The same error with the file's name: "line 12" of "room.toml" is "room.toml:12". No name: as it was.
[[nodiscard]] Error in_file(Error error, const std::string& file);

/// Three decimals at most, no zeros at the end: for places and times in messages.
[[nodiscard]] std::string short_number(double value);

}  // namespace echoarc::sim
