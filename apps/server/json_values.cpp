// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/json_values.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "echoarc/core/outcome.hpp"

namespace echoarc::server {
namespace {

/// How the page calls a method, and what shows when it is laid beside others.
struct Wording {
  std::string_view method;
  std::string_view short_name;
  std::string_view look;
};

constexpr std::array<Wording, 18> wordings{{
    {"centerline", "Centerline", "puts every echo on the beam axis, which narrows doors and frays corners."},
    {"vt", "Voting", "keeps what many arcs pass through; single views leave nothing."},
    {"dm", "Directional maximum", "keeps the fullest cell on every line across the wall."},
    {"bu", "Bayesian update", "spreads every echo over its cone; an outlier stays for long."},
    {"evidence", "Occupancy grid", "smears along arcs until several views agree."},
    {"mp", "Morphological", "prunes arcs until dense cells alone are left."},
    {"himm", "In-motion grid", "counts on the beam axis alone; fast, and as narrow as centerline."},
    {"numakura", "Numakura", "compare the four outlier tests around glass and corners."},
    {"limited", "Laser-limited", "cuts every cone where a laser saw something nearer."},
    {"carved_grid", "Carved grid", "draws what carving left of the arcs into cells."},
    {"tbf", "Triangulation", "keeps what several arcs agree on within a window: edges above all."},
    {"atm_org", "Arc median (1999)", "any two crossing arcs make a point, grazing ones too."},
    {"atm_mod", "Arc median",
     "needs steep crossings, and then lands on the wall; where the robot only drove straight it has "
     "few points."},
    {"atm_silver", "Arc median (2004)", "steep crossings over the newest arcs alone."},
    {"carve", "Arc carving", "drops what later pings prove empty; bounds shrink as it drives."},
    {"combined", "Median and carving", "carves first, then takes the median of what is left."},
    {"consensus", "Tangent consensus", "asks neighbouring arcs which wall both touch; few points lie off a wall."},
    {"consensus_evidence", "Consensus grid", "draws every echo where its neighbours place it; walls are thin."},
}};

const Wording* wording_of(std::string_view method) {
  const auto* found = std::ranges::find(wordings, method, &Wording::method);
  return found == wordings.end() ? nullptr : found;
}

}  // namespace

Json json_of(const live::JudgedPing& ping) {
  const Reading& reading = ping.reading;
  const std::optional<double> heard_m = echo_range_m(reading.outcome);
  return {{"ping", reading.ping},
          {"t", json_of(reading.time_s)},
          {"tx", reading.tx},
          {"rx", reading.rx},
          {"range_m", ping.rejected ? json_of(ping.raw_range_m) : json_of(heard_m)},
          {"outcome", ping.rejected ? "rejected" : std::string(name(reading.outcome))},
          {"reason", ping.rejected ? Json(std::string(name(*ping.rejected))) : Json()},
          {"T_world_tx", json_of(reading.T_world_tx)},
          {"T_world_rx", json_of(reading.T_world_rx)},
          {"T_world_robot", json_of(reading.T_world_robot)},
          {"beam_width", json_of(reading.beam_width.rad())},
          {"trusted_range_m", json_of(reading.trusted_range_m)}};
}

Json json_of(const OptionMap& options) {
  Json json = Json::object();
  for (const auto& [name, value] : options) std::visit([&](const auto& v) { json[name] = v; }, value);
  return json;
}

Json json_of(const OptionSpec& option) {
  constexpr std::array<std::string_view, 4> kinds{"boolean", "integer", "real", "choice"};
  Json json{{"name", option.name}, {"kind", kinds.at(static_cast<std::size_t>(option.kind))}, {"unit", option.unit}};
  std::visit([&](const auto& value) { json["default"] = value; }, option.default_value);
  json["min"] = json_of(option.min);
  json["max"] = json_of(option.max);
  json["choices"] = Json::array();
  for (const std::string_view choice : option.choices) json["choices"].push_back(choice);
  json["doc"] = option.doc;
  json["source"] = option.source;
  return json;
}

Json json_of(const MethodEntry& method) {
  const Wording* wording = wording_of(method.name);
  const std::string_view short_name = wording != nullptr ? wording->short_name : method.title;
  const std::string_view look = wording != nullptr ? wording->look : method.summary;
  Json options = Json::array();
  for (const OptionSpec& option : method.specs()) options.push_back(json_of(option));
  return {
      {"name", method.name},     {"title", method.title},         {"short", short_name}, {"summary", method.summary},
      {"source", method.source}, {"options", std::move(options)}, {"look", look}};
}

std::string label_of(const live::MethodChoice& choice) {
  const Wording* wording = wording_of(choice.name);
  std::string name(wording != nullptr ? wording->short_name : choice.name);
  const std::string& id = choice.key();
  if (id == choice.name) return name;
  const bool own = id.starts_with(choice.name) && id.size() > choice.name.size() + 1;
  std::string rest = own ? id.substr(choice.name.size() + 1) : id;
  std::ranges::replace_if(rest, [](char c) { return c == '-' || c == '_'; }, ' ');
  return name + (own ? " " : ": ") + rest;
}

}  // namespace echoarc::server
