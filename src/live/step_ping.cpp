// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "echoarc/core/arc_carving.hpp"
#include "echoarc/live/cell_layer.hpp"
#include "echoarc/mapping/consensus_explanation.hpp"
#include "live/arc_partners.hpp"
#include "live/formulas.hpp"
#include "live/replay.hpp"

namespace echoarc::live {
namespace {

bool crosses(std::string_view method) {
  return method.starts_with("atm") || method == "combined";
}
bool carves(std::string_view method) {
  return method == "carve" || method == "combined" || method == "carved_grid";
}

void touch_crossed(const ArcState& older, const JudgedPing& ping, const CrossableArc& arc, Angle theta_t, Step& step) {
  for (const ArcCrossing& crossing : crossings(arc, CrossableArc(older.arc)))
    if (crossing.angle >= theta_t)
      step.arcs.push_back(
          {ping, TouchedArc::What::crossed, crossing.position, std::nullopt, "at " + degrees_text(crossing.angle)});
}

void touch_carved(const ArcState& older, const JudgedPing& ping, const FreeSector& sector, Step& step) {
  if (older.removed) return;
  const Carving carving = carve(older.arc, sector);
  if (carving.outcome == CarveOutcome::unchanged) return;
  TouchedArc touched{ping, TouchedArc::What::removed, std::nullopt, std::nullopt, ""};
  if (carving.outcome == CarveOutcome::carved) {
    touched.what = TouchedArc::What::cut;
    touched.left = older.arc;
    touched.left->set_limits(carving.t_begin, carving.t_end);
    const Angle had = older.arc.t_end() - older.arc.t_begin();
    touched.note = "cut " + degrees_text(had - (carving.t_end - carving.t_begin));
  } else {
    touched.note =
        carving.outcome == CarveOutcome::removed_full ? "nothing is left of it" : "more than one piece is left";
  }
  step.arcs.push_back(std::move(touched));
}

/// The arcs of the history before the ping that it crosses or cuts.
void touch_arcs(const Evidence& evidence, const AnyMethod& method, const std::string& name, const Reading& reading,
                Step& step) {
  if (!step.arc || !method.keeps_arcs()) return;
  const OptionMap options = method.options();
  const bool too_far = echo_range_m(reading.outcome).value_or(0.0) > number_option(options, "max_range_m", 1e9);
  if (carves(name) && too_far) return;
  const Angle theta_t = compared_arcs(name, options).theta_t;
  const CrossableArc arc(*step.arc);
  const FreeSector sector(*step.arc, number_option(options, "guard_m", 0.0));
  method.visit_arcs([&](const ArcState& older) {
    const auto place = evidence.readings.find(older.source.ping);
    if (!place) return;
    if (crosses(name)) touch_crossed(older, evidence.readings[*place], arc, theta_t, step);
    if (carves(name)) touch_carved(older, evidence.readings[*place], sector, step);
  });
}

std::string why_unused(const Evidence& evidence, const JudgedPing& ping) {
  if (ping.rejected) return std::string(info(*ping.rejected).explanation);
  const bool off = evidence.sensors_off.contains(ping.reading.rx) || evidence.sensors_off.contains(ping.reading.tx);
  return off ? "its sensor is turned off" : "";
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// What the first sweep, of those before it alone, makes of the echo.
std::string consensus_summary(const Evidence& evidence, const OptionMap& all, std::size_t place) {
  auto options = make_options<ConsensusOptions>(all);
  if (!options) return "";
  const auto window = 2 * std::size_t(std::max(1.0, number_option(all, "history", 500.0)));
  const std::vector<Reading> readings = used_readings(evidence, place > window ? place - window : 0, place + 1);
  InlineExecutor executor;
  const auto echo = explain_echo(readings, *options, evidence.readings[place].reading.ping, executor);
  if (!echo) return echo.error().message;
  if (echo->sweeps.empty()) return "No neighbour says anything about its bearings yet.";
  char text[200];
  std::snprintf(
      text, sizeof text,
      "By the %zu neighbours before it the echo came from %s off the axis, %.0f %% sure; a wall with %.0f %%.",
      echo->voices.size(), degrees_text(echo->t).c_str(), 100.0 * echo->p, 100.0 * echo->sweeps.front().wall_share);
  return text;
}

std::string summary_of(const Evidence& evidence, const Step& step, const std::string& name, const OptionMap& options,
                       std::size_t place) {
  if (name == "consensus") return consensus_summary(evidence, options, place);
  if (!step.cells.empty()) return "It changes " + counted(step.cells.size(), "cell.", "cells.");
  std::string text;
  const auto count = [&](TouchedArc::What what) {
    return std::size_t(std::ranges::count(step.arcs, what, &TouchedArc::what));
  };
  if (crosses(name)) text = "Its arc crosses others " + counted(count(TouchedArc::What::crossed), "time. ", "times. ");
  if (carves(name))
    text += "It cuts " + counted(count(TouchedArc::What::cut), "arc", "arcs") + " and removes " +
            std::to_string(count(TouchedArc::What::removed)) + ". ";
  return text +
         (step.points.empty() ? "It adds no point." : "It adds " + counted(step.points.size(), "point.", "points."));
}

}  // namespace

Result<Step> step_ping(const Evidence& evidence, std::string_view id, PingId ping) {
  const auto chosen = place_of(evidence, id);
  if (!chosen) return chosen.error();
  const auto place = evidence.readings.find(ping);
  if (!place)
    return Error{ErrorCode::not_found, "ping " + std::to_string(ping) + " is not in the log", "ping",
                 "ask for a smaller id"};
  const MethodChoice& choice = evidence.methods[*chosen];
  auto method = replay(evidence, choice, *place);
  if (!method) return method.error();
  auto before = method->export_map();
  if (!before) return before.error();
  Step step;
  step.method = choice.key();
  step.ping = evidence.readings[*place];
  step.T_world_true = evidence.truth.at(step.ping.reading.time_s);
  step.before = std::make_shared<const MapExport>(std::move(*before));
  const CellLayer layer = cell_layer_of(choice.name, choice.options);
  step.unit = layer.unit;
  if (!is_point_method(choice.name) && layer.geometry) step.cell_m = layer.geometry->cell_m;
  step.reason = why_unused(evidence, step.ping);
  if (!step.reason.empty()) return step;
  const Reading& reading = step.ping.reading;
  Trace trace = method->trace(reading);
  step.arc = trace.arc;
  step.points = std::move(trace.points);
  step.cells = std::move(trace.cells);
  const OptionMap options = method->options();
  step.formulas = formulas_of(choice.name, options, reading, step.cells);
  touch_arcs(evidence, *method, choice.name, reading, step);
  step.used = step.arc || !step.cells.empty();
  if (!step.used) step.reason = "silence says nothing to this method";
  step.summary = step.used ? summary_of(evidence, step, choice.name, options, *place) : "";
  return step;
}

}  // namespace echoarc::live
