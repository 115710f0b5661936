// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "echoarc/core/options.hpp"

namespace echoarc::cli {

/// Options that are set under one name: `--set NAME.OPTION=VALUE`. Every method of the catalogue is a group, every
/// extractor of features, and `sensing`, which all share.
struct OptionGroup {
  std::string_view name;
  std::string_view title;
  std::string_view summary;
  std::string_view source;
  std::vector<OptionSpec> specs;
};

/// `sensing`, then the methods in the order of the catalogue, then the extractors of features.
[[nodiscard]] std::vector<OptionGroup> option_groups();

/// The group with everything known of each option, under the keywords of JSON Schema.
[[nodiscard]] nlohmann::ordered_json group_json(const OptionGroup& group);
/// JSON Schema (2020-12) of a configuration: one object per group, one property per option.
[[nodiscard]] nlohmann::ordered_json json_schema(std::span<const OptionGroup> groups);

}  // namespace echoarc::cli
