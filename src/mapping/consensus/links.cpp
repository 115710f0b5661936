// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/links.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mapping/consensus/point_finder.hpp"

namespace echoarc::consensus {
namespace {

struct Candidate {
  std::size_t element = 0;
  double squared_m2 = 0.0;  // of its distance
};

/// The nearest element to either side of the tangent of element `i`.
std::array<std::optional<Candidate>, 2> nearest_beside(std::span<const Element> elements, std::size_t i, double least_m,
                                                       double gap_m, const PointFinder& finder) {
  std::array<std::optional<Candidate>, 2> nearest;
  const Element& own = elements[i];
  finder.near(own.position, gap_m, [&](std::size_t k) {
    const Vec2 apart = elements[k].position - own.position;
    const double squared_m2 = squared_norm(apart);
    const double along_m = cross(own.normal, apart);
    if (squared_m2 <= least_m * least_m || squared_m2 > gap_m * gap_m || along_m == 0.0) return;
    auto& side = nearest[along_m > 0.0 ? 0 : 1];
    const bool nearer = !side || squared_m2 < side->squared_m2 || (squared_m2 == side->squared_m2 && k < side->element);
    if (nearer) side = Candidate{k, squared_m2};
  });
  return nearest;
}

std::vector<Link> candidates(std::span<const Element> elements, double least_m, double gap_m,
                             const PointFinder& finder) {
  std::vector<Link> links;
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const auto& other : nearest_beside(elements, i, least_m, gap_m, finder))
      if (other)
        links.push_back({std::uint32_t(std::min(i, other->element)), std::uint32_t(std::max(i, other->element))});
  const auto in_order = [](const Link& a, const Link& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  std::ranges::sort(links, in_order);
  links.erase(std::ranges::unique(links).begin(), links.end());
  return links;
}

/// Whether two segments meet inside both.
bool meet(Vec2 a, Vec2 a_to, Vec2 b, Vec2 b_to) {
  const double den = cross(b_to, a_to);
  if (den == 0.0) return false;
  const double along_b = cross(a - b, a_to) / den;
  const double along_a = cross(a - b, b_to) / den;
  return along_a > 0.0 && along_a < 1.0 && along_b > 0.0 && along_b < 1.0;
}

std::vector<Vec2> middles_of(std::span<const Element> elements, std::span<const Link> links) {
  std::vector<Vec2> middles;
  for (const Link& link : links)
    middles.push_back(0.5 * (elements[link.first].position + elements[link.second].position));
  return middles;
}

/// How many rays go through each gap; their last piece does not count, nor do short ones.
std::vector<int> crossings(const ArcTable& arcs, const ConsensusOptions& options, std::span<const Element> elements,
                           std::span<const Link> links, double gap_m) {
  const PointFinder finder(middles_of(elements, links));
  std::vector<int> counts(links.size(), 0);
  for (const Element& element : elements) {
    const Arc& arc = arcs[element.echo].arc;
    if (arc.range_m() < options.link_ray_m) continue;
    const Vec2 origin = arc.receiver();
    const Vec2 way = (1.0 - options.link_ray_end_m / arc.range_m()) * (element.position - origin);
    finder.along(origin, origin + way, 0.5 * gap_m, [&](std::size_t k) {
      const Vec2 begin = elements[links[k].first].position;
      counts[k] += meet(origin, way, begin, elements[links[k].second].position - begin) ? 1 : 0;
    });
  }
  return counts;
}

/// What a look says of a wall from `begin` along `way`: -1 that it would have heard it, 1 that it did, 0 nothing. Sound
/// comes back from where it meets the wall at a right angle.
int testimony(const Look& look, Vec2 begin, Vec2 way, const ConsensusOptions& options) {
  const double length_m = norm(way);
  const Vec2 along = way / length_m;
  const Vec2 from_begin = look.origin - begin;
  const double foot_m = dot(from_begin, along);
  const double distance_m = std::abs(cross(along, from_begin));
  // Nearer to an end, the first Fresnel zone reaches beyond it.
  const double zone_m = std::sqrt(0.5 * options.wavelength_m * distance_m);
  if (foot_m < zone_m || foot_m > length_m - zone_m) return 0;
  const Vec2 to_foot = begin + foot_m * along - look.origin;
  if (distance_m <= options.front_m || dot(to_foot, look.axis) < distance_m * cos(options.facing_angle)) return 0;
  if (look.range_m > distance_m + options.free_margin_m) return -1;
  return look.range_m >= distance_m - options.free_margin_m ? 1 : 0;
}

/// By link: whether looks deny it.
std::vector<bool> denied(const ConsensusOptions& options, std::span<const Element> elements,
                         std::span<const Look> looks, std::span<const Link> links, double gap_m) {
  const PointFinder finder(middles_of(elements, links));
  std::vector<int> misses(links.size(), 0);
  std::vector<int> hits(links.size(), 0);
  for (const Look& look : looks) {
    const Vec2 target = look.origin + std::min(look.range_m, options.map_range_m) * look.axis;
    finder.along(look.origin, target, gap_m, [&](std::size_t k) {
      const Vec2 begin = elements[links[k].first].position;
      const int said = testimony(look, begin, elements[links[k].second].position - begin, options);
      misses[k] += said < 0 ? 1 : 0;
      hits[k] += said > 0 ? 1 : 0;
    });
  }
  std::vector<bool> denied;
  for (std::size_t k = 0; k < links.size(); ++k)
    denied.push_back(misses[k] >= options.link_misses && misses[k] > options.passed_ratio * hits[k]);
  return denied;
}

}  // namespace

std::vector<Link> find_links(const ArcTable& arcs, const ConsensusOptions& options, std::span<const Element> elements,
                             std::span<const Look> looks, double gap_m) {
  if (gap_m <= 0.0) return {};
  const std::vector<Vec2> positions = positions_of(elements);
  const PointFinder finder(positions);
  const std::vector<Link> links = candidates(elements, options.link_step_m, gap_m, finder);
  const std::vector<int> crossed = crossings(arcs, options, elements, links, gap_m);
  const std::vector<bool> missed = denied(options, elements, looks, links, gap_m);
  std::vector<Link> kept;
  for (std::size_t k = 0; k < links.size(); ++k)
    if (crossed[k] < options.link_crossings && !missed[k]) kept.push_back(links[k]);
  return kept;
}

}  // namespace echoarc::consensus
