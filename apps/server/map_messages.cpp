// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/map_messages.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "echoarc/core/speed_of_sound.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/rejection.hpp"
#include "server/json_values.hpp"

namespace echoarc::server {
namespace {

Json grid_of(const live::MapStore& store) {
  if (!store.geometry()) return {};
  const GridGeometry& grid = *store.geometry();
  return {{"cell_m", grid.cell_m}, {"x_m", grid.origin.x}, {"y_m", grid.origin.y}};
}

Json counts_of(const RejectionCounters& counters) {
  Json counts = Json::object();
  for (const RejectionInfo& reason : rejections())
    if (counters[reason.reason].count > 0) counts[std::string(reason.name)] = counters[reason.reason].count;
  return counts;
}

/// Of one sensor: rejected ones of the last minute, and pings a second over the last ten.
struct Recent {
  std::uint64_t rejected = 0;
  double rate_hz = 0.0;
};

std::map<SensorId, Recent> recent_of(const live::ReadingLog& readings) {
  constexpr double minute_s = 60.0;
  constexpr double rate_window_s = 10.0;
  std::map<SensorId, Recent> recent;
  if (readings.size() == 0) return recent;
  const double now_s = readings[readings.size() - 1].reading.time_s;
  const double window_s = std::clamp(now_s - readings[0].reading.time_s, 1.0, rate_window_s);
  for (std::size_t i = readings.size(); i-- > 0;) {
    const live::JudgedPing& ping = readings[i];
    const double age_s = now_s - ping.reading.time_s;
    if (age_s > minute_s) break;
    Recent& of_sensor = recent[ping.reading.rx];
    if (ping.rejected) ++of_sensor.rejected;
    if (age_s < window_s) of_sensor.rate_hz += 1.0 / window_s;
  }
  return recent;
}

Json sensors_of(const live::Mapper& mapper) {
  std::map<SensorId, Recent> recent = recent_of(mapper.readings());
  Json sensors = Json::array();
  for (const SensorTally& tally : mapper.report().sensors) {
    Json rejected = Json::object();
    for (const RejectionInfo& reason : rejections())
      if (const auto count = tally.rejected.at(static_cast<std::size_t>(reason.reason)); count > 0)
        rejected[std::string(reason.name)] = count;
    const Recent& lately = recent[tally.sensor];
    sensors.push_back({{"id", tally.sensor},
                       {"echoes", tally.echoes},
                       {"no_echoes", tally.no_echoes},
                       {"too_close", tally.too_close},
                       {"rejected", std::move(rejected)},
                       {"rejected_last_minute", lately.rejected},
                       {"rate_hz", lately.rate_hz},
                       {"on", !mapper.sensors_off().contains(tally.sensor)}});
  }
  return sensors;
}

Json series_of(std::span<const live::TimelineBin> bins, std::uint32_t live::TimelineBin::* field) {
  Json series = Json::array();
  for (const live::TimelineBin& bin : bins) series.push_back(bin.*field);
  return series;
}

Json arc_limits(const Arc& arc) {
  return {{"length_m", arc.length_m()}, {"t_begin", arc.t_begin().rad()}, {"t_end", arc.t_end().rad()}};
}

Json support_of(const live::Support& support) {
  return {{"ping", json_of(support.ping)},
          {"t", json_of(support.t)},
          {"angle", json_of(support.crossing_angle)},
          {"x", support.crossing ? json_of(support.crossing->x) : Json()},
          {"y", support.crossing ? json_of(support.crossing->y) : Json()},
          {"note", support.note}};
}

Json cell_of(const live::CellHistory& cell) {
  constexpr std::array where{"on", "before", "beside"};
  Json changes = Json::array();
  for (const live::CellHistoryEntry& entry : cell.changes)
    changes.push_back({{"ping", entry.ping.reading.ping},
                       {"t", entry.ping.reading.time_s},
                       {"sensor", entry.ping.reading.rx},
                       {"before", json_of(entry.before)},
                       {"after", json_of(entry.after)},
                       {"where", where.at(static_cast<std::size_t>(entry.where))}});
  return {{"method", cell.method},
          {"i", cell.cell.i},
          {"j", cell.cell.j},
          {"unit", cell.unit},
          {"value", json_of(cell.value)},
          {"probability", json_of(cell.probability)},
          {"changes", std::move(changes)},
          {"total", cell.total}};
}

Json changed_cells(const live::Step& step) {
  Json cells = Json::array();
  for (const CellChange& change : step.cells) {
    Json terms = Json::array();
    for (const Term& term : change.terms)
      terms.push_back({{"name", term.name}, {"value", json_of(term.value)}, {"unit", term.unit}});
    cells.push_back({{"i", change.cell.i},
                     {"j", change.cell.j},
                     {"x", change.centre.x},
                     {"y", change.centre.y},
                     {"before", change.before},
                     {"after", change.after},
                     {"terms", std::move(terms)}});
  }
  return cells;
}

Json touched_arcs(const live::Step& step) {
  constexpr std::array what{"crossed", "cut", "removed"};
  Json arcs = Json::array();
  for (const live::TouchedArc& arc : step.arcs)
    arcs.push_back({{"ping", json_of(arc.ping)},
                    {"what", what.at(static_cast<std::size_t>(arc.what))},
                    {"x", arc.crossing ? json_of(arc.crossing->x) : Json()},
                    {"y", arc.crossing ? json_of(arc.crossing->y) : Json()},
                    {"t_begin", arc.left ? json_of(arc.left->t_begin().rad()) : Json()},
                    {"t_end", arc.left ? json_of(arc.left->t_end().rad()) : Json()},
                    {"note", arc.note}});
  return arcs;
}

}  // namespace

std::string methods_message(const live::Mapper& mapper) {
  constexpr std::array states{"ok", "recomputing", "failed"};
  Json running = Json::array();
  for (const live::RunningMethod& method : mapper.methods())
    running.push_back({{"method", method.id()},
                       {"name", method.choice.name},
                       {"label", label_of(method.choice)},
                       {"options", json_of(method.options)},
                       {"state", states.at(static_cast<std::size_t>(method.state))},
                       {"reason", method.reason},
                       {"grid", grid_of(method.store)},
                       {"points", method.point_method}});
  return text_of({{"type", "methods"}, {"running", std::move(running)}});
}

std::string recompute_message(const live::RunningMethod& method) {
  return text_of(
      {{"type", "recompute"}, {"method", method.id()}, {"done", method.recomputed}, {"total", method.recompute_total}});
}

std::string scores_message(const live::Scores& scores) {
  Json methods = Json::array();
  for (const live::MethodScore& score : scores.methods)
    methods.push_back({{"method", score.method},
                       {"points", score.points},
                       {"bound_m", json_of(score.bound_m)},
                       {"mae_m", json_of(score.mae_m)},
                       {"p95_m", json_of(score.p95_m)},
                       {"found", json_of(score.found)},
                       {"cpu_ms_per_ping", json_of(score.cpu_ms_per_ping)}});
  return text_of(
      {{"type", "scores"}, {"t", scores.time_s}, {"reason", scores.reason}, {"methods", std::move(methods)}});
}

std::string counters_message(const live::Mapper& mapper, const std::string& log) {
  const SensingReport& report = mapper.report();
  const Json json{{"type", "counters"},
                  {"pings", report.pings},
                  {"echoes", report.echoes},
                  {"no_echoes", report.no_echoes},
                  {"too_close", report.too_close},
                  {"waiting", report.waiting},
                  {"rejected", counts_of(report.rejected_pings)},
                  {"rejected_odometry", counts_of(report.rejected_odometry)},
                  {"sensors", sensors_of(mapper)},
                  {"log", Json::parse(log)}};
  std::string text = text_of(json);
  text.pop_back();
  return text + R"(,"dropped":)";
}

std::string timeline_message(std::span<const live::TimelineBin> before, std::span<const live::TimelineBin> now) {
  const auto equal = [](const live::TimelineBin& a, const live::TimelineBin& b) {
    return a.echoes == b.echoes && a.no_echoes == b.no_echoes && a.rejected == b.rejected;
  };
  std::size_t first = 0;
  while (first < before.size() && first < now.size() && equal(before[first], now[first])) ++first;
  const auto changed = now.subspan(first);
  return text_of({{"type", "timeline"},
                  {"first", first},
                  {"echoes", series_of(changed, &live::TimelineBin::echoes)},
                  {"no_echoes", series_of(changed, &live::TimelineBin::no_echoes)},
                  {"rejected", series_of(changed, &live::TimelineBin::rejected)}});
}

std::string history_message(const live::Mapper& mapper, const live::ScoreKeeper& scores) {
  Json series = Json::array();
  for (const live::RunningMethod& method : mapper.methods()) {
    Json times = Json::array();
    Json errors = Json::array();
    for (const live::Scores& entry : scores.history())
      for (const live::MethodScore& score : entry.methods)
        if (score.method == method.id()) {
          times.push_back(entry.time_s);
          errors.push_back(json_of(score.mae_m));
        }
    series.push_back({{"method", method.id()}, {"t", std::move(times)}, {"mae_m", std::move(errors)}});
  }
  const auto bins = mapper.timeline();
  return text_of({{"type", "history"},
                  {"bin_s", live::Mapper::timeline_bin_s},
                  {"echoes", series_of(bins, &live::TimelineBin::echoes)},
                  {"no_echoes", series_of(bins, &live::TimelineBin::no_echoes)},
                  {"rejected", series_of(bins, &live::TimelineBin::rejected)},
                  {"scores", std::move(series)}});
}

std::string explanation_message(MessageId id, std::optional<std::uint32_t> slot, const live::Explanation& explanation) {
  Json support = Json::array();
  for (const live::Support& one : explanation.support) support.push_back(support_of(one));
  Json unused = Json::array();
  for (const live::UnusedPings& group : explanation.unused)
    unused.push_back({{"reason", group.reason}, {"count", group.count}});
  Json arc;
  if (explanation.arc && explanation.t)
    arc = {{"t", explanation.t->rad()},
           {"t_begin", explanation.arc->t_begin().rad()},
           {"t_end", explanation.arc->t_end().rad()},
           {"bound_t", json_of(explanation.bound_t)}};
  return text_of({{"type", "explanation"},
                  {"id", id},
                  {"method", explanation.method},
                  {"kind", explanation.is_point ? "point" : "cell"},
                  {"sentence", explanation.sentence},
                  {"x", explanation.position.x},
                  {"y", explanation.position.y},
                  {"slot", slot ? Json(*slot) : Json()},
                  {"label", explanation.label},
                  {"bound_m", json_of(explanation.bound_m)},
                  {"probability", json_of(explanation.probability)},
                  {"off_wall_m", json_of(explanation.off_wall_m)},
                  {"own", explanation.own ? json_of(*explanation.own) : Json()},
                  {"arc", std::move(arc)},
                  {"support", std::move(support)},
                  {"unused", std::move(unused)},
                  {"cell", explanation.cell ? cell_of(*explanation.cell) : Json()},
                  {"searched", explanation.searched}});
}

std::string stepped_message(MessageId id, const live::Step& step, double temperature_k) {
  Json formulas = Json::array();
  for (const live::FormulaLine& line : step.formulas)
    formulas.push_back({{"words", line.words}, {"tree", Json::parse(line.tree)}, {"result", line.result}});
  Json points = Json::array();
  for (const Vec2 point : step.points) points.push_back(json_of(point));
  const double speed_m_s = speed_of_sound_m_s(temperature_k);
  const std::optional<double> heard_m = echo_range_m(step.ping.reading.outcome);
  return text_of({{"type", "stepped"},
                  {"id", id},
                  {"method", step.method},
                  {"ping", json_of(step.ping)},
                  {"used", step.used},
                  {"reason", step.reason},
                  {"time_of_flight_s", heard_m ? Json(2.0 * *heard_m / speed_m_s) : Json()},
                  {"speed_of_sound_m_s", speed_m_s},
                  {"true_pose", json_of(step.T_world_true)},
                  {"arc", step.arc ? arc_limits(*step.arc) : Json()},
                  {"cell_m", json_of(step.cell_m)},
                  {"unit", step.unit},
                  {"cells", changed_cells(step)},
                  {"formulas", std::move(formulas)},
                  {"arcs", touched_arcs(step)},
                  {"points", std::move(points)},
                  {"summary", step.summary}});
}

}  // namespace echoarc::server
