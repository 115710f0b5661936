// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/option_json.hpp"

#include <cmath>
#include <string>

#include "echoarc/io/config.hpp"

namespace echoarc::io {
namespace {

using Json = nlohmann::ordered_json;

std::string_view schema_type(OptionKind kind) {
  switch (kind) {
    case OptionKind::boolean: return "boolean";
    case OptionKind::integer: return "integer";
    case OptionKind::real: return "number";
    case OptionKind::choice: return "string";
  }
  return "string";
}

/// A bound as it is declared: whole numbers of integer options without a decimal point.
Json bound(const OptionSpec& spec, double value) {
  return spec.kind == OptionKind::integer ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json property_schema(const OptionSpec& spec) {
  Json schema = {{"type", schema_type(spec.kind)}, {"default", to_json(spec.default_value)}};
  const bool numeric = spec.kind == OptionKind::integer || spec.kind == OptionKind::real;
  if (numeric && std::isfinite(spec.min)) schema["minimum"] = bound(spec, spec.min);
  if (numeric && std::isfinite(spec.max)) schema["maximum"] = bound(spec, spec.max);
  if (!spec.choices.empty()) schema["enum"] = spec.choices;
  schema["description"] = spec.doc;
  // "unit" and "source" are annotations of our own; a validator ignores them, a form shows them.
  if (!spec.unit.empty()) schema["unit"] = spec.unit;
  if (!spec.source.empty()) schema["source"] = spec.source;
  return schema;
}

}  // namespace

Json option_properties(std::span<const OptionSpec> specs) {
  Json properties = Json::object();
  for (const OptionSpec& spec : specs) properties[std::string(spec.name)] = property_schema(spec);
  return properties;
}

std::string options_json(const OptionMap& values) {
  return to_json(values).dump();
}

std::string option_schema(std::string_view title, std::span<const OptionSpec> specs) {
  const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                       {"title", title},
                       {"type", "object"},
                       {"additionalProperties", false},
                       {"properties", option_properties(specs)}};
  return schema.dump(2) + "\n";
}

}  // namespace echoarc::io
