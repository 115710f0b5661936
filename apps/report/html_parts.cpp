// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/html_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "echoarc/io/png_file.hpp"
#include "echoarc/studies/svg_chart.hpp"
#include "report/base64.hpp"

namespace echoarc::report {
namespace {

using studies::StudyRow;

std::string paper_value(const StudyRow& row) {
  return row.paper_text.empty() ? number(row.paper, row.decimals) : escaped(row.paper_text);
}

/// Mean, with the spread behind it where there was more than one run.
std::string our_value(const StudyRow& row) {
  std::string text = "<b>" + number(row.ours.mean, row.decimals) + "</b>";
  if (row.ours.values > 1)
    text += fmt::format(R"( <span class="sd">±{}</span>)", number(row.ours.deviation, row.decimals));
  return text;
}

std::string range(const StudyRow& row) {
  if (row.ours.values < 2) return "";
  return fmt::format("{} … {}", number(row.ours.min, row.decimals), number(row.ours.max, row.decimals));
}

std::string with_unit(const std::string& quantity, const std::string& unit) {
  return escaped(quantity) + (unit.empty() ? "" : fmt::format(R"( <span class="unit">{}</span>)", escaped(unit)));
}

std::string rows_body(const studies::StudyTable& table) {
  const bool remarks = std::ranges::any_of(table.rows, [](const StudyRow& row) { return !row.remark.empty(); });
  std::string html =
      "<thead><tr><th>Quantity</th><th>Condition</th><th class=\"n\">Paper</th><th class=\"n\">Ours</th>"
      "<th class=\"n\">Min … max</th>";
  if (remarks) html += "<th>Remark</th>";
  html += "</tr></thead><tbody>";
  for (const StudyRow& row : table.rows) {
    html += fmt::format(
        R"(<tr><td>{}</td><td>{}</td><td class="n">{}</td><td class="n">{}</td><td class="n sd">{}</td>)",
        with_unit(row.quantity, row.unit), escaped(row.condition), paper_value(row), our_value(row), range(row));
    if (remarks) html += "<td>" + escaped(row.remark) + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody>";
}

/// Values of `of`, each once, in the order of their first appearance.
std::vector<std::string> kinds(const studies::StudyTable& table, std::string StudyRow::* of) {
  std::vector<std::string> found;
  for (const StudyRow& row : table.rows)
    if (std::ranges::find(found, row.*of) == found.end()) found.push_back(row.*of);
  return found;
}

const StudyRow* find_row(const studies::StudyTable& table, const std::string& condition, const std::string& quantity) {
  const auto found = std::ranges::find_if(
      table.rows, [&](const StudyRow& row) { return row.condition == condition && row.quantity == quantity; });
  return found == table.rows.end() ? nullptr : &*found;
}

std::string matrix_head(const studies::StudyTable& table, const std::vector<std::string>& quantities) {
  std::string upper = R"(<thead><tr><th rowspan="2"></th>)";
  std::string lower = "<tr>";
  for (const std::string& quantity : quantities) {
    const auto row = std::ranges::find(table.rows, quantity, &StudyRow::quantity);
    upper += fmt::format(R"(<th colspan="2" class="c">{}</th>)", with_unit(quantity, row->unit));
    lower += R"(<th class="n p">paper</th><th class="n">ours</th>)";
  }
  return upper + "</tr>" + lower + "</tr></thead>";
}

std::string matrix_body(const studies::StudyTable& table) {
  const std::vector<std::string> quantities = kinds(table, &StudyRow::quantity);
  std::string html = matrix_head(table, quantities) + "<tbody>";
  for (const std::string& condition : kinds(table, &StudyRow::condition)) {
    html += "<tr><td>" + escaped(condition) + "</td>";
    for (const std::string& quantity : quantities) {
      const StudyRow* row = find_row(table, condition, quantity);
      html += row == nullptr
                  ? R"(<td class="n p"></td><td class="n"></td>)"
                  : fmt::format(R"(<td class="n p">{}</td><td class="n">{}</td>)", paper_value(*row), our_value(*row));
    }
    html += "</tr>\n";
  }
  return html + "</tbody>";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (const char c : text) switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      case '\'': html += "&#39;"; break;
      default: html += c;
    }
  return html;
}

std::string number(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "–";
}

std::string_view words(studies::Verdict verdict) {
  switch (verdict) {
    case studies::Verdict::holds: return "holds";
    case studies::Verdict::fails: return "does not hold";
    default: return "cannot be told";
  }
}

std::string claim_table(const studies::StudySection& section) {
  if (section.claims.empty()) return "";
  std::string html =
      "<div class=\"scroll\"><table class=\"claims\"><thead><tr><th>Claim of the paper</th><th>Ours</th>"
      "<th class=\"n\">Seeds</th><th>Figures</th></tr></thead><tbody>";
  for (const studies::Claim& claim : section.claims) {
    const std::string source =
        claim.source.empty() ? "" : fmt::format(R"( <span class="unit">{}</span>)", escaped(claim.source));
    const char* kind = claim.verdict == studies::Verdict::holds   ? "yes"
                       : claim.verdict == studies::Verdict::fails ? "no"
                                                                  : "open";
    html += fmt::format(
        R"(<tr><td>{}{}</td><td><span class="chip {}">{}</span></td><td class="n">{} / {}</td><td>{}</td></tr>)",
        escaped(claim.text), source, kind, words(claim.verdict), claim.holds_on, claim.seeds, escaped(claim.evidence));
    html += '\n';
  }
  return html + "</tbody></table></div>\n";
}

std::string table(const studies::StudyTable& table) {
  if (table.rows.empty()) return "";
  std::string html = fmt::format("<h4>{}</h4>\n<div class=\"scroll\"><table{}>", escaped(table.title),
                                 table.layout == studies::TableLayout::matrix ? " class=\"matrix\"" : "");
  html += table.layout == studies::TableLayout::matrix ? matrix_body(table) : rows_body(table);
  html += "</table></div>\n";
  if (!table.note.empty()) html += "<p class=\"note\">" + escaped(table.note) + "</p>\n";
  return html;
}

std::string chart(const studies::ChartFigure& figure) {
  return fmt::format("<figure class=\"chart\">{}<figcaption>{}</figcaption></figure>\n", studies::svg(figure.chart),
                     escaped(figure.caption));
}

Result<std::string> picture(const studies::PictureFigure& figure) {
  const Result<std::string> png = io::encode_png(figure.image.width, figure.image.height, figure.image.rgb);
  if (!png) return png.error();
  return fmt::format(
      R"(<figure class="map"><img alt="{}" width="{}" height="{}" src="data:image/png;base64,{}"><figcaption>{}</figcaption></figure>)"
      "\n",
      escaped(figure.caption), figure.image.width, figure.image.height, base64(*png), escaped(figure.caption));
}

}  // namespace echoarc::report
