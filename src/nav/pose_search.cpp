// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/pose_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nav/pose_bins.hpp"

namespace echoarc::nav {
namespace {

constexpr std::size_t most_judged = 1000;  // by all readings
constexpr double kept_bin_m = 0.4;
constexpr Angle kept_bin_turn = degrees(20.0);
constexpr double first_climb_m = 0.12;
constexpr Angle first_climb_turn = degrees(5.0);
constexpr double drift_m = 0.04;  // of a hypothesis since it was last brought up to date
constexpr Angle drift_turn = degrees(1.5);
constexpr std::size_t followed_best = 150;    // hypotheses that are brought up to date at every step ...
constexpr std::size_t followed_others = 150;  // ... and of the others so many
constexpr std::size_t polished = 60;          // by all readings
constexpr int polish_climbs = 20;

bool better(const PoseHypothesis& a, const PoseHypothesis& b) {
  return a.log_likelihood > b.log_likelihood;
}

/// The window grows while the search goes on: what is held against more readings is not the worse for it.
double per_reading(const PoseHypothesis& hypothesis, const ReadingProbes& probes) {
  return hypothesis.log_likelihood / static_cast<double>(std::max<std::size_t>(1, probes.size()));
}

/// Of every bin the best hypothesis, of these the best `keep`, best first. Along a corridor a great many places fit
/// alike: without bins they would leave no room for others.
void keep_best(std::vector<PoseHypothesis>& hypotheses, std::size_t keep) {
  std::vector<std::pair<PoseBin, std::size_t>> order;
  order.reserve(hypotheses.size());
  for (std::size_t n = 0; n < hypotheses.size(); ++n)
    order.emplace_back(bin_of(hypotheses[n].T_map_robot, kept_bin_m, kept_bin_turn), n);
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    const double likelier = hypotheses[a.second].log_likelihood - hypotheses[b.second].log_likelihood;
    return likelier != 0.0 ? likelier > 0.0 : a.second < b.second;
  });
  std::vector<PoseHypothesis> kept;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (k == 0 || order[k].first != order[k - 1].first) kept.push_back(hypotheses[order[k].second]);
  std::stable_sort(kept.begin(), kept.end(), better);
  if (kept.size() > keep) kept.resize(keep);
  hypotheses = std::move(kept);
}

}  // namespace

void PoseSearch::begin(double floor_m2) {
  const double per_m2 = (degrees(360.0) / options_.turn) / (options_.spacing_m * options_.spacing_m);
  wanted_ = static_cast<std::uint64_t>(std::clamp(std::ceil(floor_m2 * per_m2), 1.0, 1e12));
  tried_ = 0;
  hypotheses_.clear();
}

double PoseSearch::progress() const {
  return wanted_ == 0 ? 1.0 : std::min(1.0, static_cast<double>(tried_) / static_cast<double>(wanted_));
}

void PoseSearch::move(const Pose2& T_before_now) {
  for (PoseHypothesis& hypothesis : hypotheses_) hypothesis.T_map_robot = hypothesis.T_map_robot * T_before_now;
}

void PoseSearch::step(const LikelihoodMap& map, const ReadingProbes& coarse, const ReadingProbes& fine, Rng& rng) {
  if (done()) return;
  const std::uint64_t count = std::min<std::uint64_t>(static_cast<std::uint64_t>(options_.batch), wanted_ - tried_);
  const double from = progress();
  tried_ += count;
  const double slice = (progress() - from) / static_cast<double>(count);
  follow(map, fine, rng);
  std::vector<Pose2> candidates;
  candidates.reserve(count);
  for (std::uint64_t n = 0; n < count; ++n) {
    const Vec2 place = map.place_at(from + slice * (static_cast<double>(n) + rng.uniform()), rng);
    candidates.push_back({place, degrees(rng.uniform(-180.0, 180.0))});
  }
  const auto keep = static_cast<std::size_t>(options_.kept_of_batch);
  for (PoseHypothesis found : best_of(candidates, keep, map, coarse, fine, rng)) {
    found.log_likelihood = per_reading(found, fine);
    hypotheses_.push_back(found);
  }
  thin();
}

/// Odometry has drifted since they were found, and there are newer readings.
void PoseSearch::follow(const LikelihoodMap& map, const ReadingProbes& fine, Rng& rng) {
  const auto refresh = [&](PoseHypothesis& hypothesis) {
    hypothesis = climb(hypothesis, map, fine, {options_.climbs, drift_m, drift_turn}, rng);
    hypothesis.log_likelihood = per_reading(hypothesis, fine);
  };
  const std::size_t best = std::min(followed_best, hypotheses_.size());
  for (std::size_t n = 0; n < best; ++n) refresh(hypotheses_[n]);
  for (std::size_t n = 0; n < followed_others && best < hypotheses_.size(); ++n)
    refresh(hypotheses_[best + rng.below(hypotheses_.size() - best)]);
}

std::vector<PoseHypothesis> PoseSearch::best_of(const std::vector<Pose2>& candidates, std::size_t keep,
                                                const LikelihoodMap& map, const ReadingProbes& coarse,
                                                const ReadingProbes& fine, Rng& rng) const {
  std::vector<PoseHypothesis> found;
  found.reserve(candidates.size());
  for (const Pose2& candidate : candidates) found.push_back({candidate, coarse.fit(candidate).log_likelihood});
  keep_best(found, keep);
  for (PoseHypothesis& hypothesis : found) hypothesis = climb(hypothesis, map, fine, wide(), rng);
  std::sort(found.begin(), found.end(), better);
  return found;
}

PoseHypothesis PoseSearch::climb(PoseHypothesis from, const LikelihoodMap& map, const ReadingProbes& fine,
                                 const Climb& by, Rng& rng) {
  from.log_likelihood = fine.fit(from.T_map_robot).log_likelihood;
  for (int n = 0; n < by.moves; ++n) {
    const double size = 1.0 - 0.8 * n / by.moves;
    const double x = rng.normal(0.0, size * by.first_m);
    const double y = rng.normal(0.0, size * by.first_m);
    const Angle turn = rng.normal(0.0, 1.0) * size * by.first_turn;
    PoseHypothesis moved{{from.T_map_robot.position + Vec2{x, y}, from.T_map_robot.heading + turn}, 0.0};
    if (!map.may_stand(moved.T_map_robot.position)) continue;
    moved.log_likelihood = fine.fit(moved.T_map_robot).log_likelihood;
    if (better(moved, from)) from = moved;
  }
  return from;
}

void PoseSearch::judge(const LikelihoodMap& map, const ReadingProbes& quick, const ReadingProbes& all, Rng& rng) {
  for (PoseHypothesis& hypothesis : hypotheses_) hypothesis = climb(hypothesis, map, quick, wide(), rng);
  thin();
  if (hypotheses_.size() > most_judged) hypotheses_.resize(most_judged);
  for (PoseHypothesis& h : hypotheses_) h.log_likelihood = all.fit(h.T_map_robot).log_likelihood;
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(), better);
  for (std::size_t n = 0; n < std::min(polished, hypotheses_.size()); ++n)
    hypotheses_[n] = climb(hypotheses_[n], map, all, {polish_climbs, first_climb_m, first_climb_turn}, rng);
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(), better);
}

PoseSearch::Climb PoseSearch::wide() const {
  return {options_.climbs, first_climb_m, first_climb_turn};
}

void PoseSearch::thin() {
  keep_best(hypotheses_, static_cast<std::size_t>(options_.kept));
}

}  // namespace echoarc::nav
