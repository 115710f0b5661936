// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/voronoi_graph.hpp"

namespace echoarc::nav {

struct VoronoiLocalisationOptions {
  double length_deviation_m = 0.10;
  double length_deviation_share = 0.02;
  double degree_error = 0.1;
  double turn_error = 0.1;
  double sure = 0.9;
  double fit = 1e-4;

  static constexpr auto fields() {
    using O = VoronoiLocalisationOptions;
    return std::tuple{
        field("length_deviation_m", &O::length_deviation_m,
              {.unit = "m", .min = 0.001, .max = 10.0, .doc = "standard deviation of a driven edge's length"}),
        field("length_deviation_share", &O::length_deviation_share,
              {.min = 0.0, .max = 1.0, .doc = "and so much of its length besides"}),
        field("degree_error", &O::degree_error,
              {.min = 1e-6, .max = 0.5, .doc = "probability that a way out of a node is overlooked or imagined"}),
        field("turn_error", &O::turn_error,
              {.min = 1e-6, .max = 0.5, .doc = "probability that ways were miscounted between coming and leaving"}),
        field("sure", &O::sure, {.min = 0.5, .max = 1.0, .doc = "probability from which one place is believed"}),
        field("fit", &O::fit,
              {.min = 0.0, .max = 0.1, .doc = "likelihood of a single step below which no place fits at all"})};
  }
};

/// What was driven: from one node over an edge to the next.
struct VoronoiLeg {
  double length_m = 0.0;         ///< of the edge
  int degree = 0;                ///< of the node at its end
  std::optional<int> turned_by;  ///< ways counter-clockwise from the one come by to the one left by, at its begin
};

enum class VoronoiVerdict {
  nowhere,    ///< nothing of the graph fits
  ambiguous,  ///< several places fit
  sure
};

/// A place that the driven sequence may have ended at.
struct VoronoiCandidate {
  int node = 0;
  std::optional<int> edge;  ///< over which it was reached
  double probability = 0.0;
};

struct VoronoiPlace {
  VoronoiVerdict verdict = VoronoiVerdict::nowhere;
  std::vector<VoronoiCandidate> candidates;  ///< most probable first, their probabilities sum to 1
  std::string reason;                        ///< for people
};

/// Finds where on a known graph a robot is from the degrees of the nodes it came through and the lengths of the edges
/// between them, [Silver04] 4 and [Choset03] V: a hidden Markov model over nodes and the ways they were reached by.
/// Before the first node every place is as probable as any other.
class VoronoiLocaliser {
 public:
  /// The graph must outlive the localiser and not change.
  explicit VoronoiLocaliser(const VoronoiGraph& graph, const VoronoiLocalisationOptions& options = {});

  void begin(int degree);  ///< forgets all; at a node of so many ways
  void drive(const VoronoiLeg& leg);
  [[nodiscard]] VoronoiPlace place() const;

 private:
  struct State {
    int node = 0;
    std::optional<std::size_t> way;  // reached by
    double weight = 0.0;
  };
  [[nodiscard]] double degree_likelihood(int node, int degree) const;
  [[nodiscard]] double turn_likelihood(const State& from, std::size_t way, const VoronoiLeg& leg) const;
  void normalise();

  const VoronoiGraph* graph_;
  VoronoiLocalisationOptions options_;
  std::vector<State> states_;
  double worst_fit_ = 1.0;  // likelihood of the step that fitted least, given those before it
};

}  // namespace echoarc::nav
