// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "cli/help.hpp"
#include "cli/report.hpp"
#include "cli/verb.hpp"

namespace echoarc::cli {
namespace {

std::vector<Verb> all_verbs() {
  return {map_verb(),     eval_verb(),    info_verb(),     doctor_verb(), methods_verb(),   bench_verb(),
          init_verb(),    convert_verb(), sim_verb(),      sweep_verb(),  reproduce_verb(), explain_verb(),
          compare_verb(), explore_verb(), localise_verb(), serve_verb(),  demo_verb()};
}

const std::vector<Example>& first_steps() {
  static const std::vector<Example> examples{
      {"echoarc map room.jsonl", "maps of a log, with pictures, in ./room-map"},
      {"echoarc eval room-map --reference room-truth.csv", "how close they are to the walls"},
      {"echoarc doctor room.jsonl", "what is wrong with a log, and what to do about it"},
      {"echoarc init --preset hc-sr04 --count 5 --layout ring", "a robot description to edit"}};
  return examples;
}

/// CLI11 reports help and version as errors of status 0; everything else is a line we did not understand.
ExitStatus answer(const CLI::App& app, const CLI::ParseError& stop) {
  if (stop.get_exit_code() == 0) return static_cast<ExitStatus>(app.exit(stop));
  const auto chosen = app.get_subcommands();
  const std::string verb = chosen.empty() ? "" : " " + chosen.front()->get_name();
  return misuse({ErrorCode::bad_value, stop.what(), "", fmt::format("echoarc{} --help shows examples", verb)});
}

ExitStatus run(int argc, char** argv) {
  CLI::App app("Ultrasonic range readings in, accurate 2-D maps out.", "echoarc");
  app.set_version_flag("--version", "echoarc " ECHOARC_VERSION);
  app.require_subcommand(1);
  const auto help = std::make_shared<HelpFormatter>(first_steps());
  help->label("SUBCOMMAND", "VERB");
  help->label("Subcommands", "Verbs");
  app.formatter(help);
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Verb& verb : all_verbs()) {
    CLI::App* sub = app.add_subcommand(std::string(verb.name), std::string(verb.summary));
    sub->formatter(std::make_shared<HelpFormatter>(verb.examples));
    actions.emplace_back(sub, verb.declare(*sub));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return answer(app, stop);
  }
  for (const auto& [sub, action] : actions)
    if (sub->parsed()) return action();
  return wrong_usage;
}

}  // namespace
}  // namespace echoarc::cli

int main(int argc, char** argv) {
  try {
    return echoarc::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return echoarc::cli::fail({echoarc::ErrorCode::too_large, "out of memory", "",
                               "map a shorter log, or use larger cells (--set cell_m=0.1)"});
  } catch (const std::exception& error) {
    return echoarc::cli::fail({echoarc::ErrorCode::bad_value, error.what(), "", "please report this as a defect"});
  }
}
