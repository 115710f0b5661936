// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

/// A paper whose experiments can be run again on simulated scenes.
struct Reproduction {
  std::string_view name;     ///< as the command spells it, and `StudyReport::name`
  std::string_view summary;  ///< what is run, in a line
  /// Runs everything over the host's seeds. The same seeds give the same report on any number of threads, but for
  /// times. Errors: those of the scenes and of `Experiment`; `interrupted`.
  Result<StudyReport> (*run)(const StudyHost& host);
};

/// All of them, in the order of a report.
[[nodiscard]] std::span<const Reproduction> reproductions();
/// The one of a name, or nullptr.
[[nodiscard]] const Reproduction* find_reproduction(std::string_view name);

}  // namespace echoarc::studies
