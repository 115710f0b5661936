// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/option_toml.hpp"

#include <optional>
#include <vector>

#include <fmt/format.h>

namespace echoarc::io {
std::optional<OptionValue> option_value(const toml::node& node) {
  if (const auto* boolean = node.as_boolean()) return OptionValue{boolean->get()};
  if (const auto* integer = node.as_integer()) return OptionValue{integer->get()};
  if (const auto* real = node.as_floating_point()) return OptionValue{real->get()};
  if (const auto* text = node.as_string()) return OptionValue{text->get()};
  return std::nullopt;
}

OptionMap read_option_values(TomlFields& fields, std::span<const OptionSpec> specs) {
  OptionMap values;
  for (const OptionSpec& spec : specs) {
    const toml::node* node = fields.node(spec.name);
    if (node == nullptr) continue;
    const std::optional<OptionValue> value = option_value(*node);
    if (!value) {
      fields.fail(node, fmt::format("{} has the wrong type", spec.name), "use " + legal_values(spec));
      continue;
    }
    const Result<OptionValue> checked = check_option(spec, *value);
    if (checked)
      values.emplace(spec.name, *checked);
    else
      fields.fail(node, checked.error().message, checked.error().remedy);
  }
  return values;
}

void fail_unknown(TomlFields& fields, const toml::node* at, std::string_view what, std::string_view name,
                  std::span<const std::string_view> names) {
  std::vector<OptionSpec> specs(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) specs[i].name = names[i];
  fields.fail(at, fmt::format("there is no {} \"{}\"", what, name), unknown_option(name, specs).remedy);
}

}  // namespace echoarc::io
