// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/result.hpp"

/// Option fields: every option struct lists its fields once, as data. Validation, `--help`, `--set`, TOML, JSON and the
/// docs table all derive from that list.
///
///     struct VotingOptions {
///       int threshold = 4;
///       static constexpr auto fields() {
///         return std::tuple{field("threshold", &VotingOptions::threshold,
///                                 {.unit = "arcs", .min = 1, .max = 65535, .doc = "...", .source =
///                                 "[Barshan07] 3.2"})};
///       }
///     };
///
/// Member types: bool, int, double, Angle (spoken in degrees, name ending in `_deg`) and enums that have `choices(E)`.
namespace echoarc {

using OptionValue = std::variant<bool, std::int64_t, double, std::string>;
using OptionMap = std::map<std::string, OptionValue, std::less<>>;

enum class OptionKind { boolean, integer, real, choice };

/// The part of a field's declaration that is not its place in the struct.
struct FieldInfo {
  std::string_view unit = "";
  double min = -std::numeric_limits<double>::infinity();  ///< legal range, both ends included
  double max = std::numeric_limits<double>::infinity();
  std::string_view doc;
  std::string_view source = "";
};

template <class Struct, class T>
struct Field {
  std::string_view name;
  T Struct::* member;
  FieldInfo info;
};

template <class Struct, class T>
[[nodiscard]] constexpr Field<Struct, T> field(std::string_view name, T Struct::* member, FieldInfo info) {
  return {name, member, info};
}

/// One name of an enumerator; an enum used as an option has a `constexpr std::array<Choice<E>, N> choices(E)` beside
/// it.
template <class E>
struct Choice {
  E value;
  std::string_view name;
};

/// A field as front ends see it.
struct OptionSpec {
  std::string_view name;
  OptionKind kind = OptionKind::real;
  std::string_view unit;
  OptionValue default_value;
  double min = 0.0;
  double max = 0.0;
  std::vector<std::string_view> choices;
  std::string_view doc;
  std::string_view source;
};

/// `text` as a value of the option's kind. The error names option, legal values and unit.
[[nodiscard]] Result<OptionValue> parse_option(const OptionSpec& spec, std::string_view text);
/// `value` converted to the option's kind and held against its range and choices.
[[nodiscard]] Result<OptionValue> check_option(const OptionSpec& spec, const OptionValue& value);
/// Shortest text that reads back as the same value; booleans are `true` and `false`.
[[nodiscard]] std::string to_text(const OptionValue& value);
/// "0.001 to 10 m", "gaussian, uniform or parabolic", "true or false".
[[nodiscard]] std::string legal_values(const OptionSpec& spec);
/// The error for a name that is none of `specs`; suggests the nearest.
[[nodiscard]] Error unknown_option(std::string_view name, std::span<const OptionSpec> specs);

template <class E>
concept ChoiceEnum = std::is_enum_v<E> && requires(E e) { choices(e).begin(); };

namespace detail {

template <class T>
constexpr OptionKind kind_of() {
  if constexpr (std::same_as<T, bool>)
    return OptionKind::boolean;
  else if constexpr (std::same_as<T, int>)
    return OptionKind::integer;
  else if constexpr (std::same_as<T, double> || std::same_as<T, Angle>)
    return OptionKind::real;
  else {
    static_assert(ChoiceEnum<T>, "option fields are bool, int, double, Angle, or an enum with choices()");
    return OptionKind::choice;
  }
}

template <class T>
OptionValue to_value(const T& member) {
  if constexpr (std::same_as<T, bool>)
    return member;
  else if constexpr (std::same_as<T, int>)
    return std::int64_t{member};
  else if constexpr (std::same_as<T, double>)
    return member;
  else if constexpr (std::same_as<T, Angle>)
    return member.deg();
  else {
    for (const auto& choice : choices(T{}))
      if (choice.value == member) return std::string(choice.name);
    return std::string("?");
  }
}

template <class T>
void from_checked_value(T& member, const OptionValue& value) {
  if constexpr (std::same_as<T, bool>)
    member = std::get<bool>(value);
  else if constexpr (std::same_as<T, int>)
    member = static_cast<int>(std::get<std::int64_t>(value));
  else if constexpr (std::same_as<T, double>)
    member = std::get<double>(value);
  else if constexpr (std::same_as<T, Angle>)
    member = degrees(std::get<double>(value));
  else {
    for (const auto& choice : choices(T{}))
      if (choice.name == std::get<std::string>(value)) member = choice.value;
  }
}

template <class Struct, class T>
OptionSpec spec_of(const Field<Struct, T>& f) {
  OptionSpec spec{f.name, kind_of<T>(), f.info.unit,  to_value(Struct{}.*f.member), f.info.min, f.info.max,
                  {},     f.info.doc,   f.info.source};
  if constexpr (ChoiceEnum<T>)
    for (const auto& choice : choices(T{})) spec.choices.push_back(choice.name);
  return spec;
}

}  // namespace detail

/// A struct whose options are declared as data.
template <class S>
concept OptionStruct = std::default_initializable<S> && requires { S::fields(); };

/// All options of `S` with their defaults, in order of declaration.
template <OptionStruct S>
[[nodiscard]] std::vector<OptionSpec> option_specs() {
  return std::apply([](const auto&... f) { return std::vector<OptionSpec>{detail::spec_of(f)...}; }, S::fields());
}

/// The present values of all options, by name.
template <OptionStruct S>
[[nodiscard]] OptionMap option_values(const S& options) {
  OptionMap values;
  std::apply([&](const auto&... f) { (values.emplace(f.name, detail::to_value(options.*f.member)), ...); },
             S::fields());
  return values;
}

/// Sets one option; unknown names, wrong kinds and values out of range are errors that say what would be legal.
template <OptionStruct S>
[[nodiscard]] Result<void> set_option(S& options, std::string_view name, const OptionValue& value) {
  Result<void> result = unknown_option(name, option_specs<S>());
  const auto try_field = [&](const auto& f) {
    if (f.name != name) return;
    const Result<OptionValue> checked = check_option(detail::spec_of(f), value);
    if (checked) detail::from_checked_value(options.*f.member, *checked);
    result = checked ? Result<void>{} : Result<void>{checked.error()};
  };
  std::apply([&](const auto&... f) { (try_field(f), ...); }, S::fields());
  return result;
}

/// `S` with the given values and defaults elsewhere.
template <OptionStruct S>
[[nodiscard]] Result<S> make_options(const OptionMap& values) {
  S options;
  for (const auto& [name, value] : values)
    if (const Result<void> set = set_option(options, name, value); !set) return set.error();
  return options;
}

/// Whether every field lies in its legal range; a host that fills the struct by hand calls this.
template <OptionStruct S>
[[nodiscard]] Result<void> validate(const S& options) {
  S checked;
  for (const auto& [name, value] : option_values(options))
    if (const Result<void> set = set_option(checked, name, value); !set) return set;
  return {};
}

}  // namespace echoarc
