// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "studies/chart_axis.hpp"
#include "studies/comparison/chapters.hpp"

namespace echoarc::studies {
namespace comparison {

std::string percent(double share) {
  return std::isfinite(share) ? fixed(100.0 * share, 1) : "-";
}

std::string accuracy_and_coverage(const MeanScores& scores) {
  return percent(scores.accuracy[1]) + " / " + percent(scores.coverage);
}

std::string anchor_of(const std::string& place) {
  std::string anchor;
  for (const char c : place)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      anchor += c;
    else if (!anchor.empty() && anchor.back() != '-')
      anchor += '-';
  return anchor;
}

ComparisonSection picture_section(const Comparison& comparison) {
  ComparisonSection section{.id = "pictures", .title = "Maps side by side"};
  section.paragraphs = {
      "Grey: the reference. Blue line: the robot's path. Dark points lie within 10 cm of the reference, red ones do "
      "not. Grey without dark points over it was not found."};
  for (const ComparedPlace& place : comparison.places)
    if (place.picture) section.pictures.push_back(*place.picture);
  return section;
}

}  // namespace comparison

std::vector<ComparisonSection> comparison_sections(const Comparison& comparison) {
  std::vector<ComparisonSection> sections;
  for (ComparisonSection (*const chapter)(const Comparison&) :
       {&comparison::score_section, &comparison::duel_section, &comparison::truncation_section,
        &comparison::calibration_section, &comparison::pixel_section, &comparison::picture_section}) {
    ComparisonSection section = chapter(comparison);
    if (!section.tables.empty() || !section.charts.empty() || !section.pictures.empty())
      sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace echoarc::studies
