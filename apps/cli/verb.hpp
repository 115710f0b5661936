// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <CLI/App.hpp>

namespace echoarc::cli {

/// What the process answers to its caller.
enum ExitStatus : int {
  done = 0,
  failed = 1,         ///< cause and remedy stand on stderr
  wrong_usage = 2,    ///< the command line itself cannot be meant
  interrupted = 130,  ///< Ctrl-C or SIGTERM; what there was is written
};

/// A command line to copy, and what it does. The tests run every one of them.
struct Example {
  std::string_view command;
  std::string_view what;
};

/// What is left to do once the command line has been read.
using Action = std::function<ExitStatus()>;

/// One verb of the command: `echoarc NAME ...`.
struct Verb {
  std::string_view name;
  std::string_view summary;
  std::vector<Example> examples;
  /// Declares the arguments on `app`; the action runs after they are parsed.
  Action (*declare)(CLI::App& app);
};

[[nodiscard]] Verb init_verb();
[[nodiscard]] Verb info_verb();
[[nodiscard]] Verb doctor_verb();
[[nodiscard]] Verb sim_verb();
[[nodiscard]] Verb map_verb();
[[nodiscard]] Verb eval_verb();
[[nodiscard]] Verb sweep_verb();
[[nodiscard]] Verb methods_verb();
[[nodiscard]] Verb bench_verb();
[[nodiscard]] Verb explain_verb();
[[nodiscard]] Verb convert_verb();
[[nodiscard]] Verb reproduce_verb();
[[nodiscard]] Verb compare_verb();
[[nodiscard]] Verb explore_verb();
[[nodiscard]] Verb localise_verb();
[[nodiscard]] Verb serve_verb();
[[nodiscard]] Verb demo_verb();

}  // namespace echoarc::cli
