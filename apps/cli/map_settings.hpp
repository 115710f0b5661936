// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"

namespace echoarc::cli {

/// What the command line says about methods and options.
struct SettingArguments {
  /// The default: where the walls are, and where it is free. "all" stands for the whole catalogue.
  std::vector<std::string> methods{"consensus", "evidence"};
  std::vector<std::string> settings;  ///< of --set, in their order: a later one wins
  std::vector<std::string> features;  ///< names of extractors, or "all"
  bool takes_features = false;        ///< whether the verb has --features
  std::filesystem::path config;       ///< TOML with a table per method and `sensing`; empty: none
};

/// Declares --method, --set and --config.
void declare_settings(CLI::App& app, SettingArguments& arguments);
/// Declares --set and --config, for verbs that serve one method.
void declare_values(CLI::App& app, SettingArguments& arguments);

/// Which methods run, and with what.
struct MapSettings {
  std::vector<std::string> methods;   ///< names of the catalogue, no two alike
  std::vector<std::string> features;  ///< names of extractors, no two alike
  OptionMap sensing;
  std::map<std::string, OptionMap> options;  ///< by method or extractor; what was given, defaults left out
};

/// An error, and whether the command line or a file is to blame.
struct SettingFault {
  Error error;
  bool command_line = true;
};

/// Config file first, --set over it. `METHOD.OPTION` and `sensing.OPTION` name their owner; a bare `OPTION` is given to
/// every chosen method that has it, or to sensing where none has.
[[nodiscard]] std::variant<MapSettings, SettingFault> resolve_settings(const SettingArguments& arguments);

/// The methods, empty, in the order of the settings.
[[nodiscard]] Result<std::vector<AnyMethod>> make_methods(const MapSettings& settings);

}  // namespace echoarc::cli
