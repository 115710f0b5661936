// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/Formatter.hpp>

#include "cli/verb.hpp"

namespace echoarc::cli {

/// Help that begins with lines to copy; the grammar of the command comes after them.
class HelpFormatter final : public CLI::Formatter {
 public:
  explicit HelpFormatter(std::vector<Example> examples) : examples_(std::move(examples)) { column_width(34); }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

 private:
  std::vector<Example> examples_;
};

}  // namespace echoarc::cli
