// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc::server {

/// A map as one of the files of `echoarc map`: "png", "pgm", "yaml" or "csv". Written into a folder of the system's
/// temporary ones whose name is its own, and read back. Error: an empty map has no picture.
[[nodiscard]] Result<std::string> map_file(const MapExport& map, const std::string& method, std::string_view kind,
                                           const std::vector<Vec2>& path);

}  // namespace echoarc::server
