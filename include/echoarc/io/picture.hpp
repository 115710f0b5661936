// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/echo_cause.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/features/feature.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/maps/point_map.hpp"

namespace echoarc::io {

/// An echo of a simulated sonar, where its range would put it.
struct EchoMark {
  Vec2 position;
  EchoCause cause = EchoCause::unknown;
};

/// What a picture for people shows; whatever is absent is left out. Nothing is owned.
struct PictureContent {
  std::string title;                                 ///< one line of ASCII; empty: no title
  const DenseGrid<CellState>* states = nullptr;      ///< free white, unknown light grey, occupied near-black
  const DenseGrid<float>* probability = nullptr;     ///< shades the cells that `states` knows: 0 white to 1 near-black
  std::span<const MapPoint> points = {};             ///< world; coloured by label
  std::span<const Vec2> path = {};                   ///< world; positions of the robot in order of time
  std::span<const Feature> features = {};            ///< world; segments as strokes, points as rings, coloured by kind
  std::span<const std::vector<Vec2>> surfaces = {};  ///< world; polylines of what stands there
  std::span<const std::vector<Vec2>> movers = {};    ///< world; outlines and ways of what moves there
  std::span<const std::vector<Vec2>> graph = {};     ///< world; the edges of a graph of ways
  std::span<const Vec2> nodes = {};                  ///< world; its nodes
  std::span<const EchoMark> echoes = {};             ///< world; coloured by cause; far-off ones may be cut off
};

/// Draws the known part of the map with a scale bar and a legend, and writes a PNG (8-bit RGB).
///
/// Small maps are enlarged so that the long side is 800 to 1600 pixels; larger ones are reduced, an occupied cell
/// staying visible. Up is +y of the world. The same content gives the same pixels.
/// Errors: nothing to draw, content spread over more than 100 km, a file that cannot be written.
[[nodiscard]] Result<void> write_picture(const std::filesystem::path& path, const PictureContent& content);

}  // namespace echoarc::io
