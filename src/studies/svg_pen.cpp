// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/svg_pen.hpp"

#include "studies/chart_axis.hpp"

namespace echoarc::studies {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\t')
      safe += c;
  }
  return safe;
}

std::string px(double value) {
  return fixed(value, 1);
}

void SvgPen::text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more) {
  out += "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + std::string(anchor) + "\"";
  out += (more.empty() ? "" : " ") + std::string(more) + ">" + escaped(content) + "</text>\n";
}

void SvgPen::segment(double x1, double y1, double x2, double y2, std::string_view style) {
  out += "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) + "\" " +
         std::string(style) + "/>\n";
}

void SvgPen::marker(double x, double y, std::size_t shape, std::string_view color) {
  const std::string fill = "\" fill=\"" + std::string(color) + "\"/>\n";
  if (shape % 3 == 0)
    out += "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"3.5" + fill;
  else if (shape % 3 == 1)
    out += "<rect x=\"" + px(x - 3.2) + "\" y=\"" + px(y - 3.2) + R"(" width="6.4" height="6.4)" + fill;
  else
    out += "<path d=\"M" + px(x - 4.2) + " " + px(y + 3.4) + "h8.4l-4.2 -7.6z" + fill;
}

void SvgPen::rectangle(double x, double y, double width, double height, std::string_view color) {
  out += "<rect x=\"" + px(x) + "\" y=\"" + px(y) + "\" width=\"" + px(width) + "\" height=\"" + px(height) +
         "\" fill=\"" + std::string(color) + "\"/>\n";
}

}  // namespace echoarc::studies
