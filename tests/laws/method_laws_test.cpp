// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "laws/method_laws.hpp"

#include "echoarc/mapping/atm.hpp"
#include "echoarc/mapping/bayes_update.hpp"
#include "echoarc/mapping/carve.hpp"
#include "echoarc/mapping/carved_grid.hpp"
#include "echoarc/mapping/centerline.hpp"
#include "echoarc/mapping/combined.hpp"
#include "echoarc/mapping/consensus.hpp"
#include "echoarc/mapping/consensus_evidence.hpp"
#include "echoarc/mapping/directional_maximum.hpp"
#include "echoarc/mapping/evidence_grid.hpp"
#include "echoarc/mapping/himm.hpp"
#include "echoarc/mapping/limited_grid.hpp"
#include "echoarc/mapping/morphological_processing.hpp"
#include "echoarc/mapping/numakura.hpp"
#include "echoarc/mapping/triangulation_fusion.hpp"
#include "echoarc/mapping/voting.hpp"

namespace echoarc::laws {

template <>
struct LawException<BayesUpdate> {
  static constexpr std::string_view needs_baseline = "";
  static constexpr std::string_view cannot_recover =
      "[Barshan07] eqs. 7 and 8 only ever raise p_E and p_O: a cell that many echoes have passed keeps p_E = 1, and "
      "p_O = 1 lifts its value to 1/2 at most";
};

template <>
struct LawException<TriangulationFusion> {
  static constexpr std::string_view cannot_recover = "";
  static constexpr std::string_view needs_baseline =
      "[Barshan07] 3.7: points come out of triangles, and those need two positions of the sensor";
};

/// Round and round a pole: every reading meets all others of the window, at ten points.
template <>
std::vector<Reading> filling_readings<TriangulationFusion>() {
  std::vector<Reading> readings;
  for (int k = 0; k < 16000; ++k) {
    const Angle heading = degrees(6.0 * k);
    readings.push_back(test::monostatic_reading({-0.5 * unit(heading), heading}, Echo{0.5}));
    readings.back().ping = PingId(k);
  }
  return readings;
}

template <>
struct LawException<AtmMod> {
  static constexpr std::string_view cannot_recover = "";
  static constexpr std::string_view needs_baseline =
      "[Barshan07] 3.6: an arc that no other crosses is left out, and arcs from one position do not cross";
};

template <>
struct LawException<Consensus> {
  static constexpr std::string_view cannot_recover = "";
  static constexpr std::string_view needs_baseline =
      "an arc that no other supports is not shown, and equal readings are one arc";
};

template <>
struct LawException<ConsensusEvidence> {
  static constexpr std::string_view cannot_recover = "";
  static constexpr std::string_view needs_baseline =
      "an arc that no other supports is not believed, and equal readings are one arc";
};

/// A lone arc, of which the suite makes much, is a line: its cells have two neighbours or three.
template <>
MorphologicalOptions law_options<MorphologicalProcessing>() {
  return {.cell_m = 0.02, .neighbours = 2, .passes = 2};
}

namespace {

ECHOARC_METHOD_LAWS(Consensus);
ECHOARC_METHOD_LAWS(ConsensusEvidence);
ECHOARC_METHOD_LAWS(Centerline);
ECHOARC_METHOD_LAWS(Voting);
ECHOARC_METHOD_LAWS(DirectionalMaximum);
ECHOARC_METHOD_LAWS(MorphologicalProcessing);
ECHOARC_METHOD_LAWS(BayesUpdate);
ECHOARC_METHOD_LAWS(EvidenceGrid);
ECHOARC_METHOD_LAWS(Himm);
ECHOARC_METHOD_LAWS(Numakura);
ECHOARC_METHOD_LAWS(LimitedGrid);
ECHOARC_METHOD_LAWS(AtmOrg);
ECHOARC_METHOD_LAWS(AtmMod);
ECHOARC_METHOD_LAWS(AtmSilver);
ECHOARC_METHOD_LAWS(Carve);
ECHOARC_METHOD_LAWS(Combined);
ECHOARC_METHOD_LAWS(CarvedGrid);

/// The other mode of the carved grid.
struct DeferredOptions : CarvedGridOptions {
  DeferredOptions() { mode = CarvedGridMode::deferred; }
};
class DeferredCarvedGrid : public CarvedGrid {
 public:
  using Options = DeferredOptions;
  explicit DeferredCarvedGrid(const Options& options = {}) : CarvedGrid(options) {}
  [[nodiscard]] static Result<DeferredCarvedGrid> restore(std::span<const std::byte> bytes) {
    auto grid = CarvedGrid::restore(bytes);
    if (!grid) return grid.error();
    return DeferredCarvedGrid(std::move(*grid));
  }

 private:
  explicit DeferredCarvedGrid(CarvedGrid&& grid) : CarvedGrid(std::move(grid)) {}
};
ECHOARC_METHOD_LAWS(DeferredCarvedGrid);
ECHOARC_METHOD_LAWS(TriangulationFusion);

/// `axis` is left out: its direction is fixed in the world.
TEST(DirectionalMaximumLaws, EveryDirectionOfInterestMovesWithTheWorld) {
  using D = DirectionOfInterest;
  for (const D doi : {D::los, D::path_normal, D::followed_wall, D::pca, D::polar}) {
    DirectionalMaximumOptions options = law_options<DirectionalMaximum>();
    options.threshold = 2;
    options.doi = doi;
    options.polar_step = degrees(1.0);
    options.polar_spacing_m = 0.2;
    SCOPED_TRACE(int(doi));
    Rng rng(9);
    expect_equivariant<DirectionalMaximum>(options, test::wall_drive(rng, 20));
  }
}

}  // namespace
}  // namespace echoarc::laws
