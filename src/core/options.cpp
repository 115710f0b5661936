// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/options.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>

namespace echoarc {
namespace {

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Error illegal(const OptionSpec& spec, std::string_view given) {
  return {ErrorCode::bad_value, std::string(spec.name) + " = " + std::string(given) + " is not legal",
          std::string(spec.name), "use " + legal_values(spec) + " (default " + to_text(spec.default_value) + ")"};
}

std::optional<double> as_real(const OptionValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::nullopt;
}

bool in_range(const OptionSpec& spec, double value) {
  return value >= spec.min && value <= spec.max;
}

/// Levenshtein distance, for "did you mean".
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] != b[j] ? 1 : 0);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string joined(std::span<const std::string_view> names, std::string_view last_separator) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last_separator : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace

Result<OptionValue> parse_option(const OptionSpec& spec, std::string_view text) {
  switch (spec.kind) {
    case OptionKind::boolean:
      if (text == "true" || text == "1" || text == "yes" || text == "on") return OptionValue{true};
      if (text == "false" || text == "0" || text == "no" || text == "off") return OptionValue{false};
      return illegal(spec, text);
    case OptionKind::integer:
      if (const auto value = parse_number<std::int64_t>(text)) return check_option(spec, *value);
      return illegal(spec, text);
    case OptionKind::real:
      if (const auto value = parse_number<double>(text)) return check_option(spec, *value);
      return illegal(spec, text);
    case OptionKind::choice: return check_option(spec, std::string(text));
  }
  return illegal(spec, text);
}

Result<OptionValue> check_option(const OptionSpec& spec, const OptionValue& value) {
  switch (spec.kind) {
    case OptionKind::boolean:
      if (std::holds_alternative<bool>(value)) return value;
      break;
    case OptionKind::integer: {
      const auto real = as_real(value);
      if (real && in_range(spec, *real) && std::trunc(*real) == *real)
        return OptionValue{static_cast<std::int64_t>(*real)};
      break;
    }
    case OptionKind::real: {
      const auto real = as_real(value);
      if (real && std::isfinite(*real) && in_range(spec, *real)) return OptionValue{*real};
      break;
    }
    case OptionKind::choice:
      if (const auto* name = std::get_if<std::string>(&value))
        if (std::ranges::find(spec.choices, *name) != spec.choices.end()) return value;
      break;
  }
  return illegal(spec, to_text(value));
}

std::string to_text(const OptionValue& value) {
  struct Visitor {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return number_text(v); }
    std::string operator()(const std::string& v) const { return v; }
  };
  return std::visit(Visitor{}, value);
}

std::string legal_values(const OptionSpec& spec) {
  if (spec.kind == OptionKind::boolean) return "true or false";
  if (spec.kind == OptionKind::choice) return joined(spec.choices, " or ");
  const std::string unit = spec.unit.empty() ? "" : " " + std::string(spec.unit);
  const bool bounded_below = std::isfinite(spec.min);
  const bool bounded_above = std::isfinite(spec.max);
  if (bounded_below && bounded_above) return number_text(spec.min) + " to " + number_text(spec.max) + unit;
  if (bounded_below) return "at least " + number_text(spec.min) + unit;
  if (bounded_above) return "at most " + number_text(spec.max) + unit;
  return spec.kind == OptionKind::integer ? "any whole number" + unit : "any number" + unit;
}

Error unknown_option(std::string_view name, std::span<const OptionSpec> specs) {
  std::vector<std::string_view> names;
  for (const OptionSpec& spec : specs) names.push_back(spec.name);
  const auto nearest =
      std::ranges::min_element(names, {}, [&](std::string_view candidate) { return edit_distance(candidate, name); });
  std::string remedy = "it has no options";
  if (nearest != names.end() && edit_distance(*nearest, name) <= 2)
    remedy = "did you mean " + std::string(*nearest) + "?";
  else if (!names.empty())
    remedy = "use one of " + joined(names, " or ");
  return {ErrorCode::bad_value, "there is no option " + std::string(name), std::string(name), remedy};
}

}  // namespace echoarc
