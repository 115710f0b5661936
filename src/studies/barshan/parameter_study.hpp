// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

/// What [Barshan07] 4.3 reports of earlier studies: layouts of transducers, beam width, roughness, curvature, distance,
/// noise of the time of flight, each varied alone.
namespace echoarc::studies::barshan {

/// One variation of a layout scene.
struct Variation {
  std::string study;       ///< "beam width"
  std::string unit;        ///< of `value`
  double value = 0.0;      ///< layouts: their rank in the paper
  std::string label;       ///< "25°", "linear"
  std::string_view scene;  ///< that it starts from
};
[[nodiscard]] std::vector<Variation> variations();

/// The scene of a variation out of the scene it starts from. Errors: sensors that cannot be.
[[nodiscard]] Result<StudyScene> varied(StudyScene scene, const Variation& variation);

/// Runs all of them over the host's seeds.
[[nodiscard]] Result<StudySection> parameter_section(const StudyHost& host, StudyProgress& progress);
/// How many tasks that takes.
[[nodiscard]] std::size_t parameter_tasks(const StudyHost& host);

}  // namespace echoarc::studies::barshan
