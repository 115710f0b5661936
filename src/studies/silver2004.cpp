// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/silver2004.hpp"

#include <algorithm>
#include <utility>

#include "studies/silver/chapters.hpp"

namespace echoarc::studies {

Result<StudyReport> silver2004(const StudyHost& host) {
  StudyReport report;
  report.name = "silver2004";
  report.title = "Arc Carving: Obtaining Accurate, Low Latency Maps from Ultrasonic Range Sensors";
  report.source = "Silver, Morales, Rekleitis, Lisien, Choset; ICRA 2004";
  report.seeds = host.seeds;
  report.summary = {
      "A robot with a ring of 16 sonars and a history of 250 arcs; ranges beyond 150 inches and jumps of more than 0.5 "
      "m "
      "are filtered as in Appendix B. Three places: a building for the statistics, a hallway and a junction for the "
      "maps."};
  StudyProgress progress(host, std::size_t(std::min(host.seeds, silver::building_seeds) + 2 * host.seeds));
  for (const auto chapter : {&silver::building, &silver::hallway, &silver::junction}) {
    Result<StudySection> section = chapter(host, progress);
    if (!section) return section.error();
    report.sections.push_back(std::move(*section));
  }
  return report;
}

}  // namespace echoarc::studies
