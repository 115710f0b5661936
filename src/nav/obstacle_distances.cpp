// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/obstacle_distances.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace echoarc::nav {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Seen {
  Vec2 place;
  double distance_m = infinity;
  Angle bearing;
};

/// Sets of numbers that are merged; the representative of a set is the number that `merge` was told to keep.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  [[nodiscard]] std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void merge(std::size_t keep, std::size_t other) { parent_[find(other)] = find(keep); }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<Seen> points_in_reach(std::span<const Vec2> points, Vec2 place, double reach_m) {
  std::vector<Seen> seen;
  for (const Vec2 p : points) {
    const Vec2 way = p - place;
    const double squared = squared_norm(way);
    if (squared > 1e-12 && squared <= reach_m * reach_m)  // false for what is not finite
      seen.push_back({p, std::sqrt(squared), bearing(way)});
  }
  return seen;
}

/// Nearest point of each bin of bearing; infinite where none lies.
std::vector<Seen> distance_profile(std::span<const Seen> seen, Angle bin) {
  const double turn = 2.0 * std::numbers::pi;
  const auto bins = std::size_t(std::lround(turn / bin.rad()));
  std::vector<Seen> profile(bins);
  for (const Seen& s : seen) {
    const auto b = std::size_t((s.bearing.rad() + std::numbers::pi) / turn * double(bins));
    Seen& nearest = profile[std::min(b, bins - 1)];
    if (s.distance_m < nearest.distance_m) nearest = s;
  }
  return profile;
}

/// Fills the empty bins between two neighbours that are linked, along the straight line between them.
void bridge(std::vector<Seen>& profile, Vec2 place, double link_m) {
  const std::size_t bins = profile.size();
  std::vector<std::size_t> filled;
  for (std::size_t b = 0; b < bins; ++b)
    if (profile[b].distance_m < infinity) filled.push_back(b);
  for (std::size_t k = 0; k < filled.size(); ++k) {
    const std::size_t from = filled[k];
    const std::size_t gap = (filled[(k + 1) % filled.size()] + bins - from) % bins;
    const Vec2 start = profile[from].place;
    const Vec2 along = profile[(from + gap) % bins].place - start;
    if (gap < 2 || norm(along) > link_m) continue;
    for (std::size_t step = 1; step < gap; ++step) {
      const Vec2 p = start + (double(step) / double(gap)) * along;
      profile[(from + step) % bins] = {p, norm(p - place), bearing(p - place)};
    }
  }
}

/// Which bins are joined by a chain of points with steps of at most `link_m`.
class Chains {
 public:
  Chains(std::span<const Seen> profile, double link_m) : profile_(profile), link_m_(link_m), sets_(0) {}
  [[nodiscard]] bool joined(std::size_t a, std::size_t b) {
    if (!built_) build();  // seldom asked for
    return sets_.find(a) == sets_.find(b);
  }

 private:
  void build() {
    built_ = true;
    sets_ = DisjointSets(profile_.size());
    const auto near = [&](const Seen& a, const Seen& b) {
      return squared_norm(a.place - b.place) <= link_m_ * link_m_;
    };
    for (std::size_t a = 0; a < profile_.size(); ++a)
      for (std::size_t b = a + 1; b < profile_.size(); ++b)
        if (profile_[a].distance_m < infinity && profile_[b].distance_m < infinity && near(profile_[a], profile_[b]))
          sets_.merge(a, b);
  }
  std::span<const Seen> profile_;
  double link_m_;
  DisjointSets sets_;
  bool built_ = false;
};

/// Minima of the profile that are obstacles of their own, nearest first. Water rises over the profile: a basin that
/// flows over into a deeper one belongs to it, unless it was deep by itself or the two are not linked.
std::vector<std::size_t> separate_minima(std::span<const Seen> profile, const ObstacleOptions& options) {
  const std::size_t bins = profile.size();
  std::vector<std::size_t> order;
  for (std::size_t b = 0; b < bins; ++b)
    if (profile[b].distance_m < infinity) order.push_back(b);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return profile[a].distance_m < profile[b].distance_m; });
  Chains chains(profile, options.link_m);
  DisjointSets basins(bins);
  std::vector<bool> wet(bins, false);
  std::vector<bool> minimum(bins, false);
  for (const std::size_t b : order) {
    wet[b] = minimum[b] = true;
    for (const std::size_t neighbour : {(b + 1) % bins, (b + bins - 1) % bins}) {
      if (!wet[neighbour]) continue;
      std::size_t low = basins.find(neighbour);
      std::size_t high = basins.find(b);
      if (low == high) continue;
      if (profile[high].distance_m < profile[low].distance_m) std::swap(low, high);
      const bool deep = profile[b].distance_m - profile[high].distance_m >= options.rise_m;
      const bool apart =
          high != b && !deep && !chains.joined(low, high);  // a bin on its own only extends its neighbour
      minimum[high] = minimum[high] && (deep || apart);
      basins.merge(low, high);
    }
  }
  std::erase_if(order, [&](std::size_t b) { return !minimum[b]; });
  return order;
}

NearObstacle obstacle_at(const Seen& minimum, std::span<const Seen> seen, Vec2 place, const ObstacleOptions& options) {
  Vec2 sum{};
  int count = 0;
  for (const Seen& s : seen) {
    if (std::abs(s.distance_m - minimum.distance_m) > options.near_m) continue;
    if (abs(wrap(s.bearing - minimum.bearing)) > 0.5 * options.separation) continue;
    sum = sum + s.place;
    ++count;
  }
  const Vec2 closest = count == 0 ? minimum.place : sum / double(count);  // 0: on a bridge between two points
  return {norm(closest - place), closest, bearing(closest - place)};
}

}  // namespace

std::vector<NearObstacle> obstacle_distances(std::span<const Vec2> points, Vec2 place, const ObstacleOptions& options) {
  std::vector<NearObstacle> obstacles;
  if (!is_finite(place)) return obstacles;
  const std::vector<Seen> seen = points_in_reach(points, place, options.reach_m);
  std::vector<Seen> profile = distance_profile(seen, options.bin);
  bridge(profile, place, options.link_m);
  std::vector<Angle> taken;
  for (const std::size_t b : separate_minima(profile, options)) {
    const Angle here = profile[b].bearing;
    const auto too_near = [&](Angle other) { return abs(wrap(other - here)) < options.separation; };
    if (std::any_of(taken.begin(), taken.end(), too_near)) continue;
    taken.push_back(here);
    obstacles.push_back(obstacle_at(profile[b], seen, place, options));
  }
  std::stable_sort(obstacles.begin(), obstacles.end(),
                   [](const NearObstacle& a, const NearObstacle& b) { return a.distance_m < b.distance_m; });
  return obstacles;
}

double clearance_m(std::span<const Vec2> points, Vec2 place) {
  double least = infinity;
  for (const Vec2 p : points) {
    const double squared = squared_norm(p - place);
    if (squared < least) least = squared;  // false for what is not finite
  }
  return std::sqrt(least);
}

}  // namespace echoarc::nav
