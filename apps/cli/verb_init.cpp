// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/core/sensor_array.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/robot_toml.hpp"

namespace echoarc::cli {
namespace {

struct InitArguments {
  std::string preset = "hc-sr04";
  int count = 8;
  std::string layout = "ring";
  std::filesystem::path output;
  bool force = false;
  bool list = false;
};

void print_presets() {
  Table table({"preset", "beam", "range", "transducer"});
  table.words({3});
  for (const SensorPreset& preset : sensor_presets())
    table.add({std::string(preset.name), fmt::format("{:.0f} deg", preset.beam_width.deg()),
               fmt::format("{:.2f} to {:.1f} m", preset.range_min_m, preset.range_max_m),
               std::string(preset.description)});
  fmt::print("{}", table.text(""));
}

/// Replaces an existing file, perhaps edited by hand, only by force.
Result<void> write_file(const std::filesystem::path& path, const std::string& text, bool force) {
  if (!force && std::filesystem::exists(path))
    return Error{ErrorCode::unwritable, "the file exists already", path.string(),
                 "give another name with -o, or replace it with --force"};
  Result<std::unique_ptr<io::FileSink>> file = io::FileSink::create(path);
  if (!file) return file.error();
  if (Result<void> written = (*file)->write(text); !written) return written;
  return (*file)->commit();
}

ExitStatus run(const InitArguments& arguments) {
  if (arguments.list) {
    print_presets();
    return done;
  }
  const auto layout = arguments.layout == "row" ? io::SensorLayout::row : io::SensorLayout::ring;
  const Result<std::string> text = io::robot_toml_template(arguments.preset, arguments.count, layout);
  if (!text) return misuse(text.error());
  if (arguments.output.empty()) {
    fmt::print("{}", *text);
    return done;
  }
  if (const Result<void> written = write_file(arguments.output, *text, arguments.force); !written)
    return fail(written.error());
  fmt::print("wrote {}: measure the mounts on your robot and correct them, then\n  echoarc doctor {}\n",
             arguments.output.string(), arguments.output.string());
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<InitArguments>();
  app.add_option("--preset", arguments->preset, "transducer; --list shows all")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--count", arguments->count, "number of sensors")->type_name("N")->capture_default_str();
  app.add_option("--layout", arguments->layout, "ring: around the robot; row: side by side, looking forward")
      ->type_name("ring|row")
      ->check(CLI::IsMember({"ring", "row"}).description(""))
      ->capture_default_str();
  app.add_option("-o,--output", arguments->output, "file to write; without it the text is printed")->type_name("FILE");
  app.add_flag("--force", arguments->force, "replace the file if it exists");
  app.add_flag("--list", arguments->list, "list the presets");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb init_verb() {
  return {"init",
          "a commented robot.toml to start from",
          {{"echoarc init --preset hc-sr04 --count 5 --layout row -o robot.toml", "write it to a file"},
           {"echoarc init --preset polaroid-6500 --count 16", "print a ring of 16"},
           {"echoarc init --list", "the transducers it knows"}},
          &declare};
}

}  // namespace echoarc::cli
