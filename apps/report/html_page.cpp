// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "report/html_parts.hpp"
#include "report/report_document.hpp"
#include "report/style.hpp"

namespace echoarc::report {
namespace {

using studies::Claim;
using studies::StudyReport;
using studies::StudySection;
using studies::Verdict;

struct ClaimCount {
  std::size_t all = 0;
  std::size_t holds = 0;
  std::size_t open = 0;
};

void count(const StudySection& section, ClaimCount& total) {
  for (const Claim& claim : section.claims) {
    ++total.all;
    if (claim.verdict == Verdict::holds) ++total.holds;
    if (claim.verdict == Verdict::undecided) ++total.open;
  }
}

ClaimCount count(const StudyReport& study) {
  ClaimCount total;
  for (const StudySection& section : study.sections) count(section, total);
  return total;
}

std::string anchor(const StudyReport& study, const StudySection& section) {
  return escaped(study.name + "-" + section.id);
}

std::string paragraphs(const std::vector<std::string>& texts) {
  std::string html;
  for (const std::string& text : texts) html += "<p>" + escaped(text) + "</p>\n";
  return html;
}

/// Which claims hold, section by section: the first thing to look at.
std::string summary_table(const ReportDocument& document) {
  std::string html =
      "<div class=\"scroll\"><table class=\"claims\"><thead><tr><th>Paper and part</th><th class=\"n\">Hold</th>"
      "<th class=\"n\">Do not</th><th class=\"n\">Open</th><th>What does not hold</th></tr></thead><tbody>";
  for (const StudyReport& study : document.studies) {
    const ClaimCount all = count(study);
    html += fmt::format(
        R"(<tr><td><a href="#{}"><b>{}</b></a></td><td class="n"><b>{}</b></td><td class="n"><b>{}</b></td><td class="n"><b>{}</b></td><td></td></tr>)"
        "\n",
        escaped(study.name), escaped(study.name), all.holds, all.all - all.holds - all.open, all.open);
    for (const StudySection& section : study.sections) {
      ClaimCount part;
      count(section, part);
      if (part.all == 0) continue;
      std::string failed;
      for (const Claim& claim : section.claims)
        if (claim.verdict == Verdict::fails) failed += (failed.empty() ? "" : "; ") + escaped(claim.text);
      html += fmt::format(
          R"(<tr><td>&ensp;<a href="#{}">{}</a></td><td class="n">{}</td><td class="n">{}</td><td class="n">{}</td><td>{}</td></tr>)"
          "\n",
          anchor(study, section), escaped(section.title), part.holds, part.all - part.holds - part.open, part.open,
          failed);
    }
  }
  return html + "</tbody></table></div>\n";
}

std::string contents(const ReportDocument& document) {
  std::string html = "<nav aria-label=\"Contents\"><h3>Contents</h3><ul>\n";
  for (const StudyReport& study : document.studies) {
    html += fmt::format("<li class=\"paper\"><a href=\"#{}\">{}</a></li>\n", escaped(study.name), escaped(study.name));
    for (const StudySection& section : study.sections)
      html += fmt::format("<li class=\"part\"><a href=\"#{}\">{}</a></li>\n", anchor(study, section),
                          escaped(section.title));
  }
  return html + "</ul></nav>\n";
}

Result<std::string> section_html(const StudyReport& study, const StudySection& section) {
  std::string html = fmt::format("<section id=\"{}\"><h3>{}</h3>\n", anchor(study, section), escaped(section.title));
  html += paragraphs(section.paragraphs) + claim_table(section);
  for (const studies::StudyTable& one : section.tables) html += table(one);
  if (!section.charts.empty()) {
    html += "<div class=\"figures\">\n";
    for (const studies::ChartFigure& figure : section.charts) html += chart(figure);
    html += "</div>\n";
  }
  if (!section.pictures.empty()) {
    html += "<div class=\"maps\">\n";
    for (const studies::PictureFigure& figure : section.pictures) {
      const Result<std::string> drawn = picture(figure);
      if (!drawn) return drawn.error();
      html += *drawn;
    }
    html += "</div>\n";
  }
  return html + paragraphs(section.remarks) + "</section>\n";
}

std::string head(const ReportDocument& document) {
  std::string names;
  for (const StudyReport& study : document.studies) names += (names.empty() ? "" : ", ") + study.name;
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>Reproductions: {}</title>\n<style>{}</style>\n"
      "</head>\n<body>\n",
      escaped(names), style_sheet());
}

std::string opening(const ReportDocument& document) {
  const int seeds = document.studies.empty() ? 0 : document.studies.front().seeds;
  return fmt::format(
      "<header><h1>Published results beside ours</h1>\n"
      "<p class=\"lead\">Every scene was simulated {} times, each with a seed of its own. One profile of the simulated "
      "sonar serves all scenes, and no method was tuned. Figures are means over the seeds, ± one standard deviation. "
      "A claim holds when it holds for the means; beside it stands on how many seeds it holds.</p>\n"
      "<p class=\"note\">echoarc {} · <code>{}</code></p>\n",
      seeds, escaped(document.version), escaped(document.command));
}

}  // namespace

Result<std::string> html_page(const ReportDocument& document) {
  std::string html = head(document) + opening(document) + summary_table(document) + "</header>\n" + contents(document);
  html += "<main>\n";
  for (const StudyReport& study : document.studies) {
    html += fmt::format("<article id=\"{}\"><h2>{}</h2>\n<p class=\"lead\">{}</p>\n", escaped(study.name),
                        escaped(study.title), escaped(study.source));
    html += paragraphs(study.summary);
    for (const StudySection& section : study.sections) {
      const Result<std::string> part = section_html(study, section);
      if (!part) return part.error();
      html += *part;
    }
    html += "</article>\n";
  }
  return html +
         "</main>\n<footer>Made by echoarc. The same figures for programs: report.json.</footer>\n</body>\n</html>\n";
}

}  // namespace echoarc::report
