// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>
#include <vector>

#include "echoarc/io/png_file.hpp"
#include "echoarc/studies/comparison_report.hpp"
#include "echoarc/studies/svg_chart.hpp"
#include "report/comparison_document.hpp"
#include "report/text_tables.hpp"

namespace echoarc::report {

Result<std::vector<ReportFile>> comparison_files(const ComparisonDocument& document) {
  Result<std::string> page = comparison_page(document);
  if (!page) return page.error();
  std::vector<ReportFile> files{{"comparison.json", comparison_json(document)},
                                {"comparison.html", std::move(*page)},
                                {"tables/command.md", "\n    " + document.command + "\n\n"}};
  for (const studies::ComparisonSection& section : studies::comparison_sections(document.comparison)) {
    for (const studies::TextTable& table : section.tables)
      files.push_back({"tables/" + table.id + ".md", markdown_table(table)});
    for (const studies::ChartFigure& figure : section.charts)
      files.push_back({"pictures/" + figure.id + ".svg", studies::svg(figure.chart)});
    for (const studies::PictureFigure& figure : section.pictures) {
      Result<std::string> png = io::encode_png(figure.image.width, figure.image.height, figure.image.rgb);
      if (!png) return png.error();
      files.push_back({"pictures/" + figure.id + ".png", std::move(*png)});
    }
  }
  return files;
}

}  // namespace echoarc::report
