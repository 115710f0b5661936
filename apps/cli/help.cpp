// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/help.hpp"

#include <CLI/App.hpp>
#include <fmt/format.h>

namespace echoarc::cli {

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  // A parent asks for a line per verb; only the verb's own page shows examples.
  if (mode == CLI::AppFormatMode::Sub) return Formatter::make_help(app, std::move(name), mode);
  std::string text = "Examples:\n";
  for (const Example& example : examples_) text += fmt::format("  {}\n      {}\n", example.command, example.what);
  return text + "\n" + Formatter::make_help(app, std::move(name), mode);
}

}  // namespace echoarc::cli
