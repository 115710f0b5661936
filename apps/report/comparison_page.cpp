// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <vector>

#include <fmt/format.h>

#include "echoarc/studies/comparison_report.hpp"
#include "report/comparison_document.hpp"
#include "report/html_parts.hpp"
#include "report/style.hpp"
#include "report/text_tables.hpp"

namespace echoarc::report {
namespace {

using studies::ComparisonSection;

// Sections with more tables than this fold them away but for the first.
constexpr std::size_t open_tables = 6;

std::string_view own_style() {
  return "summary { cursor: pointer; padding: .3rem 0; color: var(--accent); }\n"
         ".wide { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr)); gap: 1rem; "
         "}\n";
}

std::string tables_html(const ComparisonSection& section) {
  std::string html;
  for (std::size_t k = 0; k < section.tables.size(); ++k) {
    const studies::TextTable& table = section.tables[k];
    if (k > 0 && section.tables.size() > open_tables)
      html += fmt::format("<details><summary>{}</summary>\n{}</details>\n", escaped(table.title), html_table(table));
    else
      html += fmt::format("<h4>{}</h4>\n{}", escaped(table.title), html_table(table));
  }
  return html;
}

Result<std::string> section_html(const ComparisonSection& section) {
  std::string html = fmt::format("<section id=\"{}\"><h2>{}</h2>\n", escaped(section.id), escaped(section.title));
  for (const std::string& text : section.paragraphs) html += "<p>" + escaped(text) + "</p>\n";
  if (!section.charts.empty()) {
    html += "<div class=\"figures\">\n";
    for (const studies::ChartFigure& figure : section.charts) html += chart(figure);
    html += "</div>\n";
  }
  html += tables_html(section);
  if (!section.pictures.empty()) {
    html += "<div class=\"wide\">\n";
    for (const studies::PictureFigure& figure : section.pictures) {
      const Result<std::string> drawn = picture(figure);
      if (!drawn) return drawn.error();
      html += *drawn;
    }
    html += "</div>\n";
  }
  return html + "</section>\n";
}

std::string head_html(const ComparisonDocument& document, const std::vector<ComparisonSection>& sections) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>Mapping methods compared</title>\n"
      "<style>{}{}</style>\n</head>\n<body>\n<header><h1>Mapping methods compared</h1>\n"
      "<p class=\"lead\">{} on {}: recorded logs against their laser, simulated scenes against their surfaces.</p>\n"
      "<p class=\"note\">echoarc {} · <code>{}</code></p>\n</header>\n",
      style_sheet(), own_style(), fmt::format("{} settings of methods", document.comparison.methods.size()),
      fmt::format("{} places", document.comparison.places.size()), escaped(document.version),
      escaped(document.command));
  html += "<nav aria-label=\"Contents\"><h3>Contents</h3><ul>\n";
  for (const ComparisonSection& section : sections)
    html +=
        fmt::format("<li class=\"paper\"><a href=\"#{}\">{}</a></li>\n", escaped(section.id), escaped(section.title));
  return html + "</ul></nav>\n";
}

}  // namespace

Result<std::string> comparison_page(const ComparisonDocument& document) {
  const std::vector<ComparisonSection> sections = studies::comparison_sections(document.comparison);
  std::string html = head_html(document, sections) + "<main>\n";
  for (const ComparisonSection& section : sections) {
    const Result<std::string> part = section_html(section);
    if (!part) return part.error();
    html += *part;
  }
  return html +
         "</main>\n<footer>Made by echoarc. The same figures for programs: "
         "comparison.json.</footer>\n</body>\n</html>\n";
}

}  // namespace echoarc::report
