// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "echoarc/core/arc_carving.hpp"
#include "echoarc/live/cell_layer.hpp"
#include "echoarc/mapping/consensus_explanation.hpp"
#include "live/arc_partners.hpp"
#include "live/explain_cell.hpp"
#include "live/replay.hpp"

namespace echoarc::live {
namespace {

constexpr std::size_t shown_voices = 15;

struct Question {
  const Evidence& evidence;
  const MapExport& map;
  const MapPoint& point;
  PingId own_ping = 0;  ///< on whose arc it lies
  std::size_t own = 0;  ///< place of that ping in the log
  OptionMap options;    ///< all of the method's, defaults included
  ComparedArcs compared;
};

double distance_to_segment_m(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double length2 = squared_norm(way);
  const double along = length2 > 0.0 ? std::clamp(dot(p - a, way) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + along * way));
}

std::optional<double> off_wall_m(std::span<const Polyline> walls, Vec2 p) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Polyline& wall : walls)
    for (std::size_t k = 0; k < wall.size(); ++k)
      nearest_m = std::min(nearest_m, distance_to_segment_m(p, wall[k], wall[std::min(k + 1, wall.size() - 1)]));
  return std::isfinite(nearest_m) ? std::optional(nearest_m) : std::nullopt;
}

std::string count_text(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

void explain_crossings(const Question& q, Explanation& explanation) {
  Partners partners = find_partners(q.evidence, q.own, *explanation.arc, q.compared);
  explanation.unused = std::move(partners.unused);
  const std::span<const PingId> middle = q.map.points.support(q.point);
  for (const Partner& partner : partners.crossing) {
    const JudgedPing& ping = q.evidence.readings[partner.place];
    const bool is_middle = std::ranges::find(middle, ping.reading.ping) != middle.end();
    explanation.support.push_back({ping, partner.crossing.t_a, partner.crossing.angle, partner.crossing.position,
                                   is_middle ? "its crossing is in the middle" : ""});
  }
}

void explain_median(const Question& q, Explanation& explanation) {
  explain_crossings(q, explanation);
  const std::size_t n = explanation.support.size();
  explanation.sentence =
      n == 0
          ? "The middle of the beam of " + ping_text(q.own_ping) + ": no arc crosses its arc steeply enough."
          : "The median of " + count_text(n, "crossing", "crossings") + " on the arc of " + ping_text(q.own_ping) + ".";
}

/// Follows the arc of the point as newer readings carve it.
void explain_carving(const Question& q, Explanation& explanation) {
  Arc left = *explanation.arc;
  const double guard_m = number_option(q.options, "guard_m", 0.0);
  const double max_range_m = number_option(q.options, "max_range_m", std::numeric_limits<double>::infinity());
  std::uint64_t clear = 0;
  std::size_t arcs = 0;
  for (std::size_t k = q.own + 1; k < q.evidence.readings.size() && arcs < q.compared.arcs; ++k) {
    const JudgedPing& ping = q.evidence.readings[k];
    const auto range_m = echo_range_m(ping.reading.outcome);
    if (!is_used(q.evidence, ping) || !range_m || *range_m > max_range_m) continue;
    const auto arc = arc_of(ping.reading, q.compared.policy);
    if (!arc) continue;
    ++arcs;
    const Carving carving = carve(left, FreeSector(*arc, guard_m));
    if (carving.outcome != CarveOutcome::carved) {
      ++clear;
      continue;
    }
    const Angle of_right = carving.t_begin - left.t_begin();
    const Angle of_left = left.t_end() - carving.t_end;
    std::string note;
    if (of_left > eps_angle) note = "cut " + degrees_text(of_left) + " on the left";
    if (of_right > eps_angle) note += (note.empty() ? "cut " : ", ") + degrees_text(of_right) + " on the right";
    const Angle t = of_left > of_right ? carving.t_end : carving.t_begin;
    explanation.support.push_back({ping, t, std::nullopt, left.point_at(t), note});
    left.set_limits(carving.t_begin, carving.t_end);
  }
  explanation.bound_t = 0.5 * (left.t_end() - left.t_begin());
  explanation.arc = left;
  if (clear > 0) explanation.unused.push_back({"they found nothing free on what was left of it", clear});
  const std::size_t n = explanation.support.size();
  explanation.sentence = n == 0 ? "The middle of the beam of " + ping_text(q.own_ping) + ": no newer ping cut its arc."
                                : "The middle of what " + count_text(n, "newer ping", "newer pings") +
                                      " left of the arc of " + ping_text(q.own_ping) + ".";
}

/// Readings around the point's: neighbours lie within `history` arcs, and theirs as far again.
Result<void> explain_voices(const Question& q, Explanation& explanation) {
  auto options = make_options<ConsensusOptions>(q.options);
  if (!options) return options.error();
  const auto window = 2 * std::size_t(std::max(1.0, number_option(q.options, "history", 400.0)));
  const std::size_t begin = q.own > window ? q.own - window : 0;
  const std::vector<Reading> readings = used_readings(q.evidence, begin, q.own + window);
  InlineExecutor executor;
  auto echo = explain_echo(readings, *options, q.own_ping, executor);
  if (!echo) return echo.error();
  explanation.arc = echo->arc;
  explanation.t = echo->t;
  std::vector<NeighbourVoice> voices = echo->voices;
  const auto weight = [](const NeighbourVoice& v) { return v.wall + v.point; };
  std::ranges::stable_sort(voices, std::greater<>(), weight);
  const std::size_t shown = std::min(shown_voices, voices.size());
  for (const NeighbourVoice& voice : std::span(voices).first(shown)) {
    const auto place = q.evidence.readings.find(voice.ping);
    if (!place) continue;
    char note[96];
    std::snprintf(note, sizeof note, "for a wall %+.2f, for a corner %+.2f", voice.wall + voice.wall_free,
                  voice.point + voice.point_free);
    explanation.support.push_back({q.evidence.readings[*place], std::nullopt, std::nullopt, std::nullopt, note});
  }
  if (voices.size() > shown) explanation.unused.push_back({"neighbours that say less", voices.size() - shown});
  const double wall_share = echo->sweeps.empty() ? 0.5 : echo->sweeps.back().wall_share;
  char text[160];
  std::snprintf(text, sizeof text, "%zu neighbours place the echo of ping %llu here: %.0f %% sure, %.0f %% a wall.",
                voices.size(), static_cast<unsigned long long>(q.own_ping), 100.0 * echo->p, 100.0 * wall_share);
  explanation.sentence = text;
  return {};
}

/// The pings that the map itself names.
void explain_by_support(const Question& q, Explanation& explanation) {
  const CrossableArc own(*explanation.arc);
  for (const PingId id : q.map.points.support(q.point)) {
    const auto place = q.evidence.readings.find(id);
    if (!place || id == q.own_ping) continue;
    Support support{q.evidence.readings[*place], std::nullopt, std::nullopt, std::nullopt, ""};
    if (const auto arc = arc_of(support.ping.reading, q.compared.policy)) {
      const ArcCrossings met = crossings(own, CrossableArc(*arc));
      const auto* nearest =
          std::ranges::min_element(met, {}, [&](const ArcCrossing& c) { return norm(c.position - q.point.position); });
      if (nearest != met.end()) {
        support.t = nearest->t_a;
        support.crossing_angle = nearest->angle;
        support.crossing = nearest->position;
      }
    }
    explanation.support.push_back(std::move(support));
  }
  explanation.sentence = count_text(explanation.support.size() + 1, "arc meets", "arcs meet") + " here.";
}

/// What all points have in common: the arc they lie on, their bound, the truth.
void describe_point(const Question& q, Explanation& explanation) {
  explanation.is_point = true;
  explanation.position = q.point.position;
  explanation.label = name(q.point.label);
  if (std::isfinite(q.point.bound_m)) explanation.bound_m = q.point.bound_m;
  explanation.off_wall_m = off_wall_m(q.evidence.walls, q.point.position);
  explanation.own = q.evidence.readings[q.own];
  explanation.arc = arc_of(explanation.own->reading, q.compared.policy);
  if (!explanation.arc) return;
  explanation.t = wrap(bearing(q.point.position - explanation.arc->centre()) - explanation.arc->axis());
  const double radius_m = explanation.arc->radius_at(*explanation.t);
  if (explanation.bound_m && radius_m > 0.0)
    explanation.bound_t = radians(2.0 * std::asin(std::min(1.0, *explanation.bound_m / (2.0 * radius_m))));
}

Result<void> explain_by_method(const Question& q, std::string_view method, Explanation& explanation) {
  if (!explanation.arc) {
    explanation.sentence = "Between two points with nothing that speaks against a wall.";
    return {};
  }
  if (method == "consensus") {
    if (auto voiced = explain_voices(q, explanation); !voiced) explain_by_support(q, explanation);
  } else if (method == "tbf") {
    explain_by_support(q, explanation);
  } else if (method == "centerline") {
    explanation.sentence = "The middle of the beam of " + ping_text(q.own_ping) + ", nothing else.";
    const auto others = std::uint64_t(q.evidence.readings.size() - 1);
    if (others > 0) explanation.unused.push_back({"each ping makes its own point", others});
  } else if (method == "carve" || (method == "combined" && q.point.label != PointLabel::atm)) {
    explain_carving(q, explanation);
  } else {
    explain_median(q, explanation);
  }
  return {};
}

}  // namespace

Result<Explanation> explain_point(const Evidence& evidence, std::string_view id, std::size_t index) {
  const auto place = place_of(evidence, id);
  if (!place) return place.error();
  const MapExport* map = *place < evidence.maps.size() ? evidence.maps[*place].get() : nullptr;
  if (map == nullptr || index >= map->points.size())
    return Error{ErrorCode::not_found, "the map has no such point any more", std::string(id), "ask again"};
  const MapPoint& point = map->points.points()[index];
  if (point.label == PointLabel::cell) return explain_cell(evidence, id, point.position);
  const auto own = evidence.readings.find(own_ping(map->points, point));
  const MethodChoice& choice = evidence.methods[*place];
  const auto made = make_method(choice.name, choice.options);
  if (!made) return made.error();
  if (!own)
    return Error{ErrorCode::not_found, "ping " + std::to_string(own_ping(map->points, point)) + " is not in the log",
                 "", "ask again"};
  const OptionMap options = made->options();
  const Question question{
      evidence, *map, point, own_ping(map->points, point), *own, options, compared_arcs(choice.name, options)};
  Explanation explanation;
  explanation.method = choice.key();
  explanation.searched = evidence.readings.size();
  describe_point(question, explanation);
  const auto beliefs = map->points.beliefs();
  if (index < beliefs.size()) explanation.probability = beliefs[index].probability;
  if (auto explained = explain_by_method(question, choice.name, explanation); !explained) return explained.error();
  for (std::size_t k = 0; k < evidence.methods.size(); ++k)
    if (!is_point_method(evidence.methods[k].name)) {
      if (auto cell = cell_history(evidence, k, point.position)) explanation.cell = std::move(*cell);
      break;
    }
  return explanation;
}

}  // namespace echoarc::live
