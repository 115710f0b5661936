// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/layers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mapping/consensus/point_finder.hpp"
#include "mapping/consensus/surface_evidence.hpp"
#include "mapping/consensus/validation.hpp"
#include "mapping/consensus/zones.hpp"

namespace echoarc::consensus {
namespace {

/// The elements of the estimates that are good enough, after the vote, where their echoes together speak for a surface.
template <class Good>
std::vector<Element> voted(const ArcTable& arcs, const ConsensusOptions& options,
                           std::span<const EchoEstimate> estimates, std::span<const Vec2> path, Good good) {
  std::vector<Element> elements;
  for (std::size_t i = 0; i < estimates.size(); ++i)
    if (good(arcs[i], estimates[i])) elements.push_back(element_of(arcs, i, estimates[i].t));
  const std::vector<bool> valid = validate(arcs, options, elements, path);
  std::vector<Element> rays;
  for (std::size_t k = 0; k < elements.size(); ++k)
    if (valid[k]) rays.push_back(elements[k]);
  const std::vector<double> evidence = surface_evidence(arcs, options, estimates, rays, positions_of(rays));
  std::vector<Element> kept;
  for (std::size_t k = 0; k < rays.size(); ++k)
    if (evidence[k] >= least_evidence(options)) kept.push_back(rays[k]);
  return kept;
}

/// Calls `put(position, share)` for the points of a link between its ends, `share` of the way along.
template <class Put>
void along_link(const Link& link, std::span<const Element> elements, double step_m, Put put) {
  const Vec2 begin = elements[link.first].position;
  const Vec2 way = elements[link.second].position - begin;
  const double pieces = std::ceil(norm(way) / step_m);
  for (double m = 1.0; m < pieces; ++m) put(begin + (m / pieces) * way, m / pieces);
}

/// The links of step E, but for those between two unsure ends: they are as likely as not two things.
std::vector<Link> sure_links(const ArcTable& arcs, const ConsensusOptions& options,
                             std::span<const EchoEstimate> estimates, std::span<const Element> accepted,
                             std::span<const Look> looks, double gap_m) {
  std::vector<Link> links = find_links(arcs, options, accepted, looks, gap_m);
  const auto p = [&](std::uint32_t element) { return estimates[accepted[element].echo].p; };
  std::erase_if(links, [&](const Link& link) { return std::max(p(link.first), p(link.second)) <= options.link_p; });
  return links;
}

/// Where the map has points: at elements, along links, in zones.
std::vector<Vec2> places_shown(const Layers& layers, const ConsensusOptions& options) {
  std::vector<Vec2> shown = positions_of(layers.accepted);
  for (const Link& link : layers.links)
    along_link(link, layers.accepted, options.link_step_m, [&](Vec2 p, double) { shown.push_back(p); });
  for (const Element& zone : layers.zones) shown.push_back(zone.position);
  return shown;
}

/// Weak elements where the map has nothing within `tolerance_m`.
std::vector<Element> weak_of(const ArcTable& arcs, const ConsensusOptions& options,
                             std::span<const EchoEstimate> estimates, std::span<const Vec2> path,
                             std::span<const Vec2> shown) {
  const PointFinder finder(shown);
  std::vector<Element> weak = voted(arcs, options, estimates, path, [&](const EchoArc& echo, const EchoEstimate& e) {
    return echo.arc.range_m() < options.map_range_m && e.p > options.weak_p;
  });
  std::erase_if(weak, [&](const Element& element) {
    bool covered = false;
    visit_within(shown, finder, element.position, options.tolerance_m, [&](std::size_t) { covered = true; });
    return covered;
  });
  return weak;
}

}  // namespace

Layers build_layers(const ArcTable& arcs, const ConsensusOptions& options, std::span<const EchoEstimate> estimates,
                    std::span<const Vec2> path, std::span<const Look> looks) {
  const bool complete = options.mode == ConsensusMode::complete;
  Layers layers;
  layers.accepted = voted(arcs, options, estimates, path, [&](const EchoArc& echo, const EchoEstimate& estimate) {
    return is_believed(echo, options, estimate);
  });
  layers.links =
      sure_links(arcs, options, estimates, layers.accepted, looks, complete ? options.complete_link_m : options.link_m);
  if (options.mode == ConsensusMode::strict) return layers;
  layers.zones = find_zones(arcs, options, estimates, layers.accepted, places_shown(layers, options),
                            complete ? options.strict_p : options.zone_p);
  if (complete) layers.weak = weak_of(arcs, options, estimates, path, places_shown(layers, options));
  return layers;
}

namespace {

/// Writes layers into a point map.
class LayerWriter {
 public:
  LayerWriter(const ArcTable& arcs, const ConsensusOptions& options, std::span<const EchoEstimate> estimates,
              std::span<const Element> accepted)
      : arcs_(arcs),
        options_(options),
        estimates_(estimates),
        accepted_(accepted),
        positions_(positions_of(accepted)),
        finder_(positions_) {}

  void put(const Element& element, PointLabel label) {
    const EchoArc& echo = arcs_[element.echo];
    const EchoEstimate& estimate = estimates_[element.echo];
    support_.assign(1, echo.source.ping);
    if (label != PointLabel::weak) add_companions(element);
    const double bound_m =
        label == PointLabel::zone ? std::max(estimate.bound_m, options_.zone_bound_m) : estimate.bound_m;
    add(element.position, label, bound_m, element.echo, {-element.normal, estimate.p, false});
  }

  void put(const Link& link) {
    const Element& first = accepted_[link.first];
    const Element& second = accepted_[link.second];
    const std::size_t newer = std::max(first.echo, second.echo);
    support_ = {arcs_[first.echo].source.ping, arcs_[second.echo].source.ping};
    const Vec2 way = second.position - first.position;
    const Vec2 across = perpendicular(way) / norm(way);
    const Vec2 normal = dot(across, first.normal + second.normal) > 0.0 ? -across : across;
    add({first.position, second.position, PointLabel::link}, newer);
    const double p = link_p(link);
    along_link(link, accepted_, options_.link_step_m, [&](Vec2 position, double) {
      add(position, PointLabel::link, options_.link_bound_m, newer, {normal, p, false});
    });
  }

  /// The zone's end as a point, the way there from its echo as a segment.
  void put_zone(const Element& end) {
    put(end, PointLabel::zone);
    const Angle t = estimates_[end.echo].t;
    add({element_of(arcs_, end.echo, t).position, end.position, PointLabel::zone}, end.echo);
  }

  /// Chance that a link's points are right: that of its less certain end, less the longer it is.
  [[nodiscard]] double link_p(const Link& link) const {
    const double ends = std::min(estimate_of(link.first).p, estimate_of(link.second).p);
    const double length_m = norm(accepted_[link.second].position - accepted_[link.first].position);
    return ends * std::exp(-length_m / options_.link_decay_m);
  }

  [[nodiscard]] const EchoEstimate& estimate_of(std::size_t accepted) const {
    return estimates_[accepted_[accepted].echo];
  }

  [[nodiscard]] PointMap take() && { return std::move(map_); }

 private:
  /// The pings of the elements that supported this one in the vote, oldest first; of many the first.
  void add_companions(const Element& element) {
    constexpr std::size_t most = 16;
    companions_.clear();
    visit_within(positions_, finder_, element.position, options_.element_m, [&](std::size_t k) {
      const Element& other = accepted_[k];
      if (other.echo != element.echo && same_side(other, element)) companions_.push_back(arcs_[other.echo].source.ping);
    });
    std::ranges::sort(companions_);
    for (const PingId ping : companions_)
      if (support_.size() < most) support_.push_back(ping);
  }

  void add(MapSegment segment, std::size_t newest) {
    segment.sensor = arcs_[newest].source.sensor;
    segment.ping = arcs_[newest].source.ping;
    map_.add(segment);
  }

  void add(Vec2 position, PointLabel label, double bound_m, std::size_t newest, PointBelief belief) {
    const ArcSource& source = arcs_[newest].source;
    belief.provisional = newest + std::size_t(options_.settle_arcs) >= arcs_.size();
    map_.add({.position = position,
              .label = label,
              .bound_m = bound_m,
              .time_s = source.time_s,
              .sensor = source.sensor,
              .ping = source.ping},
             support_, belief);
  }

  const ArcTable& arcs_;
  const ConsensusOptions& options_;
  std::span<const EchoEstimate> estimates_;
  std::span<const Element> accepted_;
  std::vector<Vec2> positions_;
  PointFinder finder_;
  std::vector<PingId> support_;
  std::vector<PingId> companions_;
  PointMap map_;
};

/// Calls `put` for every item, the most certain first, equals in their order.
template <class Item, class Certainty, class Put>
void most_certain_first(const std::vector<Item>& items, Certainty certainty, Put put) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < items.size(); ++k) order.emplace_back(-certainty(items[k]), k);
  std::ranges::sort(order);
  for (const auto& [less, k] : order) put(items[k]);
}

}  // namespace

PointMap point_map_of(const ArcTable& arcs, const ConsensusOptions& options, std::span<const EchoEstimate> estimates,
                      const Layers& layers) {
  LayerWriter writer(arcs, options, estimates, layers.accepted);
  const auto put = [&](const Element& element) {
    writer.put(element, estimates[element.echo].wall_share > 0.5 ? PointLabel::wall : PointLabel::point);
  };
  most_certain_first(layers.accepted, [&](const Element& element) { return estimates[element.echo].p; }, put);
  most_certain_first(
      layers.links, [&](const Link& link) { return writer.link_p(link); }, [&](const Link& link) { writer.put(link); });
  for (const Element& zone : layers.zones) writer.put_zone(zone);
  for (const Element& element : layers.weak) writer.put(element, PointLabel::weak);
  return std::move(writer).take();
}

}  // namespace echoarc::consensus
