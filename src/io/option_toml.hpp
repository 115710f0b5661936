// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <span>

#include "echoarc/core/options.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// A value as options hold it; nothing for lists, tables and dates.
[[nodiscard]] std::optional<OptionValue> option_value(const toml::node& node);

/// The options among the keys of a table, held against their kinds and ranges. Errors stay in `fields`, at the line of
/// the value; keys that are no options are left to the caller's `finish`.
[[nodiscard]] OptionMap read_option_values(TomlFields& fields, std::span<const OptionSpec> specs);

/// Reads the options of `S` from a table over the values that `options` holds.
template <OptionStruct S>
void read_options(TomlFields& fields, S& options) {
  for (const auto& [name, value] : read_option_values(fields, option_specs<S>()))
    if (const Result<void> set = set_option(options, name, value); !set) fields.fail(set.error());
}

/// The error for a name that is none of `names`: says which is nearest, or lists them.
void fail_unknown(TomlFields& fields, const toml::node* at, std::string_view what, std::string_view name,
                  std::span<const std::string_view> names);

}  // namespace echoarc::io
