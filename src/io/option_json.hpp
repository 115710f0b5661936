// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <variant>

#include <nlohmann/json.hpp>

#include "echoarc/core/options.hpp"

namespace echoarc::io {

[[nodiscard]] inline nlohmann::ordered_json to_json(const OptionValue& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

[[nodiscard]] inline nlohmann::ordered_json to_json(const OptionMap& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : values) json[name] = to_json(value);
  return json;
}

/// The JSON Schema of every option, by name, in order of declaration.
[[nodiscard]] nlohmann::ordered_json option_properties(std::span<const OptionSpec> specs);

}  // namespace echoarc::io
