// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/builtin.hpp"

#include <algorithm>

namespace echoarc::io {
namespace {

std::optional<std::string_view> find(std::span<const BuiltinText> texts, std::string_view name) {
  const auto found = std::ranges::find(texts, name, &BuiltinText::name);
  return found != texts.end() ? std::optional(found->text) : std::nullopt;
}

}  // namespace

std::optional<std::string_view> builtin_scene(std::string_view name) {
  return find(builtin_scenes(), name);
}

std::optional<std::string_view> builtin_robot(std::string_view name) {
  return find(builtin_robots(), name);
}

}  // namespace echoarc::io
