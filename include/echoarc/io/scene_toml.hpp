// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/eval/scene_scoring.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::io {

struct SceneFile {
  sim::Scene scene;
  std::optional<SceneScoring> scoring;
  std::vector<Vec2> goals;  ///< `[explore]`: places that matter to a robot that finds its own way
};

/// A scene.toml; docs/scenes.md lists its keys. `source` names it in messages. Errors say line, cause and remedy.
[[nodiscard]] Result<SceneFile> read_scene(std::string_view text, std::string_view source);

/// The same for a file of at most `max_scene_bytes`.
[[nodiscard]] Result<SceneFile> read_scene_file(const std::filesystem::path& path);
inline constexpr std::size_t max_scene_bytes = std::size_t{1} << 28;

}  // namespace echoarc::io
