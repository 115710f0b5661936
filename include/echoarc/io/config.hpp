// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// The options a section may set. Sections are the methods by name, and "sensing".
struct OptionSection {
  std::string name;
  std::vector<OptionSpec> specs;
};

/// Values by section.
using Config = std::map<std::string, OptionMap, std::less<>>;

/// Reads a TOML file with one table a section:
///
///     [evidence]
///     cell_m = 0.02
///     [sensing]
///     ...
///
/// Every value is held against its option. Unknown sections and options, wrong types and values out of range are errors
/// that name line and remedy.
[[nodiscard]] Result<Config> read_config_toml(const std::filesystem::path& path,
                                              std::span<const OptionSection> sections);
/// The same from text; `source` names it in messages.
[[nodiscard]] Result<Config> parse_config_toml(std::string_view text, std::string_view source,
                                               std::span<const OptionSection> sections);

/// One `--set SECTION.OPTION=VALUE`, with the value converted to the option's kind.
struct Setting {
  std::string section;
  std::string option;
  OptionValue value;
};
[[nodiscard]] Result<Setting> parse_setting(std::string_view text, std::span<const OptionSection> sections);

/// Values as a JSON object, keys in alphabetic order.
[[nodiscard]] std::string options_json(const OptionMap& values);

/// A JSON Schema (2020-12) of an object with these options: types, defaults, ranges, choices, units, docs and sources.
[[nodiscard]] std::string option_schema(std::string_view title, std::span<const OptionSpec> specs);

}  // namespace echoarc::io
