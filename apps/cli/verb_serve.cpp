// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/log_input.hpp"
#include "cli/map_settings.hpp"
#include "cli/option_groups.hpp"
#include "cli/report.hpp"
#include "cli/scene_input.hpp"
#include "cli/session_output.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/io/read_log.hpp"
#include "host/clocks.hpp"
#include "host/interrupt.hpp"
#include "server/map_files.hpp"
#include "server/room_maker.hpp"
#include "server/scratch_folder.hpp"
#include "server/server.hpp"
#include "server/token.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

struct ServeArguments {
  std::string scene;
  LogArguments log;
  fs::path resume;
  SettingArguments settings;
  fs::path output;
  std::string listen = "127.0.0.1";
  int port = 0;  ///< 0: 8765 or the next free one
  std::vector<std::string> hosts;
  std::uint64_t seed = 1;
  double speed = 1.0;
  double duration_s = -1.0;  ///< below 0: until Ctrl-C
  double log_limit_mib = 16384.0;
  double part_mib = 1024.0;
  double upload_mib = 64.0;
  bool is_private = false;
  bool attended = false;
};

InlineExecutor& executor() {
  static InlineExecutor alone;
  return alone;
}

Result<server::MappingChoice> mapping_of(const MapSettings& settings) {
  server::MappingChoice choice;
  for (const std::string& method : settings.methods) {
    const auto options = settings.options.find(method);
    choice.methods.push_back({method, options == settings.options.end() ? OptionMap{} : options->second});
  }
  const Result<SensingOptions> sensing = make_options<SensingOptions>(settings.sensing);
  if (!sensing) return sensing.error();
  choice.sensing = *sensing;
  return choice;
}

fs::path default_session() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("echoarc-session-{:%Y%m%d-%H%M%S}", fmt::localtime(now));
}

/// What the server was started with: the main room, and where its session lies.
struct Start {
  server::RoomSetup room;
  server::MappingChoice mapping;
  fs::path session;  ///< empty: nothing is kept
};

server::SceneRoom scene_room(const ServeArguments& arguments, sim::Scene scene, const std::string& name) {
  return {.scene = std::move(scene),
          .scene_name = name,
          .seed = arguments.seed,
          .speed = arguments.speed,
          .attended = arguments.attended,
          .session = {},
          .limits = {.part_bytes = static_cast<std::uint64_t>(arguments.part_mib * mebibyte),
                     .total_bytes = static_cast<std::uint64_t>(arguments.log_limit_mib * mebibyte)}};
}

Result<Start> start_scene(const ServeArguments& arguments, server::MappingChoice mapping) {
  const std::string name = arguments.scene.empty() ? "demo" : arguments.scene;
  Result<io::SceneFile> file = load_scene(name);
  if (!file) return file.error();
  server::SceneRoom room = scene_room(arguments, std::move(file->scene), name);
  room.session = arguments.output.empty() ? default_session() : arguments.output;
  const fs::path session = room.session;
  Result<server::RoomSetup> setup = server::make_scene_room(room, mapping, executor());
  if (!setup) return setup.error();
  return Start{std::move(*setup), std::move(mapping), session};
}

Result<Start> start_log(const ServeArguments& arguments, server::MappingChoice mapping) {
  Result<Log> log = load_log(arguments.log);
  if (!log) return log.error();
  warn_of(log->report);
  Result<server::RoomSetup> setup =
      server::make_log_room("main", std::move(*log), arguments.speed, mapping, executor());
  if (!setup) return setup.error();
  return Start{std::move(*setup), std::move(mapping), arguments.output};
}

Result<Start> start_resumed(const ServeArguments& arguments) {
  Result<server::SessionStart> before = server::read_session_start(arguments.resume);
  if (!before) return before.error();
  Result<io::SceneFile> file = load_scene(before->scene);
  if (!file) return file.error();
  server::SceneRoom room = scene_room(arguments, std::move(file->scene), before->scene);
  room.session = arguments.resume;
  // Noise goes on otherwise than it began; what was recorded stays as it is.
  room.seed = before->seed + 1;
  room.speed = before->speed;
  Result<server::RoomSetup> setup = server::resume_scene_room(room, before->mapping, executor());
  if (!setup) return setup.error();
  return Start{std::move(*setup), std::move(before->mapping), arguments.resume};
}

Result<server::RoomSetup> open_builtin_scene(const server::MappingChoice& mapping, const std::string& name,
                                             const std::string& room_name) {
  const auto text = io::builtin_scene(name);
  if (!text)
    return Error{ErrorCode::not_found, fmt::format("there is no scene \"{:.40}\" here", name), "",
                 "choose one of the list"};
  Result<io::SceneFile> file = io::read_scene(*text, name);
  if (!file) return file.error();
  const server::SceneRoom room{.name = room_name, .scene = std::move(file->scene), .scene_name = name};
  return server::make_scene_room(room, mapping, executor());
}

/// A log that came over the network, read under a name that did not. `title` is shown and nothing else.
Result<server::RoomSetup> open_received_log(const server::MappingChoice& mapping, const std::string& bytes,
                                            const std::string& title, const std::string& room_name) {
  const server::ScratchFolder folder;
  const fs::path path = folder.path() / "log";
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  file.close();
  if (!file)
    return Error{ErrorCode::unwritable, "there is no room for it among the temporary files", "", "free some space"};
  Result<Log> log = io::read_log(path);
  if (!log) {
    Error error = log.error();
    if (const auto at = error.where.find(path.string()); at != std::string::npos)
      error.where.replace(at, path.string().size(), "log");
    return error;
  }
  log->source = title.empty() ? "received log" : title;
  return server::make_log_room(room_name, std::move(*log), 1.0, mapping, executor());
}

server::RoomOpeners openers_of(const Start& start) {
  return {
      .scene = [mapping = start.mapping](const std::string& scene,
                                         const std::string& room) { return open_builtin_scene(mapping, scene, room); },
      .log = [mapping = start.mapping](
                 const std::string& log, const std::string& title,
                 const std::string& room) { return open_received_log(mapping, log, title, room); },
      .map_file = &server::map_file,
      .run_report = [](const live::Mapper& mapper) { return session_report(mapper); },
      .log_parts =
          [session = start.session] {
            std::vector<std::string> parts;
            if (!session.empty())
              for (const fs::path& part : io::session_parts(session)) parts.push_back(part.string());
            return parts;
          }};
}

server::ServerOptions options_of(const ServeArguments& arguments) {
  server::ServerOptions options;
  options.address = arguments.listen;
  if (arguments.port != 0) options.port = static_cast<std::uint16_t>(arguments.port);
  options.any_port = arguments.port == 0;
  options.is_private = arguments.is_private;
  options.token = server::make_token();
  options.hosts = arguments.hosts;
  options.parameters = json_schema(option_groups()).dump();
  options.facts = {.version = ECHOARC_VERSION,
                   .session = server::make_token().substr(0, 16),
                   .scenes = {},
                   .upload_bytes = static_cast<std::uint64_t>(arguments.upload_mib * mebibyte)};
  for (const io::BuiltinText& text : io::builtin_scenes())
    if (const Result<io::SceneFile> file = io::read_scene(text.text, text.name))
      options.facts.scenes.emplace_back(text.name, file->scene.title);
  return options;
}

bool is_loopback(std::string_view address) {
  return address.starts_with("127.") || address == "::1";
}

void print_start(const ServeArguments& arguments, const Start& start, std::uint16_t port, const std::string& token) {
  const live::SourceDescription& source = start.room.source->description();
  std::vector<std::string> methods;
  for (const live::MethodChoice& choice : start.mapping.methods) methods.push_back(choice.key());
  const std::string host =
      arguments.listen.find(':') != std::string::npos ? "[" + arguments.listen + "]" : arguments.listen;
  const std::string page = fmt::format("http://{}:{}/", host, port);
  fmt::print("{}\n", source.title.empty() ? source.name : source.title);
  fmt::print("  methods  {}\n", fmt::join(methods, ", "));
  if (!start.session.empty() && start.room.log) fmt::print("  session  {}\n", start.session.string());
  fmt::print("  watch    {}\n", arguments.is_private ? "with the link below alone" : page);
  fmt::print("  drive    {}#token={}\n", page, token);
  fmt::print("Ctrl-C {}\n", start.session.empty() ? "ends it." : "saves the maps and ends it.");
  std::fflush(stdout);
  if (!is_loopback(arguments.listen))
    warn("whoever can listen on this network can read the token; put a TLS proxy in front (docs/live.md)");
}

/// The mapper of a room, on its own thread, until `use` returns.
Result<void> with_mapper(server::Room& room, const std::function<Result<void>(live::Mapper&)>& use) {
  std::promise<Result<void>> done;
  room.with_mapper([&](server::MappingLoop::Access& access) { done.set_value(use(access.mapper)); });
  return done.get_future().get();
}

Result<void> serve_until_ended(const ServeArguments& arguments, Start start) {
  server::ServerOptions options = options_of(arguments);
  const std::string token = options.token;
  const host::InterruptGuard guard;
  Result<std::unique_ptr<server::Server>> listening = server::Server::listen(std::move(options), openers_of(start));
  if (!listening) return listening.error();
  print_start(arguments, start, (*listening)->port(), token);
  const fs::path session = start.session;
  const std::shared_ptr<server::Room> room = (*listening)->open_main(std::move(start.room));
  const double begin_s = host::wall_time_s();
  (*listening)->run([&] {
    const bool over = arguments.duration_s >= 0.0 && host::wall_time_s() - begin_s >= arguments.duration_s;
    return over || host::InterruptGuard::interrupted();
  });
  room->end_control();
  if (session.empty()) return {};
  return with_mapper(*room, [&](live::Mapper& mapper) { return write_session_maps(session, mapper); });
}

Result<void> serve(const ServeArguments& arguments, const MapSettings& settings) {
  Result<server::MappingChoice> mapping = mapping_of(settings);
  if (!mapping) return mapping.error();
  Result<Start> start = !arguments.resume.empty()    ? start_resumed(arguments)
                        : !arguments.log.log.empty() ? start_log(arguments, std::move(*mapping))
                                                     : start_scene(arguments, std::move(*mapping));
  if (!start) return start.error();
  if (arguments.duration_s != 0.0) return serve_until_ended(arguments, std::move(*start));
  if (start->session.empty()) return {};
  return write_session_maps(start->session, start->room.mapper);
}

ExitStatus run(const ServeArguments& arguments) {
  const auto settings = resolve_settings(arguments.settings);
  if (const auto* fault = std::get_if<SettingFault>(&settings))
    return fault->command_line ? misuse(fault->error) : fail(fault->error);
  const int sources = int{!arguments.scene.empty()} + int{!arguments.log.log.empty()} + int{!arguments.resume.empty()};
  if (sources > 1)
    return misuse({ErrorCode::bad_value, "--scene, --log and --resume exclude each other", "", "give one of them"});
  const Result<void> served = serve(arguments, std::get<MapSettings>(settings));
  return served ? done : fail(served.error());
}

void declare_network(CLI::App& app, ServeArguments& arguments) {
  app.add_option("--listen", arguments.listen, "address to listen on; 0.0.0.0 is all of this machine's")
      ->type_name("ADDR")
      ->capture_default_str();
  app.add_option("--port", arguments.port, "port to listen on; default 8765, or the next that is free")
      ->check(CLI::Range(0, 65535).description(""))
      ->type_name("N");
  app.add_option("--host", arguments.hosts, "name under which it is reached, behind a proxy say; repeatable")
      ->allow_extra_args(false)
      ->type_name("NAME");
  app.add_flag("--private", arguments.is_private, "watching needs the token, too");
  app.add_flag("--attended", arguments.attended, "the robot stands whenever nobody watches");
  app.add_option("--upload-limit", arguments.upload_mib, "largest log that the page may send, MiB")
      ->check(CLI::Range(0.0, 4096.0).description(""))
      ->type_name("MIB")
      ->capture_default_str();
}

void declare_session(CLI::App& app, ServeArguments& arguments) {
  app.add_option("-o,--output", arguments.output,
                 "folder of the session: its log, and its maps in the end; default ./echoarc-session-DATE-TIME")
      ->type_name("DIR");
  app.add_option("--log-limit", arguments.log_limit_mib, "the session's log stops at so many MiB; the robot does not")
      ->check(CLI::Range(0.001, 1e6).description(""))
      ->type_name("MIB")
      ->capture_default_str();
  app.add_option("--log-part", arguments.part_mib, "a part of the log that is larger is followed by another, MiB")
      ->check(CLI::Range(0.001, 1e6).description(""))
      ->type_name("MIB")
      ->capture_default_str();
  app.add_option("--duration", arguments.duration_s, "end by itself after so many seconds")
      ->check(CLI::Range(0.0, 1e7).description(""))
      ->type_name("S");
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<ServeArguments>();
  app.add_option("--scene", arguments->scene, "a simulated robot in a scene, by name or file; default demo")
      ->type_name("SCENE");
  app.add_option("--log", arguments->log.log, "a log to play")->type_name("LOG");
  declare_log_files(app, arguments->log);
  app.add_option("--resume", arguments->resume, "a session's folder: its maps are made again, and it goes on")
      ->type_name("DIR");
  declare_settings(app, arguments->settings);
  app.add_option("--seed", arguments->seed, "of all that is random in the scene")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--speed", arguments->speed, "so many times faster than real time")
      ->check(CLI::Range(0.1, 100.0).description(""))
      ->type_name("X")
      ->capture_default_str();
  declare_session(app, *arguments);
  declare_network(app, *arguments);
  return [arguments] { return run(*arguments); };
}

Action declare_demo(CLI::App& app) {
  const auto arguments = std::make_shared<ServeArguments>();
  const auto headless = std::make_shared<bool>(false);
  arguments->settings.methods = {"consensus", "evidence", "atm_mod", "centerline"};
  app.add_flag("--headless", *headless, "run for a minute with nobody watching, and save the maps");
  app.add_option("-o,--output", arguments->output, "folder of the session; default ./echoarc-session-DATE-TIME")
      ->type_name("DIR");
  app.add_option("--port", arguments->port, "port to listen on; default 8765, or the next that is free")
      ->check(CLI::Range(0, 65535).description(""))
      ->type_name("N");
  app.add_option("--duration", arguments->duration_s, "end by itself after so many seconds; with --headless 60")
      ->check(CLI::Range(0.0, 1e7).description(""))
      ->type_name("S");
  return [arguments, headless] {
    constexpr double minute_s = 60.0;
    if (*headless && arguments->duration_s < 0.0) arguments->duration_s = minute_s;
    return run(*arguments);
  };
}

}  // namespace

Verb serve_verb() {
  return {"serve",
          "a live page of a robot: watch, drive, ask why",
          {{"echoarc serve -o session --duration 2", "a simulated robot in a room; open the link that is printed"},
           {"echoarc serve --scene hallway --method all -o hall --duration 2", "another scene, and every method"},
           {"echoarc serve --log room.jsonl --speed 4 --duration 2", "a log, played four times as fast"},
           {"echoarc serve --resume session --duration 2",
            "a session that was cut off goes on; without --duration all of "
            "them serve until Ctrl-C"}},
          &declare};
}

Verb demo_verb() {
  return {"demo",
          "the live page, at once: a robot that maps a furnished room",
          {{"echoarc demo -o session --duration 2", "open the link that is printed; without --duration until Ctrl-C"},
           {"echoarc demo --headless --duration 2 -o maps", "with nobody watching; the maps are saved"}},
          &declare_demo};
}

}  // namespace echoarc::cli
