// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/toml_points.hpp"

#include <cmath>

#include <fmt/format.h>

namespace echoarc::io {

std::uint64_t toml_line(const toml::node& node) {
  return node.source().begin.line;
}

std::optional<std::vector<double>> toml_numbers(TomlFields& fields, const toml::node& node, std::size_t count,
                                                std::string_view what, std::string_view example) {
  std::vector<double> numbers;
  if (const toml::array* list = node.as_array(); list != nullptr && list->size() == count)
    for (const toml::node& element : *list)
      if (const auto value = element.is_number() ? element.value<double>() : std::nullopt;
          value && std::isfinite(*value))
        numbers.push_back(*value);
  if (numbers.size() == count) return numbers;
  fields.fail(&node, fmt::format("{} is not a list of {} finite numbers", what, count),
              fmt::format("write {}", example));
  return std::nullopt;
}

std::optional<Vec2> toml_point(TomlFields& fields, const toml::node& node, std::string_view what) {
  const auto numbers = toml_numbers(fields, node, 2, what, "[1.0, 2.5], x and y in metres");
  if (!numbers) return std::nullopt;
  return Vec2{(*numbers)[0], (*numbers)[1]};
}

std::optional<Vec2> read_point(TomlFields& fields, std::string_view key, bool required) {
  if (const toml::node* node = fields.node(key)) return toml_point(fields, *node, key);
  if (required) fields.fail(nullptr, fmt::format("{} is missing", key), fmt::format("write {} = [x, y]", key));
  return std::nullopt;
}

std::vector<TomlPoint> read_points(TomlFields& fields, std::string_view key, std::size_t min_count) {
  const bool given = fields.has(key);
  const toml::array* list = fields.array(key);
  if (!given)
    fields.fail(nullptr, fmt::format("{} is missing", key), fmt::format("write {} = [[0, 0], [2.5, 0]]", key));
  if (list == nullptr) return {};
  if (list->size() < min_count)
    fields.fail(list, fmt::format("{} holds fewer than {} points", key, min_count),
                fmt::format("write {} = [[0, 0], [2.5, 0], ...]", key));
  std::vector<TomlPoint> points;
  points.reserve(list->size());
  for (const toml::node& element : *list) {
    const std::optional<Vec2> point = toml_point(fields, element, fmt::format("a point of {}", key));
    if (!point) return {};
    points.push_back({*point, toml_line(element)});
  }
  return points;
}

double required_number(TomlFields& fields, std::string_view key, double min, double max) {
  if (!fields.has(key)) fields.fail(nullptr, fmt::format("{} is missing", key), fmt::format("write {} = 1.0", key));
  return fields.number(key, min, max).value_or(0.0);
}

double required_length_m(TomlFields& fields, std::string_view key, double min, double max) {
  if (!fields.has(key) && !fields.has(std::string(key) + "_m"))
    fields.fail(nullptr, fmt::format("{} is missing", key), fmt::format("write {} = 1.0, in metres", key));
  return fields.length_m(key, min, max).value_or(0.0);
}

}  // namespace echoarc::io
