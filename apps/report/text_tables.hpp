// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

#include "echoarc/studies/text_table.hpp"

namespace echoarc::report {

/// The table without its title, as HTML, its note below. Text is escaped.
[[nodiscard]] std::string html_table(const studies::TextTable& table);
/// The table alone as Markdown; bars in cells are escaped.
[[nodiscard]] std::string markdown_table(const studies::TextTable& table);

}  // namespace echoarc::report
