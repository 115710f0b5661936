// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/sweep_axis.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"

namespace echoarc::studies {
namespace {

/// A table of a scene that holds options.
struct SceneGroup {
  std::string_view name;
  std::vector<OptionSpec> (*specs)();
  Result<void> (*set)(StudyScene&, std::string_view, const OptionValue&);
};

Result<void> set_lasers(StudyScene& scene, std::string_view option, const OptionValue& value) {
  for (sim::LaserOptions& laser : scene.scene.lasers)
    if (Result<void> set = set_option(laser, option, value); !set) return set;
  return {};
}

constexpr std::array scene_groups{
    SceneGroup{"sonar", option_specs<sim::SonarOptions>,
               [](StudyScene& s, std::string_view o, const OptionValue& v) { return set_option(s.scene.sonar, o, v); }},
    SceneGroup{"drive", option_specs<sim::Drive>,
               [](StudyScene& s, std::string_view o, const OptionValue& v) { return set_option(s.scene.drive, o, v); }},
    SceneGroup{
        "odometry", option_specs<sim::OdometryOptions>,
        [](StudyScene& s, std::string_view o, const OptionValue& v) { return set_option(s.scene.odometry, o, v); }},
    SceneGroup{
        "polling", option_specs<sim::PollingOptions>,
        [](StudyScene& s, std::string_view o, const OptionValue& v) { return set_option(s.scene.polling, o, v); }},
    SceneGroup{"laser", option_specs<sim::LaserOptions>, set_lasers},
    SceneGroup{"scoring", option_specs<SceneScoring>,
               [](StudyScene& s, std::string_view o, const OptionValue& v) { return set_option(s.scoring, o, v); }}};

const SceneGroup* find_scene_group(std::string_view name) {
  const auto* found = std::ranges::find(scene_groups, name, &SceneGroup::name);
  return found == scene_groups.end() ? nullptr : found;
}

Error bad_axis(std::string_view text, std::string message, std::string remedy) {
  return {ErrorCode::bad_value, std::move(message), "--option " + std::string(text), std::move(remedy)};
}

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A step's place, without the digits that only binary fractions have: 0.3 after three steps of 0.1.
std::string short_number(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 12);
  return {buffer.data(), end.ptr};
}

Result<std::vector<std::string>> range_texts(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ':');
  std::array<double, 3> ends{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = k < parts.size() ? number_of(parts[k]) : std::nullopt;
    if (!number || parts.size() != 3)
      return bad_axis(text, std::string(text) + " is no range", "write FROM:TO:STEP, as 1:10:1, or values, as 1,2,5");
    ends[k] = *number;
  }
  const auto [from, to, step] = ends;
  const double steps = std::floor((to - from) / step + 1e-9);
  if (step == 0.0 || !std::isfinite(steps) || steps < 0.0)
    return bad_axis(text, "the range " + std::string(text) + " is empty", "let the step lead from FROM to TO");
  if (steps + 1.0 > double(max_axis_values))
    return bad_axis(text, "the range " + std::string(text) + " has more than 10000 values", "make the step larger");
  std::vector<std::string> texts;
  for (std::size_t k = 0; double(k) <= steps; ++k) texts.push_back(short_number(from + double(k) * step));
  return texts;
}

/// What stands before and after the first '='.
struct KeyAndValues {
  std::string_view group;  ///< empty: a bare option
  std::string_view option;
  std::string_view values;
};

std::optional<KeyAndValues> take_apart(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) return std::nullopt;
  const std::string_view key = text.substr(0, equals);
  const std::size_t dot = key.find('.');
  KeyAndValues parts{.group = {}, .option = key, .values = text.substr(equals + 1)};
  if (dot != std::string_view::npos) {
    parts.group = key.substr(0, dot);
    parts.option = key.substr(dot + 1);
  }
  return parts;
}

const OptionSpec* find_spec(std::span<const OptionSpec> specs, std::string_view option) {
  const auto found = std::ranges::find(specs, option, &OptionSpec::name);
  return found == specs.end() ? nullptr : &*found;
}

/// The group's options, or an error that names the groups there are.
Result<std::vector<OptionSpec>> specs_of(std::string_view text, std::string_view group,
                                         std::span<const std::string> methods, bool has_scene) {
  if (group == "sensing") return option_specs<SensingOptions>();
  const SceneGroup* table = find_scene_group(group);
  if (table != nullptr && has_scene) return table->specs();
  if (table != nullptr)
    return bad_axis(text, "a log has no " + std::string(group) + " options", "sweep over a scene (a .toml) instead");
  if (std::ranges::find(methods, group) != methods.end()) return find_method(group)->specs();
  if (find_method(group) != nullptr)
    return bad_axis(text, std::string(group) + " is not among the methods of this sweep",
                    "add it: --method " + std::string(group));
  std::string groups = "sensing";
  if (has_scene)
    for (const SceneGroup& known : scene_groups) groups += ", " + std::string(known.name);
  return bad_axis(text, "there are no options of " + std::string(group),
                  "write OPTION for the methods, METHOD.OPTION, or one of " + groups + " before the dot");
}

/// The option of all methods; a null spec when none has it.
Result<std::optional<OptionSpec>> shared_spec(std::string_view text, std::string_view option,
                                              std::span<const std::string> methods) {
  std::optional<OptionSpec> shared;
  const std::string* lacking = nullptr;
  for (const std::string& method : methods) {
    const std::vector<OptionSpec> specs = find_method(method)->specs();
    const OptionSpec* spec = find_spec(specs, option);
    if (spec == nullptr)
      lacking = &method;
    else if (!shared)
      shared = *spec;
  }
  if (shared && lacking != nullptr)
    return bad_axis(text, "method " + *lacking + " has no option " + std::string(option),
                    "sweep methods that all have it");
  return shared;
}

Result<SweepAxis> with_values(std::string group, const OptionSpec& spec, std::string_view values) {
  Result<std::vector<OptionValue>> parsed = parse_values(spec, values);
  if (!parsed) return parsed.error();
  return SweepAxis{.group = std::move(group),
                   .option = std::string(spec.name),
                   .unit = std::string(spec.unit),
                   .values = std::move(*parsed)};
}

Result<SweepAxis> bare_axis(std::string_view text, const KeyAndValues& parts, std::span<const std::string> methods) {
  const Result<std::optional<OptionSpec>> shared = shared_spec(text, parts.option, methods);
  if (!shared) return shared.error();
  if (*shared) return with_values("method", **shared, parts.values);
  const std::vector<OptionSpec> sensing = option_specs<SensingOptions>();
  const OptionSpec* spec = parts.group.empty() ? find_spec(sensing, parts.option) : nullptr;
  if (spec != nullptr) return with_values("sensing", *spec, parts.values);
  std::vector<OptionSpec> known;
  for (const std::string& method : methods) {
    const std::vector<OptionSpec> specs = find_method(method)->specs();
    known.insert(known.end(), specs.begin(), specs.end());
  }
  return unknown_option(parts.option, known);
}

}  // namespace

bool is_scene_group(std::string_view group) {
  return find_scene_group(group) != nullptr;
}

Result<void> set_scene_option(StudyScene& scene, const SweepAxis& axis, const OptionValue& value) {
  return find_scene_group(axis.group)->set(scene, axis.option, value);
}

Result<std::vector<OptionValue>> parse_values(const OptionSpec& spec, std::string_view text) {
  std::vector<std::string> texts;
  if (text.find(':') != std::string_view::npos) {
    Result<std::vector<std::string>> range = range_texts(text);
    if (!range) return range.error();
    texts = std::move(*range);
  } else {
    for (const std::string_view part : split(text, ',')) texts.emplace_back(part);
  }
  if (texts.size() > max_axis_values) return bad_axis(spec.name, "more than 10000 values", "take fewer");
  std::vector<OptionValue> values;
  for (const std::string& part : texts) {
    Result<OptionValue> value = parse_option(spec, part);
    if (!value) return value.error();
    values.push_back(std::move(*value));
  }
  return values;
}

Result<SweepAxis> parse_axis(std::string_view text, std::span<const std::string> methods, bool has_scene) {
  for (const std::string& method : methods)
    if (const Result<AnyMethod> made = make_method(method); !made) return made.error();
  const auto parts = take_apart(text);
  if (!parts)
    return bad_axis(text, std::string(text) + " sets no option",
                    "write KEY=FROM:TO:STEP or KEY=v1,v2, as threshold=1:10:1");
  if (parts->group.empty() || parts->group == "method") return bare_axis(text, *parts, methods);
  const Result<std::vector<OptionSpec>> specs = specs_of(text, parts->group, methods, has_scene);
  if (!specs) return specs.error();
  const OptionSpec* spec = find_spec(*specs, parts->option);
  if (spec == nullptr) return unknown_option(parts->option, *specs);
  return with_values(std::string(parts->group), *spec, parts->values);
}

}  // namespace echoarc::studies
