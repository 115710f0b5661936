// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <vector>

#include "echoarc/core/vec2.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// A point of a list, and the line it stands on.
struct TomlPoint {
  Vec2 point;
  std::uint64_t line = 0;
};

[[nodiscard]] std::uint64_t toml_line(const toml::node& node);

/// `count` finite numbers out of a list [a, b, ...]; an error in `fields` names `what` and shows `example`.
[[nodiscard]] std::optional<std::vector<double>> toml_numbers(TomlFields& fields, const toml::node& node,
                                                              std::size_t count, std::string_view what,
                                                              std::string_view example);
/// A point [x, y] in metres.
[[nodiscard]] std::optional<Vec2> toml_point(TomlFields& fields, const toml::node& node, std::string_view what);
/// The point under `key`; an error if it is missing and `required`.
std::optional<Vec2> read_point(TomlFields& fields, std::string_view key, bool required = true);
/// The list of points under `key`, which must be there and hold `min_count` of them.
std::vector<TomlPoint> read_points(TomlFields& fields, std::string_view key, std::size_t min_count);
/// The number under `key`, which must be there.
double required_number(TomlFields& fields, std::string_view key, double min, double max);
/// The length under `key` or `key_m`, which must be there.
double required_length_m(TomlFields& fields, std::string_view key, double min, double max);

}  // namespace echoarc::io
