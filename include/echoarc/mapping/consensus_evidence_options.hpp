// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <tuple>

#include "echoarc/mapping/consensus_options.hpp"
#include "echoarc/mapping/inverse_sonar_model.hpp"

namespace echoarc {

/// Options of `ConsensusEvidence`: those of a consensus up to its vote, and what a ping adds to the grid.
struct ConsensusEvidenceOptions : ConsensusOptions {
  ConsensusEvidenceOptions() {
    cell_m = 0.05;
    spread_m = 0.10;  // to the centres of cells
  }

  double free_beam = 0.0;
  BeamProfile profile = BeamProfile::gaussian;
  double angular_sigma = 0.5;
  double no_echo_weight = 0.1;
  double free_threshold = 0.35;

  static constexpr auto fields();
};

namespace detail {

constexpr auto consensus_evidence_echo_fields() {
  using O = ConsensusEvidenceOptions;
  return std::tuple{
      field("free_beam", &O::free_beam,
            {.min = 0.0,
             .max = 1.0,
             .doc = "weight of the rest of the beam before the echo: 0: only where the sound went is free, for a wall "
                    "at a slant is silent; 1: all of the beam, as in `evidence`"})};
}

constexpr auto consensus_evidence_grid_fields() {
  using O = ConsensusEvidenceOptions;
  return std::tuple{
      field("profile", &O::profile, {.doc = "how the certainty of silence falls from the beam's axis to its edge"}),
      field("angular_sigma", &O::angular_sigma,
            {.min = 0.05, .max = 10.0, .doc = "standard deviation of the gaussian profile, in half beam widths"}),
      field(
          "no_echo_weight", &O::no_echo_weight,
          {.min = 0.0,
           .max = 1.0,
           .doc = "weight of silence against that of an echo when it clears, up to the sensor's trusted range: a wall "
                  "at a slant is silent, and of all directions a wall may have few are not"}),
      field("free_threshold", &O::free_threshold,
            {.min = 0.0, .max = 0.5, .doc = "a cell is free when p does not exceed this"})};
}

/// Fields of a base as fields of `Options`, so that their defaults are those of `Options`.
template <class Options, class... Base, class... T>
constexpr auto inherited(const std::tuple<Field<Base, T>...>& fields) {
  return std::apply([](const auto&... f) { return std::tuple{Field<Options, T>{f.name, f.member, f.info}...}; },
                    fields);
}

}  // namespace detail

constexpr auto ConsensusEvidenceOptions::fields() {
  using O = ConsensusEvidenceOptions;
  return std::tuple_cat(
      detail::consensus_evidence_echo_fields(), detail::consensus_evidence_grid_fields(),
      detail::inherited<O>(std::tuple_cat(detail::consensus_beam_fields(), detail::consensus_neighbour_fields(),
                                          detail::consensus_reading_fields(), detail::consensus_vote_fields(),
                                          detail::consensus_surface_fields(), arc_fields<O>(), grid_fields<O>())));
}

}  // namespace echoarc
