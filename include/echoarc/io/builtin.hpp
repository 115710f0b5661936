// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace echoarc::io {

/// A file of the project's scenes/ folder that every program carries along.
struct BuiltinText {
  std::string_view name;  ///< of the file, without folder and extension: `room`, `nomad200`
  std::string_view text;
};

/// The scenes of scenes/*.toml, by name; `read_scene` reads their texts.
[[nodiscard]] std::span<const BuiltinText> builtin_scenes();
[[nodiscard]] std::optional<std::string_view> builtin_scene(std::string_view name);

/// The robots of scenes/robots/*.toml, by name; `parse_robot_toml` reads their texts.
[[nodiscard]] std::span<const BuiltinText> builtin_robots();
[[nodiscard]] std::optional<std::string_view> builtin_robot(std::string_view name);

}  // namespace echoarc::io
