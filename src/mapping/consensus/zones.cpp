// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/zones.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mapping/consensus/point_finder.hpp"
#include "mapping/consensus/surface_evidence.hpp"

namespace echoarc::consensus {
namespace {

/// The element moved by `along_m` to its left: a wall goes on along its tangent; where a corner or a pole stands on its
/// arc is less certain.
Element moved(const ArcTable& arcs, const EchoEstimate& estimate, const Element& element, double along_m) {
  if (estimate.wall_share > 0.5)
    return {element.echo, element.position + along_m * perpendicular(element.normal), element.normal};
  return element_of(arcs, element.echo, estimate.t + radians(along_m / arcs[element.echo].arc.range_m()));
}

std::vector<Element> candidates(const ArcTable& arcs, const ConsensusOptions& options,
                                std::span<const EchoEstimate> estimates, std::span<const Element> elements,
                                double least_p) {
  std::vector<Element> found;
  for (const Element& element : elements) {
    const EchoEstimate& estimate = estimates[element.echo];
    if (estimate.p <= least_p) continue;
    const double radius_m = std::sqrt(0.5 * options.wavelength_m * arcs[element.echo].arc.range_m());
    for (const double side : {1.0, -1.0})
      found.push_back(moved(arcs, estimate, element, side * options.zone * radius_m));
  }
  return found;
}

}  // namespace

std::vector<Element> find_zones(const ArcTable& arcs, const ConsensusOptions& options,
                                std::span<const EchoEstimate> estimates, std::span<const Element> elements,
                                std::span<const Vec2> shown, double least_p) {
  if (options.zone <= 0.0) return {};
  std::vector<Element> open = candidates(arcs, options, estimates, elements, least_p);
  const PointFinder shown_finder(shown);
  std::erase_if(open, [&](const Element& zone) {
    bool crowded = false;
    visit_within(shown, shown_finder, zone.position, options.link_step_m, [&](std::size_t) { crowded = true; });
    return crowded;
  });
  const std::vector<Vec2> places = positions_of(open);
  const std::vector<double> evidence = surface_evidence(arcs, options, estimates, elements, places);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (evidence[k] >= least_evidence(options)) order.emplace_back(-evidence[k], k);
  std::ranges::sort(order);
  const PointFinder finder(places);
  std::vector<bool> taken(places.size(), false);
  std::vector<Element> zones;
  for (const auto& [less, k] : order) {
    if (taken[k]) continue;
    zones.push_back(open[k]);
    visit_within(places, finder, places[k], options.link_step_m, [&](std::size_t m) { taken[m] = true; });
  }
  return zones;
}

}  // namespace echoarc::consensus
