// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "echoarc/mapping/grid_options.hpp"

namespace echoarc {

/// What a consensus map is for.
enum class ConsensusMode : std::uint8_t {
  strict,    ///< only points that are nearly certain
  balanced,  ///< points more likely right than wrong, linked
  complete,  ///< longer links, what specular walls must span, and the likeliest points where nothing else is
};
constexpr std::array<Choice<ConsensusMode>, 3> choices(ConsensusMode /*tag*/) {
  return {{{ConsensusMode::strict, "strict"},
           {ConsensusMode::balanced, "balanced"},
           {ConsensusMode::complete, "complete"}}};
}

/// Every constant of `Consensus`; the letters are the steps of docs/methods/consensus.md.
struct ConsensusOptions {
  double cell_m = 0.01;  ///< of the exported picture; the points themselves are exact
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  ConsensusMode mode = ConsensusMode::balanced;

  double range_max_m = 5.0;
  double thin_move_m = 0.02;
  Angle thin_turn = degrees(1.0);
  double thin_range_m = 0.02;

  double search_beams = 0.95;
  double sigma_beams = 0.4;
  double wider_growth = 2.5;
  Angle step = degrees(1.0);
  int history = 500;
  double reach_m = 3.0;
  int neighbours = 96;
  double wall_length_m = 0.35;
  double range_sigma_m = 0.045;
  double clutter_m = 3.0;
  double detection = 0.6;
  double independence = 0.22;
  double facing = 0.3;
  Angle facing_angle = degrees(10.0);
  double free_margin_m = 0.10;
  int sweeps = 2;

  double tolerance_m = 0.12;
  double bound_least_m = 0.05;
  double accept_p = 0.5;
  double strict_p = 0.7;
  double evidence = 0.3;
  double map_range_m = 3.0;

  double body_m = 0.18;
  double element_m = 0.12;
  double front_m = 0.05;
  double behind_m = 0.15;
  double blocked = 2.5;
  double blocked_ratio = 0.5;
  double passed = 3.0;
  double passed_ratio = 2.0;
  int votes = 6;
  double spread_m = 0.12;
  double band_sigma_m = 0.02;
  double occupied_peak = 0.85;
  double free_floor = 0.25;
  double occupied_threshold = 0.65;

  double link_m = 0.65;
  double complete_link_m = 0.8;
  double link_p = 0.7;
  double link_step_m = 0.05;
  int link_crossings = 2;
  int link_misses = 2;
  double link_ray_m = 0.3;
  double link_ray_end_m = 0.15;
  double link_bound_m = 0.10;
  double link_decay_m = 4.0;

  double zone = 1.2;
  double zone_p = 0.9;
  double zone_bound_m = 0.055;
  double wavelength_m = 0.007;
  double weak_p = 0.25;
  int settle_arcs = 100;
  int renew_arcs = 400;
  int vote_arcs = 1500;
  int window_arcs = 20'000;
  int min_neighbours = 0;
  double neighbour_radius_m = 0.2;

  static constexpr auto fields();
};

namespace detail {

constexpr auto consensus_mode_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("mode", &O::mode,
            {.doc = "what the map is for: strict shows p above strict_p; balanced p above accept_p; complete adds "
                    "longer links, Fresnel zones and weak points"})};
}

constexpr auto consensus_beam_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("range_max_m", &O::range_max_m,
            {.unit = "m", .min = 0.01, .max = 1000.0, .doc = "A: farther echoes are passed over: few arcs meet them"}),
      field(
          "thin_move_m", &O::thin_move_m,
          {.unit = "m",
           .min = 0.0,
           .max = 10.0,
           .doc = "A: a reading that moved less, turned less and changed less against the last of its sensor says the "
                  "same again, and is passed over"}),
      field("thin_turn_deg", &O::thin_turn, {.unit = "deg", .min = 0.0, .max = 180.0, .doc = "A: turned less"}),
      field("thin_range_m", &O::thin_range_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "A: changed its range no more"}),
      field("search_beams", &O::search_beams,
            {.unit = "beams",
             .min = 0.1,
             .max = 4.0,
             .doc = "B: bearings searched to either side of the axis, in beam widths: strong echoes come from outside "
                    "the beam"}),
      field("sigma_beams", &O::sigma_beams,
            {.unit = "beams",
             .min = 0.01,
             .max = 10.0,
             .doc = "B: standard deviation of an echo's bearing, in beam widths; 7.8 to 11.7 degrees were measured "
                    "with beams of 20"}),
      field(
          "wider_growth", &O::wider_growth,
          {.min = 1.0,
           .max = 1e6,
           .doc = "B: beams are taken for twice as wide as stated if the bearings of clear echoes then scatter by more "
                  "than so many times as much: up to 2.2 was seen where they are as stated, 3 and more where not. "
                  "1000000: never"}),
      field("step_deg", &O::step,
            {.unit = "deg",
             .min = 0.25,
             .max = 10.0,
             .doc = "B: between the bearings searched; 1.7 cm/m, below the "
                    "error of the ranges"})};
}

constexpr auto consensus_neighbour_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("history", &O::history,
            {.unit = "arcs",
             .min = 1,
             .max = 100'000,
             .doc = "B: an arc is compared with so many before and after it; odometry drifts over more"}),
      field("reach_m", &O::reach_m,
            {.unit = "m", .min = 0.01, .max = 1000.0, .doc = "B: and with none whose middle is farther away"}),
      field("neighbours", &O::neighbours,
            {.unit = "arcs",
             .min = 1,
             .max = 4096,
             .doc = "B: of more, so many are taken, evenly spaced in time, and weighted up"}),
      field("wall_length_m", &O::wall_length_m,
            {.unit = "m",
             .min = 0.01,
             .max = 10.0,
             .doc = "B: length over which a wall keeps its direction: support along it falls with exp(-s^2/2 l^2)"}),
      field("range_sigma_m", &O::range_sigma_m,
            {.unit = "m",
             .min = 0.005,
             .max = 1.0,
             .doc = "B: standard deviation of a range with the error of the pose between two readings"}),
      field(
          "clutter_m", &O::clutter_m,
          {.unit = "m", .min = 0.1, .max = 100.0, .doc = "B: a reading of nothing in particular is spread over this"}),
      field("detection", &O::detection,
            {.min = 0.0, .max = 1.0, .doc = "B: chance that a sensor reports a surface that it faces"}),
      field("independence", &O::independence,
            {.min = 0.0, .max = 1.0, .doc = "B: share of the neighbours that is independent: one in five"}),
      field("facing", &O::facing,
            {.min = 0.0,
             .max = 0.99,
             .doc = "B: chance that a sensor which looks at a surface squarely does not miss it, for what lies before "
                    "its range"}),
      field("facing_deg", &O::facing_angle,
            {.unit = "deg", .min = 0.0, .max = 45.0, .doc = "B: squarely: within this"}),
      field("free_margin_m", &O::free_margin_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "B: before its range: by more than this"}),
      field("sweeps", &O::sweeps,
            {.min = 1, .max = 10, .doc = "B: rounds in which arcs weigh one another; more reinforce themselves"})};
}

constexpr auto consensus_reading_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("tolerance_m", &O::tolerance_m,
            {.unit = "m", .min = 0.001, .max = 10.0, .doc = "C: p is the chance that the point is this near the echo"}),
      field("bound_least_m", &O::bound_least_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "C: least 90 % bound, for what the arcs do not tell"}),
      field("accept_p", &O::accept_p, {.min = 0.0, .max = 1.0, .doc = "C: a point is shown if p is above this"}),
      field("strict_p", &O::strict_p,
            {.min = 0.0,
             .max = 1.0,
             .doc = "C: the same in mode strict; and zones grow in mode complete from points above it"}),
      field("evidence", &O::evidence,
            {.min = 0.0, .max = 100.0, .doc = "C: least log-likelihood of the best bearing against the beam alone"}),
      field("map_range_m", &O::map_range_m,
            {.unit = "m",
             .min = 0.01,
             .max = 1000.0,
             .doc = "C: echoes from farther speak for others, but are not "
                    "shown"})};
}

constexpr auto consensus_vote_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("body_m", &O::body_m,
            {.unit = "m",
             .min = 0.0,
             .max = 10.0,
             .doc = "D: the robot's inscribed radius: where it went nothing can be"}),
      field("element_m", &O::element_m,
            {.unit = "m", .min = 0.01, .max = 10.0, .doc = "D: half the surface that a point stands for"}),
      field("front_m", &O::front_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "D: a ray crosses a surface that begins so far before it"}),
      field("behind_m", &O::behind_m, {.unit = "m", .min = 0.0, .max = 10.0, .doc = "D: and ends so far behind it"}),
      field("blocked", &O::blocked,
            {.min = 0.0, .max = 1e6, .doc = "D: a ray that crosses so much well supported surface is an outlier"}),
      field(
          "blocked_ratio", &O::blocked_ratio,
          {.min = 0.0,
           .max = 1e6,
           .doc = "D: unless others support its end: if it crosses no more than so many for each of those. People who "
                  "come and go cross good rays"}),
      field("passed", &O::passed, {.min = 0.0, .max = 1e6, .doc = "D: a point goes if so many rays cross it"}),
      field("passed_ratio", &O::passed_ratio,
            {.min = 0.0, .max = 1e6, .doc = "D: and more than so many for each that supports it"}),
      field("votes", &O::votes, {.min = 1, .max = 100, .doc = "D: rounds of the vote, the last one hard"})};
}

constexpr auto consensus_surface_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("spread_m", &O::spread_m,
            {.unit = "m",
             .min = 0.0,
             .max = 1.0,
             .doc = "an echo speaks of places within this of where it came from, along the arc, and of those on the "
                    "way: the least that reflects sound"}),
      field("band_sigma_m", &O::band_sigma_m,
            {.unit = "m",
             .min = 0.001,
             .max = 1.0,
             .doc = "standard deviation of a range alone; the band is 4 of them deep, as that of `evidence`"}),
      field("occupied_peak", &O::occupied_peak,
            {.min = 0.501, .max = 0.999, .doc = "p(occupied) that an echo gives a place it certainly came from"}),
      field("free_floor", &O::free_floor,
            {.min = 0.001, .max = 0.499, .doc = "p(occupied) that an echo gives a place that its sound went through"}),
      field("occupied_threshold", &O::occupied_threshold,
            {.min = 0.5, .max = 0.999, .doc = "a place is occupied when p, of all echoes together, reaches this"})};
}

constexpr auto consensus_link_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("link_m", &O::link_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "E: longest gap that is closed. 0: none"}),
      field("complete_link_m", &O::complete_link_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "E: the same in mode complete"}),
      field(
          "link_p", &O::link_p,
          {.min = 0.0,
           .max = 1.0,
           .doc = "E: of the two ends of a link one has p above this: where arcs are few, unsure points are linked to "
                  "unsure points all over the room"}),
      field("link_step_m", &O::link_step_m,
            {.unit = "m",
             .min = 0.001,
             .max = 10.0,
             .doc = "E, F: between the points of a link; between a zone and anything else"}),
      field("link_crossings", &O::link_crossings,
            {.min = 1, .max = 1'000'000, .doc = "E: so many rays through a gap keep it open"}),
      field("link_misses", &O::link_misses,
            {.min = 1,
             .max = 1'000'000,
             .doc = "E: so many looks at a right angle to a gap, which hear nothing there, keep it open, if they are "
                    "more than passed_ratio for each that does; silence counts as far as it is trusted"}),
      field("link_ray_m", &O::link_ray_m,
            {.unit = "m", .min = 0.0, .max = 100.0, .doc = "E: rays shorter than this do not count"}),
      field("link_ray_end_m", &O::link_ray_end_m,
            {.unit = "m", .min = 0.0, .max = 100.0, .doc = "E: nor does the end of a ray"}),
      field("link_bound_m", &O::link_bound_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "E: 90 % bound of a link's points"}),
      field("link_decay_m", &O::link_decay_m,
            {.unit = "m",
             .min = 0.01,
             .max = 1000.0,
             .doc =
                 "E: a link's points have the p of its less certain end times exp(-length / link_decay_m): of links of "
                 "half a metre between certain points about nine in ten hold"}),
      field("zone", &O::zone,
            {.min = 0.0,
             .max = 10.0,
             .doc = "F: surfaces reach so many radii of the first Fresnel zone to either side of an echo, the least "
                    "that reflects it. 0: none; none in mode strict"}),
      field("zone_p", &O::zone_p,
            {.min = 0.0, .max = 1.0, .doc = "F: of points with p above this; in mode complete above strict_p"}),
      field("zone_bound_m", &O::zone_bound_m,
            {.unit = "m", .min = 0.0, .max = 10.0, .doc = "F: least 90 % bound of a zone's points"}),
      field("wavelength_m", &O::wavelength_m,
            {.unit = "m", .min = 0.0, .max = 1.0, .doc = "E, F: of the ping; 50 kHz in air"}),
      field("weak_p", &O::weak_p, {.min = 0.0, .max = 1.0, .doc = "mode complete: weak points have p above this"}),
      field("settle_arcs", &O::settle_arcs,
            {.unit = "arcs",
             .min = 0,
             .max = 1'000'000,
             .doc = "points of the newest arcs are provisional: what follows still moves them"})};
}

constexpr auto consensus_line_fields() {
  using O = ConsensusOptions;
  return std::tuple{
      field("renew_arcs", &O::renew_arcs,
            {.unit = "arcs",
             .min = 8,
             .max = 100'000,
             .doc = "on line: after so many new arcs votes and links are renewed, and arcs with half as many behind "
                    "them weighed again: less often is cheaper, and leaves newer points as they came"}),
      field("vote_arcs", &O::vote_arcs,
            {.unit = "arcs",
             .min = 100,
             .max = 10'000'000,
             .doc = "on line: votes and links look back so far: people who walk beside the robot are voted out by "
                    "what is heard there metres later"}),
      field("window_arcs", &O::window_arcs,
            {.unit = "arcs",
             .min = 1000,
             .max = 10'000'000,
             .doc = "points of arcs older than this are final: votes, links and corrections come too late for them. At "
                    "least twice sweeps * history; twice as many arcs are kept at most"})};
}

}  // namespace detail

constexpr auto ConsensusOptions::fields() {
  using O = ConsensusOptions;
  return std::tuple_cat(detail::consensus_mode_fields(), detail::consensus_beam_fields(),
                        detail::consensus_neighbour_fields(), detail::consensus_reading_fields(),
                        detail::consensus_vote_fields(), detail::consensus_surface_fields(),
                        detail::consensus_link_fields(), detail::consensus_line_fields(), neighbour_fields<O>(),
                        arc_fields<O>(), grid_fields<O>());
}

}  // namespace echoarc
