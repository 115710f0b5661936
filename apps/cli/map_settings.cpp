// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/map_settings.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/feature_extraction.hpp"
#include "echoarc/io/config.hpp"

namespace echoarc::cli {
namespace {

constexpr std::string_view sensing_name = "sensing";

std::vector<io::OptionSection> all_sections() {
  std::vector<io::OptionSection> sections{{std::string(sensing_name), option_specs<SensingOptions>()}};
  for (const MethodEntry& entry : catalog()) sections.push_back({std::string(entry.name), entry.specs()});
  for (const OptionGroup& group : feature_groups()) sections.push_back({std::string(group.name), group.specs});
  return sections;
}

Result<std::vector<std::string>> choose_methods(const std::vector<std::string>& wanted) {
  std::vector<std::string> chosen;
  for (const std::string& name : wanted) {
    if (name == "all") {
      for (const MethodEntry& entry : catalog()) chosen.emplace_back(entry.name);
    } else if (find_method(name) != nullptr) {
      chosen.push_back(name);
    } else {
      std::vector<std::string_view> names;
      for (const MethodEntry& entry : catalog()) names.push_back(entry.name);
      return Error{ErrorCode::bad_value, fmt::format("there is no method {}", name), "--method",
                   fmt::format("use all, or some of {}", fmt::join(names, ","))};
    }
  }
  std::vector<std::string> once;
  for (std::string& name : chosen)
    if (std::ranges::find(once, name) == once.end()) once.push_back(std::move(name));
  return once;
}

/// Collects values for sensing and the chosen methods.
class SettingCollector {
 public:
  SettingCollector(std::vector<std::string> methods, std::vector<std::string> features, bool takes_features)
      : sections_(all_sections()),
        settings_{std::move(methods), std::move(features), {}, {}},
        takes_features_(takes_features) {}

  [[nodiscard]] Result<void> add_config(const std::filesystem::path& path) {
    const Result<io::Config> config = io::read_config_toml(path, sections_);
    if (!config) return config.error();
    // A file may serve many runs, so it may speak of methods that this one leaves out.
    for (const auto& [section, values] : *config)
      for (const auto& [option, value] : values) put(section, option, value);
    return {};
  }

  [[nodiscard]] Result<void> add(const std::string& text) {
    const std::string key = text.substr(0, text.find('='));
    if (text.find('=') != std::string::npos && key.find('.') == std::string::npos)
      return add_bare(key, text.substr(key.size() + 1));
    const Result<io::Setting> setting = io::parse_setting(text, sections_);
    if (!setting) return setting.error();
    const bool is_feature =
        std::ranges::find(feature_groups(), setting->section, &OptionGroup::name) != feature_groups().end();
    if (!takes_part(setting->section) && is_feature)
      return Error{ErrorCode::bad_value, fmt::format("{} are not among the features of this run", setting->section),
                   "--set " + text,
                   takes_features_ ? fmt::format("add them: --features {}", setting->section)
                                   : std::string("leave it out; `echoarc map` extracts features")};
    if (!takes_part(setting->section))
      return Error{ErrorCode::bad_value, fmt::format("{} is not among the methods of this run", setting->section),
                   "--set " + text,
                   fmt::format("add it: --method {},{}", fmt::join(settings_.methods, ","), setting->section)};
    put(setting->section, setting->option, setting->value);
    return {};
  }

  [[nodiscard]] MapSettings take() { return std::move(settings_); }

 private:
  [[nodiscard]] bool takes_part(std::string_view section) const {
    const auto among = [&](const std::vector<std::string>& names) {
      return std::ranges::find(names, section) != names.end();
    };
    return section == sensing_name || among(settings_.methods) || among(settings_.features);
  }

  void put(const std::string& section, const std::string& option, const OptionValue& value) {
    (section == sensing_name ? settings_.sensing : settings_.options[section]).insert_or_assign(option, value);
  }

  [[nodiscard]] Result<void> add_bare(const std::string& option, const std::string& text) {
    bool of_a_method = false;
    std::vector<OptionSpec> known;
    for (const io::OptionSection& section : sections_) {
      if (!takes_part(section.name)) continue;
      known.insert(known.end(), section.specs.begin(), section.specs.end());
      if (section.name == sensing_name) continue;
      const Result<bool> set = add_to(section, option, text);
      if (!set) return set.error();
      of_a_method = of_a_method || *set;
    }
    if (of_a_method) return {};
    const Result<bool> set = add_to(sections_.front(), option, text);
    if (!set) return set.error();
    return *set ? Result<void>{} : Result<void>{unknown_option(option, known)};
  }

  /// Whether the section has the option.
  [[nodiscard]] Result<bool> add_to(const io::OptionSection& section, const std::string& option,
                                    const std::string& text) {
    const auto spec = std::ranges::find(section.specs, option, &OptionSpec::name);
    if (spec == section.specs.end()) return false;
    const Result<OptionValue> value = parse_option(*spec, text);
    if (!value) return value.error();
    put(section.name, option, *value);
    return true;
  }

  std::vector<io::OptionSection> sections_;  // sensing first
  MapSettings settings_;
  bool takes_features_;
};

}  // namespace

void declare_settings(CLI::App& app, SettingArguments& arguments) {
  app.add_option("--method", arguments.methods, "methods to run, or all; see `echoarc methods`")
      ->delimiter(',')
      ->type_name("A,B")
      ->capture_default_str();
  declare_values(app, arguments);
}

void declare_values(CLI::App& app, SettingArguments& arguments) {
  app.add_option("--set", arguments.settings,
                 "METHOD.OPTION=VALUE, sensing.OPTION=VALUE, or OPTION=VALUE for all methods that have it; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  app.add_option("--config", arguments.config, "TOML with a table of options per method and `sensing`")
      ->type_name("FILE");
}

std::variant<MapSettings, SettingFault> resolve_settings(const SettingArguments& arguments) {
  Result<std::vector<std::string>> methods = choose_methods(arguments.methods);
  if (!methods) return SettingFault{methods.error()};
  Result<std::vector<std::string>> features = choose_features(arguments.features);
  if (!features) return SettingFault{features.error()};
  SettingCollector collector(std::move(*methods), std::move(*features), arguments.takes_features);
  if (!arguments.config.empty())
    if (const Result<void> added = collector.add_config(arguments.config); !added)
      return SettingFault{added.error(), false};
  for (const std::string& setting : arguments.settings)
    if (const Result<void> added = collector.add(setting); !added) return SettingFault{added.error()};
  return collector.take();
}

Result<std::vector<AnyMethod>> make_methods(const MapSettings& settings) {
  std::vector<AnyMethod> methods;
  for (const std::string& name : settings.methods) {
    const auto options = settings.options.find(name);
    Result<AnyMethod> method = make_method(name, options == settings.options.end() ? OptionMap{} : options->second);
    if (!method) return method.error();
    methods.push_back(std::move(*method));
  }
  return methods;
}

}  // namespace echoarc::cli
