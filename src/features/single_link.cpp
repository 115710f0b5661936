// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "echoarc/features/cluster_lines.hpp"

namespace echoarc {
namespace {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  /// The smaller root stays, so that a cluster's root is its first point.
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

using Bucket = std::vector<std::size_t>;
using Buckets = std::map<std::pair<std::int64_t, std::int64_t>, Bucket>;

/// Joins two buckets at the first pair that is close enough; then they are one cluster.
void join_buckets(const Bucket& a, const Bucket& b, std::span<const Vec2> points, double link_m, DisjointSets& sets) {
  if (sets.root(a.front()) == sets.root(b.front())) return;
  for (const std::size_t p : a)
    for (const std::size_t q : b)
      if (squared_norm(points[p] - points[q]) <= link_m * link_m) return sets.join(p, q);
}

}  // namespace

std::vector<std::size_t> single_link_clusters(std::span<const Vec2> points, double link_m) {
  // Buckets so small that all points of one are linked: within a bucket no pair is looked at.
  const double bucket_m = link_m * 0.7;
  constexpr std::int64_t reach = 2;
  DisjointSets sets(points.size());
  Buckets buckets;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto i = static_cast<std::int64_t>(std::floor(points[k].x / bucket_m));
    const auto j = static_cast<std::int64_t>(std::floor(points[k].y / bucket_m));
    Bucket& bucket = buckets[{i, j}];
    bucket.push_back(k);
    sets.join(bucket.front(), k);
  }
  for (const auto& [place, bucket] : buckets)
    for (std::int64_t i = 0; i <= reach; ++i)
      for (std::int64_t j = i == 0 ? 1 : -reach; j <= reach; ++j)
        if (const auto near = buckets.find({place.first + i, place.second + j}); near != buckets.end())
          join_buckets(bucket, near->second, points, link_m, sets);
  std::vector<std::size_t> cluster(points.size());
  std::size_t count = 0;
  for (std::size_t k = 0; k < points.size(); ++k) cluster[k] = sets.root(k) == k ? count++ : cluster[sets.root(k)];
  return cluster;
}

}  // namespace echoarc
