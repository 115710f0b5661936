// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/log_input.hpp"
#include "cli/map_settings.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/mapping/consensus_explanation.hpp"
#include "echoarc/pipeline/pipeline.hpp"
#include "host/thread_pool.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainArguments {
  LogArguments input;
  SettingArguments settings{.methods = {"consensus"}, .settings = {}, .features = {}, .config = {}};
  PingId ping = 0;
  bool json = false;
};

Json json_of(Vec2 v) {
  return Json{v.x, v.y};
}

Json json_of(const SweepBelief& sweep) {
  return {{"wall", sweep.wall}, {"point", sweep.point}, {"wall_share", sweep.wall_share}, {"evidence", sweep.evidence}};
}

/// The numbers, as docs/formats.md names them.
void print_json(PingId ping, const EchoExplanation& explained) {
  Json bearings = Json::array();
  for (const Angle bearing : explained.bearings) bearings.push_back(bearing.deg());
  Json sweeps = Json::array();
  for (const SweepBelief& sweep : explained.sweeps) sweeps.push_back(json_of(sweep));
  Json voices = Json::array();
  for (const NeighbourVoice& voice : explained.voices)
    voices.push_back({{"ping", voice.ping},
                      {"wall", voice.wall},
                      {"wall_free", voice.wall_free},
                      {"point", voice.point},
                      {"point_free", voice.point_free}});
  const Json json{{"ping", ping},
                  {"transmitter", json_of(explained.arc.transmitter())},
                  {"receiver", json_of(explained.arc.receiver())},
                  {"range_m", explained.arc.range_m()},
                  {"axis_deg", explained.arc.axis().deg()},
                  {"bearings_deg", std::move(bearings)},
                  {"prior", explained.prior},
                  {"sweeps", std::move(sweeps)},
                  {"neighbour_weight", explained.neighbour_weight},
                  {"neighbours", std::move(voices)},
                  {"bearing_deg", explained.t.deg()},
                  {"position", json_of(explained.position)},
                  {"p", explained.p},
                  {"bound_m", explained.bound_m}};
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_beliefs(const EchoExplanation& explained) {
  std::vector<std::string> head{"bearing", "beam"};
  for (std::size_t k = 1; k <= explained.sweeps.size(); ++k) {
    head.push_back(fmt::format("wall {}", k));
    head.push_back(fmt::format("point {}", k));
  }
  Table table(head);
  for (std::size_t m = 0; m < explained.bearings.size(); ++m) {
    std::vector<std::string> row{fmt::format("{:+.1f} deg", explained.bearings[m].deg()),
                                 fmt::format("{:.3f}", explained.prior[m])};
    for (const SweepBelief& sweep : explained.sweeps) {
      row.push_back(fmt::format("{:.3f}", sweep.wall_share * sweep.wall[m]));
      row.push_back(fmt::format("{:.3f}", (1.0 - sweep.wall_share) * sweep.point[m]));
    }
    table.add(std::move(row));
  }
  fmt::print("What each sweep believes, walls and points sum to 1:\n\n{}\n", table.text());
}

/// The neighbours that say most, for or against.
void print_voices(const EchoExplanation& explained) {
  constexpr std::size_t most = 8;
  const auto loudness = [](const NeighbourVoice& v) {
    return std::pair(std::max({v.wall, v.point, -v.wall_free, -v.point_free}), v.ping);  // of equals the newer first
  };
  std::vector<NeighbourVoice> voices = explained.voices;
  std::ranges::sort(voices, std::greater{}, loudness);
  voices.resize(std::min(most, voices.size()));
  Table table({"neighbour", "for a wall", "against", "for a point", "against"});
  for (const NeighbourVoice& v : voices)
    table.add({fmt::format("ping {}", v.ping), fmt::format("{:.2f}", v.wall), fmt::format("{:.2f}", v.wall_free),
               fmt::format("{:.2f}", v.point), fmt::format("{:.2f}", v.point_free)});
  fmt::print("{} with a say, each stands for {:.1f}", counted(explained.voices.size(), "neighbour"),
             explained.neighbour_weight);
  fmt::print("{}\n\n{}\n",
             table.empty() ? "." : "; those that say most (logarithms):", table.empty() ? "" : table.text());
}

void print_text(PingId ping, const EchoExplanation& explained) {
  const SweepBelief& last = explained.sweeps.back();
  fmt::print("ping {}: an echo at {:.3f} m, sensor at ({:.3f}, {:.3f}) looking along {:+.1f} deg\n\n", ping,
             explained.arc.range_m(), explained.arc.receiver().x, explained.arc.receiver().y,
             explained.arc.axis().deg());
  print_beliefs(explained);
  print_voices(explained);
  fmt::print("read out: {:+.1f} deg off the axis, at ({:.3f}, {:.3f}), p {:.2f}, 90 % bound {:.2f} m\n",
             explained.t.deg(), explained.position.x, explained.position.y, explained.p, explained.bound_m);
  fmt::print("a wall with {:.2f}, a point with {:.2f}; evidence {:.1f}\n", last.wall_share, 1.0 - last.wall_share,
             last.evidence);
}

Result<ExitStatus> explain(const ExplainArguments& arguments, const MapSettings& settings) {
  const Result<SensingOptions> sensing = make_options<SensingOptions>(settings.sensing);
  if (!sensing) return sensing.error();
  const auto given = settings.options.find("consensus");
  const Result<ConsensusOptions> options =
      make_options<ConsensusOptions>(given == settings.options.end() ? OptionMap{} : given->second);
  if (!options) return options.error();
  const Result<Log> log = load_log(arguments.input);
  if (!log) return log.error();
  warn_of(log->report);
  host::ThreadPool pool(host::hardware_threads());
  const auto explained = explain_echo(sense(*log, *sensing).readings, *options, arguments.ping, pool);
  if (!explained) return explained.error();
  if (arguments.json) {
    print_json(arguments.ping, *explained);
  } else {
    print_text(arguments.ping, *explained);
  }
  return done;
}

ExitStatus run(const ExplainArguments& arguments) {
  const auto settings = resolve_settings(arguments.settings);
  if (const auto* fault = std::get_if<SettingFault>(&settings))
    return fault->command_line ? misuse(fault->error) : fail(fault->error);
  const Result<ExitStatus> status = explain(arguments, std::get<MapSettings>(settings));
  return status ? *status : fail(status.error());
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<ExplainArguments>();
  declare_log(app, arguments->input);
  app.add_option("--ping", arguments->ping, "which ping, counted from 0; points.csv names those behind every point")
      ->required()
      ->type_name("N");
  declare_values(app, arguments->settings);
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb explain_verb() {
  return {"explain",
          "why tangent consensus places an echo where it does",
          {{"echoarc explain room.jsonl --ping 500", "what every sweep believes of its bearings, and who said so"},
           {"echoarc explain room.jsonl --ping 500 --set sweeps=4", "with an option"},
           {"echoarc explain room.jsonl --ping 500 --json", "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
