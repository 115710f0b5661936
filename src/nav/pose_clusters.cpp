// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numeric>

#include "echoarc/nav/particle_filter.hpp"
#include "nav/pose_bins.hpp"

namespace echoarc::nav {
namespace {

struct Bin {
  PoseBin key;
  double weight = 0.0;
  std::size_t group = 0;  // index of a bin of the same cluster; its own for one of them
};

/// Bins that hold enough weight, in order of their keys.
std::vector<Bin> heavy_bins(std::vector<std::pair<PoseBin, std::size_t>>& keyed, std::span<const Particle> particles,
                            double least_share) {
  std::sort(keyed.begin(), keyed.end());
  std::vector<Bin> bins;
  for (const auto& [key, n] : keyed) {
    if (bins.empty() || bins.back().key != key) {
      if (!bins.empty() && bins.back().weight < least_share) bins.pop_back();
      bins.push_back({key, 0.0, 0});
    }
    bins.back().weight += particles[n].weight;
  }
  if (!bins.empty() && bins.back().weight < least_share) bins.pop_back();
  return bins;
}

std::size_t find(const std::vector<Bin>& bins, const PoseBin& key) {
  const auto found =
      std::lower_bound(bins.begin(), bins.end(), key, [](const Bin& b, const PoseBin& k) { return b.key < k; });
  return found != bins.end() && found->key == key ? static_cast<std::size_t>(found - bins.begin()) : bins.size();
}

std::size_t root_of(std::vector<Bin>& bins, std::size_t n) {
  while (bins[n].group != n) n = bins[n].group = bins[bins[n].group].group;
  return n;
}

void join_neighbours(std::vector<Bin>& bins, std::int32_t headings) {
  for (std::size_t n = 0; n < bins.size(); ++n) bins[n].group = n;
  for (std::size_t n = 0; n < bins.size(); ++n)
    for (std::int32_t k = 0; k < 27; ++k) {
      const PoseBin& here = bins[n].key;
      const PoseBin there{here.i + k % 3 - 1, here.j + k / 3 % 3 - 1, (here.heading + k / 9 - 1 + headings) % headings};
      const std::size_t other = find(bins, there);
      if (other < bins.size()) bins[root_of(bins, other)].group = root_of(bins, n);
    }
}

}  // namespace

PoseCluster moments_of(std::span<const Particle> particles) {
  PoseCluster sum;
  Vec2 direction;
  for (const Particle& p : particles) {
    sum.share += p.weight;
    sum.T_map_robot.position = sum.T_map_robot.position + p.weight * p.T_map_robot.position;
    direction = direction + p.weight * unit(p.T_map_robot.heading);
  }
  if (!(sum.share > 0.0)) return {};
  sum.T_map_robot = {sum.T_map_robot.position / sum.share, bearing(direction)};
  PoseCovariance& c = sum.covariance;
  for (const Particle& p : particles) {
    const double w = p.weight / sum.share;
    const Vec2 d = p.T_map_robot.position - sum.T_map_robot.position;
    const double turn = wrap(p.T_map_robot.heading - sum.T_map_robot.heading).rad();
    c.xx_m2 += w * d.x * d.x;
    c.xy_m2 += w * d.x * d.y;
    c.yy_m2 += w * d.y * d.y;
    c.x_heading_m += w * d.x * turn;
    c.y_heading_m += w * d.y * turn;
    c.heading_rad2 += w * turn * turn;
  }
  return sum;
}

Sketch::Spread spread_of(const PoseCluster& cluster) {
  const PoseCovariance& c = cluster.covariance;
  const double mean = 0.5 * (c.xx_m2 + c.yy_m2);
  const double half = 0.5 * (c.xx_m2 - c.yy_m2);
  const double radius = std::hypot(half, c.xy_m2);
  return {.T_world_axes = {cluster.T_map_robot.position, radians(0.5 * std::atan2(c.xy_m2, half))},
          .deviation_m = {std::sqrt(std::max(0.0, mean + radius)), std::sqrt(std::max(0.0, mean - radius))}};
}

std::vector<PoseCluster> clusters_of(std::span<const Particle> particles, double bin_m, Angle bin_turn,
                                     double least_share) {
  std::vector<std::pair<PoseBin, std::size_t>> keyed;
  keyed.reserve(particles.size());
  for (std::size_t n = 0; n < particles.size(); ++n)
    keyed.emplace_back(bin_of(particles[n].T_map_robot, bin_m, bin_turn), n);
  std::vector<Bin> bins = heavy_bins(keyed, particles, least_share);
  join_neighbours(bins, headings_of(bin_turn));
  std::vector<std::vector<Particle>> members(bins.size());
  for (const auto& [key, n] : keyed) {
    const std::size_t bin = find(bins, key);
    if (bin < bins.size()) members[root_of(bins, bin)].push_back(particles[n]);
  }
  std::vector<PoseCluster> clusters;
  for (const std::vector<Particle>& group : members)
    if (!group.empty()) clusters.push_back(moments_of(group));
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const PoseCluster& a, const PoseCluster& b) { return a.share > b.share; });
  return clusters;
}

}  // namespace echoarc::nav
