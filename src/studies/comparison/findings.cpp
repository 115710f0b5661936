// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "echoarc/studies/comparison_findings.hpp"

namespace echoarc::studies {
namespace {

/// Adds up what is a number.
class Mean {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    sum_ += value;
    ++count_;
  }
  [[nodiscard]] double value() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : sum_ / double(count_);
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

MeanScores mean_of(std::span<const WallDistance> scores) {
  MeanScores result;
  const auto mean = [&](const auto& figure) {
    Mean all;
    for (const WallDistance& score : scores) all.add(figure(score));
    return all.value();
  };
  result.points = mean([](const WallDistance& score) { return double(score.points); });
  for (std::size_t k = 0; k < result.accuracy.size(); ++k)
    result.accuracy[k] = mean([k](const WallDistance& score) { return score.accuracy[k]; });
  result.coverage = mean([](const WallDistance& score) { return score.coverage; });
  result.mean_m = mean([](const WallDistance& score) { return score.mean_m; });
  return result;
}

bool is_consensus(const ComparedMethod& method) {
  return method.method == "consensus";
}

bool is_whole(const ComparedPlace& place) {
  return place.kind != PlaceKind::truncated;
}

}  // namespace

MeanScores mean_scores(std::span<const ComparedMap> maps, Counting counting) {
  std::vector<WallDistance> scores;
  for (const ComparedMap& map : maps) scores.push_back(map.distance.*counting);
  return mean_of(scores);
}

MeanScores mean_scores_against_whole(std::span<const ComparedMap> maps, Counting counting) {
  std::vector<WallDistance> scores;
  for (const ComparedMap& map : maps)
    if (map.against_whole) scores.push_back((*map.against_whole).*counting);
  return mean_of(scores);
}

bool comparable(const MeanScores& a, const MeanScores& b) {
  return a.points >= compared_points && b.points >= compared_points;
}

bool dominates(const MeanScores& a, const MeanScores& b) {
  return comparable(a, b) && a.accuracy[1] - b.accuracy[1] >= clear_margin && a.coverage - b.coverage >= clear_margin;
}

std::vector<Dominance> dominators_of_consensus(const Comparison& comparison) {
  std::vector<Dominance> found;
  for (std::size_t p = 0; p < comparison.places.size(); ++p)
    for (std::size_t worse = 0; worse < comparison.methods.size(); ++worse)
      for (std::size_t better = 0; better < comparison.methods.size(); ++better) {
        if (!is_consensus(comparison.methods[worse]) || is_consensus(comparison.methods[better])) continue;
        const auto& maps = comparison.places[p].maps;
        for (const Counting counting : {every_point, one_per_cell})
          if (dominates(mean_scores(maps[better], counting), mean_scores(maps[worse], counting)))
            found.push_back({p, better, worse, counting});
      }
  return found;
}

std::vector<Duel> duels(const Comparison& comparison, Counting counting) {
  const std::optional<std::size_t> consensus = comparison.find(default_consensus);
  std::vector<Duel> all;
  if (!consensus) return all;
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
    if (is_consensus(comparison.methods[m])) continue;
    Duel duel;
    duel.method = m;
    for (std::size_t p = 0; p < comparison.places.size(); ++p) {
      const MeanScores ours = mean_scores(comparison.places[p].maps[*consensus], counting);
      const MeanScores theirs = mean_scores(comparison.places[p].maps[m], counting);
      if (!comparable(ours, theirs)) continue;
      ++duel.places;
      if (!(ours.accuracy[1] - theirs.accuracy[1] >= clear_margin)) ++duel.not_more_accurate;
      if (!(ours.coverage - theirs.coverage >= clear_margin)) ++duel.not_more_complete;
      if (dominates(ours, theirs))
        ++duel.dominated;
      else
        duel.others.push_back(p);
    }
    all.push_back(std::move(duel));
  }
  return all;
}

std::vector<ClaimedPoint> claims_of(const ComparedPlace& place, std::size_t method) {
  std::vector<ClaimedPoint> claims;
  for (const ComparedMap& map : place.maps[method]) std::ranges::copy(map.claims, std::back_inserter(claims));
  return claims;
}

std::vector<ClaimedPoint> pooled_claims(const Comparison& comparison, std::size_t method, Pool pool) {
  std::vector<ClaimedPoint> claims;
  for (const ComparedPlace& place : comparison.places) {
    const bool wanted = pool == Pool::all || (place.kind == PlaceKind::scene) == (pool == Pool::scenes);
    if (is_whole(place) && wanted) std::ranges::copy(place.maps[method].front().claims, std::back_inserter(claims));
  }
  return claims;
}

std::vector<ClaimedPoint> with_label(std::span<const ClaimedPoint> claims, PointLabel label) {
  std::vector<ClaimedPoint> chosen;
  std::ranges::copy_if(claims, std::back_inserter(chosen),
                       [label](const ClaimedPoint& claim) { return claim.label == label; });
  return chosen;
}

}  // namespace echoarc::studies
