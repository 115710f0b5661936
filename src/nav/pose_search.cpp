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

bool better(const PoseHypothesis& a, const PoseHypothesis& b) {
  return a.log_likelihood > b.log_likelihood;
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
  std::vector<Pose2> candidates;
  candidates.reserve(count);
  for (std::uint64_t n = 0; n < count; ++n) {
    const Vec2 place = map.place_at(from + slice * (static_cast<double>(n) + rng.uniform()), rng);
    candidates.push_back({place, degrees(rng.uniform(-180.0, 180.0))});
  }
  const auto keep = static_cast<std::size_t>(options_.kept_of_batch);
  const auto found = best_of(candidates, keep, map, coarse, fine, rng);
  hypotheses_.insert(hypotheses_.end(), found.begin(), found.end());
  thin();
}

std::vector<PoseHypothesis> PoseSearch::best_of(const std::vector<Pose2>& candidates, std::size_t keep,
                                                const LikelihoodMap& map, const ReadingProbes& coarse,
                                                const ReadingProbes& fine, Rng& rng) const {
  std::vector<PoseHypothesis> found;
  found.reserve(candidates.size());
  for (const Pose2& candidate : candidates) found.push_back({candidate, coarse.fit(candidate).log_likelihood});
  keep_best(found, keep);
  for (PoseHypothesis& hypothesis : found) hypothesis = climb(hypothesis, map, fine, rng);
  std::sort(found.begin(), found.end(), better);
  return found;
}

PoseHypothesis PoseSearch::climb(PoseHypothesis from, const LikelihoodMap& map, const ReadingProbes& fine,
                                 Rng& rng) const {
  from.log_likelihood = fine.fit(from.T_map_robot).log_likelihood;
  for (int n = 0; n < options_.climbs; ++n) {
    const double size = 1.0 - 0.8 * n / options_.climbs;
    const double x = rng.normal(0.0, size * first_climb_m);
    const double y = rng.normal(0.0, size * first_climb_m);
    const Angle turn = rng.normal(0.0, 1.0) * size * first_climb_turn;
    PoseHypothesis moved{{from.T_map_robot.position + Vec2{x, y}, from.T_map_robot.heading + turn}, 0.0};
    if (!map.may_stand(moved.T_map_robot.position)) continue;
    moved.log_likelihood = fine.fit(moved.T_map_robot).log_likelihood;
    if (better(moved, from)) from = moved;
  }
  return from;
}

void PoseSearch::judge(const LikelihoodMap& map, const ReadingProbes& quick, const ReadingProbes& all, Rng& rng) {
  for (PoseHypothesis& hypothesis : hypotheses_) hypothesis = climb(hypothesis, map, quick, rng);
  thin();
  if (hypotheses_.size() > most_judged) hypotheses_.resize(most_judged);
  for (PoseHypothesis& h : hypotheses_) h.log_likelihood = all.fit(h.T_map_robot).log_likelihood;
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(), better);
}

void PoseSearch::thin() {
  keep_best(hypotheses_, static_cast<std::size_t>(options_.kept));
}

}  // namespace echoarc::nav
