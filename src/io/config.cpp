// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/config.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files.hpp"
#include "io/option_toml.hpp"

namespace echoarc::io {
namespace {

const OptionSection* find_section(std::span<const OptionSection> sections, std::string_view name) {
  const auto found = std::ranges::find(sections, name, &OptionSection::name);
  return found != sections.end() ? &*found : nullptr;
}

const OptionSpec* find_spec(const OptionSection& section, std::string_view name) {
  const auto found = std::ranges::find(section.specs, name, &OptionSpec::name);
  return found != section.specs.end() ? &*found : nullptr;
}

Error unknown_section(std::string_view name, std::span<const OptionSection> sections, std::string where) {
  std::vector<std::string_view> names;
  for (const OptionSection& section : sections) names.push_back(section.name);
  return {ErrorCode::bad_value, fmt::format("there is no section {}", name), std::move(where),
          fmt::format("use one of {}", fmt::join(names, ", "))};
}

Error located(Error error, std::string_view source, const toml::source_region& region) {
  error.where = toml_place(source, region);
  return error;
}

Result<OptionMap> read_section(const toml::table& table, std::string_view source, const OptionSection& section) {
  OptionMap values;
  for (const auto& [key, node] : table) {
    const OptionSpec* spec = find_spec(section, key.str());
    if (spec == nullptr) return located(unknown_option(key.str(), section.specs), source, key.source());
    const std::optional<OptionValue> value = option_value(node);
    if (!value)
      return Error{ErrorCode::bad_value, fmt::format("{} has the wrong type", key.str()),
                   toml_place(source, key.source()), "use " + legal_values(*spec)};
    const Result<OptionValue> checked = check_option(*spec, *value);
    if (!checked) return located(checked.error(), source, key.source());
    values.emplace(key.str(), *checked);
  }
  return values;
}

}  // namespace

Result<Config> parse_config_toml(std::string_view text, std::string_view source,
                                 std::span<const OptionSection> sections) {
  const Result<toml::table> root = parse_toml(text, source);
  if (!root) return root.error();
  Config config;
  for (const auto& [key, node] : *root) {
    const std::string where = toml_place(source, key.source());
    const OptionSection* section = find_section(sections, key.str());
    if (section == nullptr) return unknown_section(key.str(), sections, where);
    if (!node.is_table())
      return Error{ErrorCode::bad_value, fmt::format("{} is no section", key.str()), where,
                   fmt::format("write [{}] on a line of its own, its options below", key.str())};
    Result<OptionMap> values = read_section(*node.as_table(), source, *section);
    if (!values) return values.error();
    config.emplace(key.str(), std::move(*values));
  }
  return config;
}

Result<Config> read_config_toml(const std::filesystem::path& path, std::span<const OptionSection> sections) {
  const Result<std::string> text = read_file(path, max_description_bytes);
  if (!text) return text.error();
  return parse_config_toml(*text, path.string(), sections);
}

Result<Setting> parse_setting(std::string_view text, std::span<const OptionSection> sections) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.substr(0, equals).find('.');
  const std::string where = fmt::format("--set {}", text);
  if (equals == std::string_view::npos || dot == std::string_view::npos)
    return Error{ErrorCode::bad_value, "is not SECTION.OPTION=VALUE", where,
                 "write it as in --set evidence.cell_m=0.01"};
  const std::string_view section_name = text.substr(0, dot);
  const std::string_view option = text.substr(dot + 1, equals - dot - 1);
  const OptionSection* section = find_section(sections, section_name);
  if (section == nullptr) return unknown_section(section_name, sections, where);
  const OptionSpec* spec = find_spec(*section, option);
  Error error = unknown_option(option, section->specs);
  if (spec != nullptr) {
    const Result<OptionValue> value = parse_option(*spec, text.substr(equals + 1));
    if (value) return Setting{std::string(section_name), std::string(option), *value};
    error = value.error();
  }
  error.where = where;
  return error;
}

}  // namespace echoarc::io
