// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/validation.hpp"

#include <cmath>
#include <cstdint>

#include "mapping/consensus/point_finder.hpp"

namespace echoarc::consensus {
namespace {

constexpr double least_facing = 0.2;  // u.n: a ray that grazes a surface proves nothing

/// 1 for every element, 0 for those where the robot has been.
std::vector<double> off_the_path(std::span<const Element> elements, std::span<const Vec2> path, double body_m) {
  const PointFinder finder(path);
  std::vector<double> weights;
  for (const Element& element : elements) {
    bool met = false;
    finder.near(element.position, body_m,
                [&](std::size_t k) { met = met || squared_norm(path[k] - element.position) < body_m * body_m; });
    weights.push_back(met ? 0.0 : 1.0);
  }
  return weights;
}

/// Whether the way of sound from `origin` to the echo `target` goes through the surface at `e`.
bool crosses(Vec2 origin, Vec2 target, const Element& e, const ConsensusOptions& options) {
  const Vec2 way = target - origin;
  const double length_m = norm(way);
  if (length_m <= 0.0) return false;
  const Vec2 u = way / length_m;
  const double before_m = dot(e.position - origin, e.normal);
  const double behind_m = dot(target - e.position, e.normal);
  const double facing = dot(e.normal, u);
  if (before_m <= options.front_m || behind_m <= options.behind_m || facing <= least_facing) return false;
  const Vec2 hit = origin + (before_m / facing) * u;
  return std::abs(cross(hit - e.position, e.normal)) < options.element_m;
}

struct Pair {
  std::uint32_t first, second;
};

/// (ray, element) for all that cross.
std::vector<Pair> crossings(const ArcTable& arcs, const ConsensusOptions& options, std::span<const Element> elements,
                            std::span<const double> weights, const PointFinder& finder) {
  std::vector<Pair> found;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    const Arc& arc = arcs[elements[i].echo].arc;
    const Vec2 target = elements[i].position;
    const std::size_t before = found.size();
    const auto collect = [&](Vec2 origin) {
      finder.along(origin, target, options.element_m, [&](std::size_t e) {
        if (weights[e] > 0.0 && crosses(origin, target, elements[e], options))
          found.push_back({std::uint32_t(i), std::uint32_t(e)});
      });
    };
    collect(arc.receiver());
    if (arc.is_circular()) continue;
    collect(arc.transmitter());  // the other leg; an element that both cross counts once
    const auto by_element = [](const Pair& a, const Pair& b) { return a.second < b.second; };
    const auto begin = found.begin() + std::ptrdiff_t(before);
    std::sort(begin, found.end(), by_element);
    found.erase(std::unique(begin, found.end(), [](const Pair& a, const Pair& b) { return a.second == b.second; }),
                found.end());
  }
  return found;
}

/// Elements of one surface next to one another, each pair once.
std::vector<Pair> companions(const ConsensusOptions& options, std::span<const Element> elements,
                             std::span<const double> weights, const PointFinder& finder) {
  std::vector<Pair> found;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    finder.near(elements[i].position, options.element_m, [&](std::size_t e) {
      const bool near =
          e > i && weights[e] > 0.0 &&
          squared_norm(elements[e].position - elements[i].position) <= options.element_m * options.element_m &&
          same_side(elements[e], elements[i]);
      if (near) found.push_back({std::uint32_t(i), std::uint32_t(e)});
    });
  }
  return found;
}

}  // namespace

std::vector<bool> validate(const ArcTable& arcs, const ConsensusOptions& options, std::span<const Element> elements,
                           std::span<const Vec2> path) {
  const std::vector<double> start = off_the_path(elements, path, options.body_m);
  const std::vector<Vec2> positions = positions_of(elements);
  const PointFinder finder(positions);
  const std::vector<Pair> crossed = crossings(arcs, options, elements, start, finder);
  const std::vector<Pair> beside = companions(options, elements, start, finder);
  std::vector<double> w = start;
  for (int vote = 0; vote < options.votes; ++vote) {
    std::vector<double> support = w;
    std::vector<double> passed(w.size(), 0.0);
    std::vector<double> blocked(w.size(), 0.0);
    for (const auto& [a, b] : beside) {
      support[a] += w[b];
      support[b] += w[a];
    }
    for (const auto& [ray, e] : crossed) passed[e] += w[ray];
    // A surface stands, and blocks, unless far more passes it than supports it. A mirror image behind it has as much
    // support as the wall itself, nearly: to stand, support must not have to outweigh what passes.
    const auto stands = [&](std::size_t e) { return passed[e] <= options.passed_ratio * support[e]; };
    for (const auto& [ray, e] : crossed) blocked[ray] += stands(e) ? w[e] : 0.0;
    const bool last = vote + 1 == options.votes;
    for (std::size_t e = 0; e < w.size(); ++e) {
      const bool voted_out = passed[e] >= options.passed && !stands(e);
      const bool outlier = blocked[e] >= options.blocked && blocked[e] > options.blocked_ratio * support[e];
      const double kept = !outlier && !voted_out ? start[e] : 0.0;
      w[e] = last ? kept : 0.5 * (w[e] + kept);
    }
  }
  std::vector<bool> valid;
  for (const double weight : w) valid.push_back(weight > 0.0);
  return valid;
}

}  // namespace echoarc::consensus
