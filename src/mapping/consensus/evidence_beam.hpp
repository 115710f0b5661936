// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/mapping/consensus_evidence_options.hpp"
#include "echoarc/maps/sector_raster.hpp"
#include "echoarc/maps/tiled_grid.hpp"
#include "mapping/consensus/arc_table.hpp"
#include "mapping/consensus/posterior.hpp"

namespace echoarc::consensus {

/// What a ping says of the cells before and around its echo, by their bearing from the arc's centre.
struct EvidenceBeam {
  Arc rim;                       ///< farthest and widest it speaks of
  double near_m = 0.0;           ///< nearer it says nothing
  double free_to_m = 0.0;        ///< half the path to what may be occupied
  std::optional<double> echo_m;  ///< none of a silence
  double band_sigma_m = 0.0;
  std::vector<double> edges;             ///< sines of the bearings between bins, rising, ends included
  std::vector<std::int16_t> free_units;  ///< by bin: what a cell before the band gains
  std::vector<double> amplitudes;        ///< by bin: p - 1/2 of a cell at the range
};

/// Both hypotheses of a posterior mixed, by bin: W = p_w Q_W + (1 - p_w) Q_P.
[[nodiscard]] std::vector<float> mixture(const Posterior& posterior);

/// The posterior's mass within `spread_m` of each bin's point, along the arc.
[[nodiscard]] std::vector<double> spread(std::span<const float> posterior, const EchoArc& echo,
                                         const ConsensusEvidenceOptions& options);

/// Widest and farthest that an echo can speak of; none where its ellipse has no such arc.
[[nodiscard]] std::optional<Arc> rim_of(const EchoArc& echo, const BeamBins& bins,
                                        const ConsensusEvidenceOptions& options);

/// What an echo says whose bearing has this posterior (W of step C, by bin). Requires `rim_of(...)`.
[[nodiscard]] EvidenceBeam echo_beam(const EchoArc& echo, const BeamBins& bins, std::span<const float> posterior,
                                     double near_m, const ConsensusEvidenceOptions& options);

/// What a reading without echo says; none where it clears nothing.
[[nodiscard]] std::optional<EvidenceBeam> silence_beam(const Reading& reading, const ConsensusEvidenceOptions& options);

/// Change of one cell, in units of `log_odds_unit`; 0 where the ping says nothing.
[[nodiscard]] int increment(const EvidenceBeam& beam, Vec2 cell_centre);

/// A cell's value in the range of the clamp.
[[nodiscard]] std::int16_t saturated(int units);

/// Adds the ping to the cells of a grid that has all tiles under the rim.
void apply(const EvidenceBeam& beam, SectorRaster& raster, TiledGrid<std::int16_t>& grid);

}  // namespace echoarc::consensus
