// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "cli/log_input.hpp"
#include "echoarc/studies/sweep.hpp"

namespace echoarc::cli {

/// What the command line says of what a sweep maps and judges.
struct SubjectArguments {
  LogArguments log;       ///< `log` is the scene or the log
  std::string reference;  ///< of a log
  std::vector<double> region;
  std::string direction;  ///< "axis:90"; empty: none
};

/// Declares SCENE, --reference, --doi, --region and the files of a log.
void declare_subject(CLI::App& app, SubjectArguments& arguments);

/// Whether the argument names a scene: a .toml file, or a scene that the program carries along.
[[nodiscard]] bool names_scene(const SubjectArguments& arguments);

/// The scene with its scoring, or the log with its reference. Errors: a scene that cannot be judged, a log without
/// --reference, and whatever reading objects to.
[[nodiscard]] Result<studies::SweepSubject> load_subject(const SubjectArguments& arguments);

}  // namespace echoarc::cli
