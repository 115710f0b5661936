// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/choset2003.hpp"

#include <array>
#include <utility>

#include "studies/choset/chapters.hpp"

namespace echoarc::studies {

Result<StudyReport> choset2003(const StudyHost& host) {
  StudyReport report;
  report.name = "choset2003";
  report.title =
      "The Arc-Transversal Median Algorithm: A Geometric Approach to Increasing Ultrasonic Sensor Azimuth Accuracy";
  report.source = "Choset, Nagatani, Lazar; IEEE Transactions on Robotics and Automation 19(3), 2003";
  report.seeds = host.seeds;
  report.summary = {
      "A ring of 16 sonars with a beam of 22.5 degrees and ranges in steps of one inch, one sweep a second at five "
      "inches "
      "a second; arcs that cross at 30 degrees or more, ten arcs per sonar, all as printed. The walls are rough, as "
      "those "
      "of the paper's laboratory were."};
  const Result<StudyScene> opening = host.scene("opening-near");
  if (!opening) return opening.error();
  report.sections.push_back(choset::resolution_numbers(opening.value().scene));
  StudyProgress progress(host, choset::drives_per_seed * std::size_t(host.seeds));
  for (const auto chapter : {&choset::narrow_opening, &choset::t_world, &choset::constant_depth}) {
    Result<StudySection> section = chapter(host, progress);
    if (!section) return section.error();
    report.sections.push_back(std::move(*section));
  }
  return report;
}

}  // namespace echoarc::studies
