// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/io/map_server.hpp"
#include "io/gray_image.hpp"

namespace echoarc::io {

/// What a map.yaml says of its picture.
struct MapYaml {
  std::string image;
  double resolution_m = 0.0;
  Vec2 origin;  ///< lower left corner of the lower left pixel, world
  bool negate = false;
  double occupied_threshold = map_occupied_threshold;
  double free_threshold = map_free_threshold;
};

/// The subset of YAML in which map files are written: one `key: value` a line, lists in brackets, comments, quotes.
[[nodiscard]] Result<MapYaml> parse_map_yaml(std::string_view text, std::string_view source);
[[nodiscard]] std::string map_yaml_text(const MapYaml& yaml);

/// The picture as states: darkness beyond a threshold is occupied or free, everything else unknown.
[[nodiscard]] DenseGrid<CellState> states_of(const GrayImage& image, const MapYaml& yaml);

}  // namespace echoarc::io
