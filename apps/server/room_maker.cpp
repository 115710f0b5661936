// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/room_maker.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "echoarc/live/replay_source.hpp"
#include "echoarc/live/simulated_source.hpp"
#include "host/clocks.hpp"
#include "server/json_values.hpp"

namespace echoarc::server {
namespace {

/// A session's own first record: what is needed to start the same again.
std::string start_record(const SceneRoom& room, const MappingChoice& mapping) {
  Json methods = Json::array();
  for (const live::MethodChoice& choice : mapping.methods) {
    methods.push_back({{"name", choice.name}, {"options", json_of(choice.options)}});
    if (choice.key() != choice.name) methods.back()["id"] = choice.id;
  }
  return text_of({{"type", "setup"},
                  {"scene", room.scene_name},
                  {"seed", room.seed},
                  {"speed", room.speed},
                  {"sensing", json_of(option_values(mapping.sensing))},
                  {"methods", std::move(methods)}});
}

OptionMap options_of(const Json& object) {
  OptionMap options;
  for (const auto& [name, value] : object.items()) {
    if (value.is_boolean()) options.emplace(name, value.get<bool>());
    if (value.is_number_integer()) options.emplace(name, value.get<std::int64_t>());
    if (value.is_number_float()) options.emplace(name, value.get<double>());
    if (value.is_string()) options.emplace(name, value.get<std::string>());
  }
  return options;
}

std::string text_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

OptionMap options_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? options_of(*found) : OptionMap();
}

/// A setup record that changed the maps on the way, applied again. What is none, or cannot be applied, is passed over:
/// it was refused the first time, too, or comes from a newer version.
void apply_setup(const Json& setup, live::Mapper& mapper) {
  if (setup.contains("add")) {
    const std::string id = text_in(setup, "add");
    (void)mapper.add_method({setup.contains("name") ? text_in(setup, "name") : id, options_in(setup, "options"), id});
    return;
  }
  if (setup.contains("remove")) (void)mapper.remove_method(text_in(setup, "remove"));
  if (setup.contains("options")) (void)mapper.set_options(text_in(setup, "method"), options_in(setup, "options"));
  const auto sensor = setup.find("sensor");
  const auto on = setup.find("on");
  if (sensor != setup.end() && sensor->is_number_unsigned() && on != setup.end() && on->is_boolean())
    (void)mapper.use_sensor(sensor->get<SensorId>(), on->get<bool>());
}

std::optional<Json> setup_of(const io::SessionLine& line) {
  const auto* other = std::get_if<io::OtherLine>(&line);
  if (other == nullptr) return std::nullopt;
  Json json = Json::parse(other->json, nullptr, false);
  if (!json.is_object() || text_in(json, "type") != "setup") return std::nullopt;
  return json;
}

Log header_of(const live::SourceDescription& source) {
  Log log;
  log.source = source.name;
  log.frame = source.frame;
  log.temperature_k = source.temperature_k;
  log.robot = source.robot;
  return log;
}

/// Maps, scores and name around a source; no log yet.
Result<RoomSetup> furnish(std::string name, std::string kind, std::unique_ptr<live::Source> source,
                          const MappingChoice& mapping, Executor& executor) {
  Result<live::Mapper> mapper =
      live::Mapper::make(source->description(), mapping.sensing, mapping.methods, executor, &host::thread_cpu_time_s);
  if (!mapper) return mapper.error();
  live::ScoreKeeper scores(source->description());
  return RoomSetup{std::move(name), std::move(kind), std::move(source), std::move(*mapper), std::move(scores)};
}

/// Lets the robot of a scene find its way by itself.
Result<void> add_navigation(RoomSetup& setup, std::optional<Vec2> home) {
  Result<live::Navigator> navigator = live::Navigator::make(setup.source->description());
  if (!navigator) return navigator.error();
  setup.navigation.emplace(Navigation{std::move(*navigator), home});
  return {};
}

Result<void> keep_log(RoomSetup& setup, const SceneRoom& room, const MappingChoice& mapping, bool anew) {
  const Log header = header_of(setup.source->description());
  Result<io::SessionLog> log = anew ? io::SessionLog::create(room.session, header, room.limits)
                                    : io::SessionLog::resume(room.session, header, room.limits);
  if (!log) return log.error();
  setup.log = std::make_unique<SessionWriter>(std::move(*log));
  if (anew) setup.log->add_setup(start_record(room, mapping));
  return {};
}

/// Sensors fire one after the other. Those that listen all the time hear every firing.
std::optional<double> planned_rate_hz(const sim::Scene& scene) {
  const double firings = scene.sonar.listening == sim::Listening::all ? 1.0 : double(scene.robot.sensors.size());
  if (!(firings > 0.0)) return std::nullopt;
  return 1.0 / (scene.sonar.interval_s * firings);
}

/// Where a session ended.
struct Ending {
  double time_s = 0.0;
  std::optional<Vec2> home;  // where it began
  std::optional<Pose2> T_world_true;
  std::optional<Pose2> T_world_odometry;

  void heed(const live::Record& record) {
    if (const auto* truth = std::get_if<live::Truth>(&record)) {
      T_world_true = truth->pose.T_world_robot;
      time_s = std::max(time_s, truth->pose.time_s);
    } else if (const auto* odometry = std::get_if<Odometry>(&record)) {
      T_world_odometry = odometry->T_world_robot;
      if (!home) home = odometry->T_world_robot.position;
    } else if (const auto* ping = std::get_if<Ping>(&record)) {
      time_s = std::max(time_s, ping->time_s);
    }
  }
  /// None when nothing was recorded yet.
  [[nodiscard]] std::optional<live::Continuation> continuation() const {
    constexpr double gap_s = 0.05;
    if (!T_world_true || !T_world_odometry) return std::nullopt;
    return live::Continuation{time_s + gap_s, *T_world_true, *T_world_odometry};
  }
};

}  // namespace

Result<RoomSetup> make_scene_room(const SceneRoom& room, const MappingChoice& mapping, Executor& executor) {
  auto source = live::SimulatedSource::make(room.scene, room.seed);
  if (!source) return source.error();
  Result<RoomSetup> setup = furnish(room.name, "scene", std::move(*source), mapping, executor);
  if (!setup) return setup;
  setup->speed = room.speed;
  setup->planned_rate_hz = planned_rate_hz(room.scene);
  setup->attended = room.attended;
  if (const Result<void> added = add_navigation(*setup, std::nullopt); !added) return added.error();
  if (!room.session.empty())
    if (const Result<void> kept = keep_log(*setup, room, mapping, true); !kept) return kept.error();
  return setup;
}

Result<RoomSetup> make_log_room(const std::string& name, Log log, double speed, const MappingChoice& mapping,
                                Executor& executor) {
  auto source = live::ReplaySource::make(std::move(log));
  if (!source) return source.error();
  Result<RoomSetup> setup = furnish(name, "log", std::move(*source), mapping, executor);
  if (setup) setup->speed = speed;
  return setup;
}

Result<SessionStart> read_session_start(const std::filesystem::path& session) {
  std::optional<SessionStart> start;
  std::optional<Error> fault;
  const Result<Log> read = io::read_session(session, [&](const io::SessionLine& line) {
    if (start) return;
    const std::optional<Json> setup = setup_of(line);
    if (!setup || !setup->contains("scene")) return;
    start.emplace();
    start->scene = text_in(*setup, "scene");
    if (const auto seed = setup->find("seed"); seed != setup->end() && seed->is_number_unsigned())
      start->seed = seed->get<std::uint64_t>();
    if (const auto speed = setup->find("speed"); speed != setup->end() && speed->is_number())
      start->speed = speed->get<double>();
    if (auto sensing = make_options<SensingOptions>(options_in(*setup, "sensing")))
      start->mapping.sensing = *sensing;
    else
      fault = sensing.error();
    if (const auto methods = setup->find("methods"); methods != setup->end() && methods->is_array())
      for (const Json& method : *methods)
        if (method.is_object())
          start->mapping.methods.push_back(
              {text_in(method, "name"), options_in(method, "options"), text_in(method, "id")});
  });
  if (!read) return read.error();
  if (fault) return *fault;
  if (!start)
    return Error{ErrorCode::bad_format, "it does not say what it was started with", session.string(),
                 "map it instead: echoarc map " + session.string() + "/session.jsonl"};
  return *start;
}

Result<RoomSetup> resume_scene_room(const SceneRoom& room, const MappingChoice& mapping, Executor& executor) {
  // The robot's description is needed before its records; the source itself starts where they end.
  auto first = live::SimulatedSource::make(room.scene, room.seed);
  if (!first) return first.error();
  Result<RoomSetup> setup = furnish(room.name, "scene", std::move(*first), mapping, executor);
  if (!setup) return setup;
  Ending ending;
  const Result<Log> read = io::read_session(room.session, [&](const io::SessionLine& line) {
    if (const std::optional<Json> change = setup_of(line)) return apply_setup(*change, setup->mapper);
    const std::optional<live::Record> record = record_of(line);
    if (!record) return;
    ending.heed(*record);
    setup->mapper.push(*record);
    setup->scores.push(*record);
  });
  if (!read) return read.error();
  if (!(read->robot == room.scene.robot))
    return Error{ErrorCode::bad_format, "the session was recorded by another robot than the scene's",
                 room.session.string(), "resume it with the scene it was started with"};
  while (setup->mapper.work(10'000)) {
  }
  auto source = live::SimulatedSource::make(room.scene, room.seed, {}, ending.continuation());
  if (!source) return source.error();
  setup->source = std::move(*source);
  setup->speed = room.speed;
  setup->planned_rate_hz = planned_rate_hz(room.scene);
  setup->attended = room.attended;
  setup->starts_tour = false;  // whoever resumes it may not be where the robot is
  if (const Result<void> added = add_navigation(*setup, ending.home); !added) return added.error();
  if (const Result<void> kept = keep_log(*setup, room, mapping, false); !kept) return kept.error();
  return setup;
}

}  // namespace echoarc::server
