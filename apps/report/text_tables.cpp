// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/text_tables.hpp"

#include <vector>

#include <fmt/format.h>

#include "report/html_parts.hpp"

namespace echoarc::report {
namespace {

std::string html_row(const studies::TextTable& table, const std::vector<std::string>& cells, std::string_view tag) {
  std::string html = "<tr>";
  for (std::size_t k = 0; k < cells.size(); ++k)
    html += fmt::format("<{}{}>{}</{}>", tag, k < table.words ? "" : R"( class="n")", escaped(cells[k]), tag);
  return html + "</tr>\n";
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += ' ';
    for (const char c : cell) text += c == '|' ? std::string("\\|") : std::string(1, c);
    text += " |";
  }
  return text + "\n";
}

}  // namespace

std::string html_table(const studies::TextTable& table) {
  std::string html = "<div class=\"scroll\"><table><thead>" + html_row(table, table.head, "th") + "</thead><tbody>\n";
  for (const std::vector<std::string>& row : table.rows) html += html_row(table, row, "td");
  html += "</tbody></table></div>\n";
  if (!table.note.empty()) html += "<p class=\"note\">" + escaped(table.note) + "</p>\n";
  return html;
}

std::string markdown_table(const studies::TextTable& table) {
  std::string text = markdown_row(table.head) + "|";
  for (std::size_t k = 0; k < table.head.size(); ++k) text += k < table.words ? " --- |" : " ---: |";
  text += "\n";
  for (const std::vector<std::string>& row : table.rows) text += markdown_row(row);
  return text;
}

}  // namespace echoarc::report
