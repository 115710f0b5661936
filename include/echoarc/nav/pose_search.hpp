// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/nav/likelihood_map.hpp"

namespace echoarc::nav {

struct PoseSearchOptions {
  double spacing_m = 0.3;
  Angle turn = degrees(12.0);
  int batch = 30'000;
  int kept_of_batch = 250;
  int kept = 3'000;
  double coarse_sigma_m = 0.25;
  int climbs = 5;
  int window = 200;
  int least_echoes = 24;
  double least_way_m = 1.0;

  static constexpr auto fields() {
    using O = PoseSearchOptions;
    return std::tuple{
        field("spacing_m", &O::spacing_m,
              {.unit = "m", .min = 0.05, .max = 10.0, .doc = "one candidate falls on a square of this side ..."}),
        field("turn_deg", &O::turn, {.unit = "deg", .min = 1.0, .max = 180.0, .doc = "... and on so much of heading"}),
        field("batch", &O::batch,
              {.min = 100, .max = 1e6, .doc = "candidates that are tried at one step of the robot"}),
        field("kept_of_batch", &O::kept_of_batch, {.min = 1, .max = 1e6, .doc = "the best of them are improved"}),
        field("kept", &O::kept, {.min = 1, .max = 1e6, .doc = "and so many of all are kept"}),
        field("coarse_sigma_m", &O::coarse_sigma_m,
              {.unit = "m",
               .min = 0.01,
               .max = 10.0,
               .doc = "standard deviation between arc and wall for candidates, which lie beside the true pose"}),
        field("climbs", &O::climbs, {.min = 0, .max = 1000, .doc = "random moves by which one is improved"}),
        field("window", &O::window,
              {.min = 8, .max = 10'000, .doc = "recent readings that candidates are held against"}),
        field("least_echoes", &O::least_echoes, {.min = 1, .max = 10'000, .doc = "echoes among them to begin with"}),
        field("least_way_m", &O::least_way_m,
              {.unit = "m", .min = 0.0, .max = 100.0, .doc = "and way on which they were heard"})};
  }
};

struct PoseHypothesis {
  Pose2 T_map_robot;
  double log_likelihood = 0.0;  ///< of the recent readings; while the search goes on, of one of them on average
};

/// Looks over the whole free floor of a map for poses that fit recent readings, a batch at a time so that no step takes
/// long: random candidates judged coarsely, the best of each batch improved by random moves and judged finely. It is
/// the uniform prior of global Monte Carlo localisation, drawn slice by slice of the floor: a building takes millions
/// of samples.
class PoseSearch {
 public:
  explicit PoseSearch(const PoseSearchOptions& options) : options_(options) {}

  /// Begins anew on a floor of this area.
  void begin(double floor_m2);
  /// A pose that is a candidate anyway.
  void add(const Pose2& T_map_robot) { hypotheses_.push_back({T_map_robot, 0.0}); }
  /// All hypotheses make the step that odometry measured.
  void move(const Pose2& T_before_now);
  /// One batch. Requires `map.has_floor()`.
  void step(const LikelihoodMap& map, const ReadingProbes& coarse, const ReadingProbes& fine, Rng& rng);
  [[nodiscard]] bool done() const { return tried_ >= wanted_; }
  /// Share of the candidates that were tried, 0 ... 1.
  [[nodiscard]] double progress() const;
  /// Improves all hypotheses by the newest readings, `quick` being some of them, and judges the best by all. What was
  /// found early has drifted since.
  void judge(const LikelihoodMap& map, const ReadingProbes& quick, const ReadingProbes& all, Rng& rng);
  [[nodiscard]] std::span<const PoseHypothesis> hypotheses() const { return hypotheses_; }

  /// The best `keep` of some candidates, improved, best first.
  [[nodiscard]] std::vector<PoseHypothesis> best_of(const std::vector<Pose2>& candidates, std::size_t keep,
                                                    const LikelihoodMap& map, const ReadingProbes& coarse,
                                                    const ReadingProbes& fine, Rng& rng) const;

 private:
  /// Random moves, smaller and smaller.
  struct Climb {
    int moves = 0;
    double first_m = 0.0;
    Angle first_turn;
  };
  [[nodiscard]] static PoseHypothesis climb(PoseHypothesis from, const LikelihoodMap& map, const ReadingProbes& fine,
                                            const Climb& by, Rng& rng);
  [[nodiscard]] Climb wide() const;
  void follow(const LikelihoodMap& map, const ReadingProbes& fine, Rng& rng);
  void thin();

  PoseSearchOptions options_;
  std::uint64_t wanted_ = 0;  // candidates
  std::uint64_t tried_ = 0;
  std::vector<PoseHypothesis> hypotheses_;
};

}  // namespace echoarc::nav
