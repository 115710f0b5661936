// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "echoarc/core/result.hpp"
#include "echoarc/features/feature.hpp"

namespace echoarc::io {

/// Features as a GeoJSON FeatureCollection (RFC 7946). Coordinates are metres in the log's own frame, not degrees on
/// the Earth: the foreign member `echoarc` says so. Properties: `kind`, `residual_m`, `count`, `pings`.
/// \p frame names the log's frame ("odom").
[[nodiscard]] std::string features_geojson(std::span<const Feature> features, std::string_view frame);
[[nodiscard]] Result<void> write_features_geojson(const std::filesystem::path& path, std::span<const Feature> features,
                                                  std::string_view frame);

}  // namespace echoarc::io
