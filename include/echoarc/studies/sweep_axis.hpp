// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"

namespace echoarc::studies {

/// An option and the values it takes one after the other; a single value sets it.
struct SweepAxis {
  /// Whose option: "method" (of every method of the sweep), the name of one method, "sensing", or a table of the scene:
  /// "sonar", "drive", "odometry", "polling", "laser" (every laser) or "scoring".
  std::string group;
  std::string option;
  std::string unit;
  std::vector<OptionValue> values;

  /// "threshold", "sonar.threshold_db".
  [[nodiscard]] std::string key() const { return group == "method" ? option : group + "." + option; }
};

/// More values than this are a mistake.
inline constexpr std::size_t max_axis_values = 10'000;

/// Values out of "FROM:TO:STEP" (both ends included, where the steps meet them) or "v1,v2,...". Errors: what
/// `parse_option` says of a value; a range without a value, or whose step leads nowhere; too many values.
[[nodiscard]] Result<std::vector<OptionValue>> parse_values(const OptionSpec& spec, std::string_view text);

/// An axis out of "KEY=VALUES". KEY is OPTION or method.OPTION, which all of `methods` must have (a bare name that none
/// has is looked for in sensing), or GROUP.OPTION. Tables of scenes are known where `has_scene`. Errors: those of
/// `parse_values`, options that are unknown or that a method lacks.
[[nodiscard]] Result<SweepAxis> parse_axis(std::string_view text, std::span<const std::string> methods, bool has_scene);

/// Puts a value into a table of a scene. Requires a group of a scene; errors: those of `set_option`.
[[nodiscard]] Result<void> set_scene_option(StudyScene& scene, const SweepAxis& axis, const OptionValue& value);
/// Whether the group is a table of scenes.
[[nodiscard]] bool is_scene_group(std::string_view group);

}  // namespace echoarc::studies
