// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/option_groups.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

struct MethodsArguments {
  std::string name;
  bool json = false;
  bool schema = false;
};

void print_list(std::span<const OptionGroup> groups) {
  Table table({"name", "method", "source"});
  table.words({1, 2});
  for (const OptionGroup& group : groups)
    table.add({std::string(group.name), std::string(group.title), std::string(group.source)});
  fmt::print("{}\n`echoarc methods NAME` lists the options of one; set them with `map --set NAME.OPTION=VALUE`.\n",
             table.text(""));
}

void print_group(const OptionGroup& group) {
  fmt::print("{}: {}\n{}\n", group.name, group.title, group.summary);
  if (!group.source.empty()) fmt::print("Source: {}\n", group.source);
  for (const OptionSpec& spec : group.specs) {
    fmt::print("\n  {}.{} = {}{}{}\n", group.name, spec.name, to_text(spec.default_value), spec.unit.empty() ? "" : " ",
               spec.unit);
    fmt::print("      {}\n      legal: {}\n", spec.doc, legal_values(spec));
    if (!spec.source.empty()) fmt::print("      source: {}\n", spec.source);
  }
}

Error unknown_group(const std::string& name, std::span<const OptionGroup> groups) {
  std::vector<std::string_view> names;
  for (const OptionGroup& group : groups) names.push_back(group.name);
  return {ErrorCode::bad_value, fmt::format("there is no method {}", name), "",
          fmt::format("use one of {}", fmt::join(names, ", "))};
}

ExitStatus run(const MethodsArguments& arguments) {
  std::vector<OptionGroup> groups = option_groups();
  if (!arguments.name.empty()) {
    const auto chosen = std::ranges::find(groups, std::string_view(arguments.name), &OptionGroup::name);
    if (chosen == groups.end()) return misuse(unknown_group(arguments.name, groups));
    groups = {*chosen};
  }
  if (arguments.schema) {
    fmt::print("{}\n", json_schema(groups).dump(2));
  } else if (arguments.json) {
    Json all = Json::array();
    for (const OptionGroup& group : groups) all.push_back(group_json(group));
    fmt::print("{}\n", (arguments.name.empty() ? all : all.front()).dump(2));
  } else if (arguments.name.empty()) {
    print_list(groups);
  } else {
    print_group(groups.front());
  }
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<MethodsArguments>();
  app.add_option("NAME", arguments->name, "a method, or `sensing`: list its options")->type_name("");
  CLI::Option* json = app.add_flag("--json", arguments->json, "print JSON");
  app.add_flag("--schema", arguments->schema, "print a JSON Schema of the options")->excludes(json);
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb methods_verb() {
  return {"methods",
          "the catalogue of methods and their options",
          {{"echoarc methods", "all methods"},
           {"echoarc methods dm", "the options of one: unit, default, legal range, source"},
           {"echoarc methods evidence --json", "the same for programs"},
           {"echoarc methods --schema", "JSON Schema of every option"}},
          &declare};
}

}  // namespace echoarc::cli
