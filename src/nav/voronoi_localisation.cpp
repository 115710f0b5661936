// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_localisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <utility>

namespace echoarc::nav {
namespace {

/// The way at the far end of the edge that leaves a node by `way`, and that end.
struct FarEnd {
  int node = 0;
  std::size_t way = 0;
  const VoronoiEdge* edge = nullptr;
};

std::optional<FarEnd> far_end(const VoronoiGraph& graph, int node, std::size_t way) {
  const VoronoiNode& here = graph.nodes()[std::size_t(node)];
  if (!here.ways[way].edge) return {};
  const VoronoiEdge& edge = graph.edges()[std::size_t(*here.ways[way].edge)];
  const int far = edge.from == node ? edge.to : edge.from;
  const std::vector<VoronoiWay>& ways = graph.nodes()[std::size_t(far)].ways;
  for (std::size_t w = 0; w < ways.size(); ++w)
    if (ways[w].edge == edge.id && !(far == node && w == way)) return FarEnd{far, w, &edge};
  return {};
}

}  // namespace

VoronoiLocaliser::VoronoiLocaliser(const VoronoiGraph& graph, const VoronoiLocalisationOptions& options)
    : graph_(&graph), options_(options) {}

/// Every way too many or too few is an error by itself.
double VoronoiLocaliser::degree_likelihood(int node, int degree) const {
  const int errors = std::abs(graph_->nodes()[std::size_t(node)].degree() - degree);
  return (1.0 - options_.degree_error) * std::pow(options_.degree_error, errors);
}

double VoronoiLocaliser::turn_likelihood(const State& from, std::size_t way, const VoronoiLeg& leg) const {
  const int ways = graph_->nodes()[std::size_t(from.node)].degree();
  // Without a count any way may have been taken, the one come by seldom.
  if (!leg.turned_by || !from.way || ways < 2) return 1.0 / double(std::max(1, ways));
  const int turned_by = ((int(way) - int(*from.way)) % ways + ways) % ways;
  const int counted = (*leg.turned_by % ways + ways) % ways;
  return turned_by == counted ? 1.0 - options_.turn_error : options_.turn_error / double(ways - 1);
}

void VoronoiLocaliser::begin(int degree) {
  states_.clear();
  worst_fit_ = 1.0;
  for (const VoronoiNode& node : graph_->nodes())
    states_.push_back({node.id, {}, degree_likelihood(node.id, degree) / double(graph_->nodes().size())});
  normalise();
}

void VoronoiLocaliser::drive(const VoronoiLeg& leg) {
  std::map<std::pair<int, std::size_t>, double> reached;
  for (const State& state : states_) {
    for (std::size_t way = 0; way < graph_->nodes()[std::size_t(state.node)].ways.size(); ++way) {
      const std::optional<FarEnd> end = far_end(*graph_, state.node, way);
      if (!end) continue;
      const double deviation_m = options_.length_deviation_m + options_.length_deviation_share * end->edge->length_m;
      const double off = (leg.length_m - end->edge->length_m) / deviation_m;
      const double likelihood =
          std::exp(-0.5 * off * off) * turn_likelihood(state, way, leg) * degree_likelihood(end->node, leg.degree);
      if (likelihood > 0.0) reached[{end->node, end->way}] += state.weight * likelihood;  // false for no number
    }
  }
  states_.clear();
  for (const auto& [key, weight] : reached) states_.push_back({key.first, key.second, weight});
  normalise();
}

void VoronoiLocaliser::normalise() {
  double sum = 0.0;
  for (const State& state : states_) sum += state.weight;
  worst_fit_ = sum > 0.0 ? std::min(worst_fit_, sum) : 0.0;
  if (!(sum > 0.0)) states_.clear();
  for (State& state : states_) state.weight /= sum;
}

VoronoiPlace VoronoiLocaliser::place() const {
  VoronoiPlace place;
  if (states_.empty() || worst_fit_ < options_.fit) {
    place.reason = graph_->nodes().empty() ? "the graph is empty" : "no part of the graph fits what was driven";
    return place;
  }
  for (const State& state : states_) {
    VoronoiCandidate candidate{state.node, {}, state.weight};
    if (state.way) candidate.edge = graph_->nodes()[std::size_t(state.node)].ways[*state.way].edge;
    place.candidates.push_back(candidate);
  }
  std::stable_sort(place.candidates.begin(), place.candidates.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  const bool sure = place.candidates.front().probability >= options_.sure;
  place.verdict = sure ? VoronoiVerdict::sure : VoronoiVerdict::ambiguous;
  const auto likely = std::count_if(place.candidates.begin(), place.candidates.end(), [&](const auto& c) {
    return c.probability >= 0.1 * place.candidates.front().probability;
  });
  place.reason = sure          ? "one place fits"
                 : likely == 1 ? "ambiguous: one place fits best, but not by far"
                               : "ambiguous: " + std::to_string(likely) + " places fit about as well";
  return place;
}

}  // namespace echoarc::nav
