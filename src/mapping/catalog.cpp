// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/catalog.hpp"

#include <algorithm>
#include <array>
#include <string>

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

namespace echoarc {
namespace {

template <MappingMethod M>
Result<AnyMethod> make(const OptionMap& values) {
  auto options = make_options<typename M::Options>(values);
  if (!options) return options.error();
  return AnyMethod(M(*options));
}

template <MappingMethod M>
Result<AnyMethod> restore(std::span<const std::byte> bytes) {
  auto method = M::restore(bytes);
  if (!method) return method.error();
  return AnyMethod(std::move(*method));
}

template <MappingMethod M>
constexpr MethodEntry entry(std::string_view title, std::string_view summary, std::string_view source) {
  return {M::name, title, summary, source, option_specs<typename M::Options>, make<M>, restore<M>};
}

constexpr std::array methods{
    entry<Centerline>("Point marking (centerline)",
                      "One point per echo, in the middle of its arc: the baseline, fast and crude.",
                      "[Barshan07] 3.1; [Silver04] 2.A; [Choset03] II-A"),
    entry<Voting>("Voting and thresholding", "Counts the arcs through each cell and keeps cells with enough of them.",
                  "[Barshan07] 3.2"),
    entry<DirectionalMaximum>(
        "Directional maximum",
        "Of the arc counts along each direction of interest keeps the largest: thin walls from many arcs.",
        "[Barshan07] 3.3"),
    entry<MorphologicalProcessing>("Morphological processing",
                                   "Drops cells of the arc map with too few set neighbours: thick walls, few gaps.",
                                   "[Barshan07] 3.4"),
    entry<BayesUpdate>("Bayesian update (as published)",
                       "Two evidences per cell that only grow; what was once free cannot become occupied again.",
                       "[Barshan07] 3.5, after Elfes 1987"),
    entry<EvidenceGrid>("Evidence grid",
                        "Occupancy in clamped log-odds from a sonar model; cells recover, silence clears.",
                        "[Choset03] II-A, II-B; [Silver04] 2.B"),
    entry<Himm>("Histogramic in-motion mapping",
                "Raises the cell on the axis at the echo, lowers those before it: the quickest grid, for navigation.",
                "[Borenstein91]; [Choset03] II-A"),
    entry<Numakura>("Accumulation with outlier detection",
                    "Adds up free and obstacle evidence, and lets readings that look like outliers count little.",
                    "[Numakura] 4, 5"),
    entry<LimitedGrid>("Evidence grid on laser-limited sonar",
                       "The evidence grid with readings shortened to what a laser saw nearer; needs laser scans.",
                       "[Yamauchi97]"),
    entry<AtmOrg>("Arc-transversal median (original)",
                  "Where other arcs cross an arc steeply lies its echo; without crossings in the middle of the arc.",
                  "[Choset03] III, IV"),
    entry<AtmMod>("Arc-transversal median (modified)",
                  "The same from all arcs of the log, and nothing from arcs that none crosses: few points, good ones.",
                  "[Barshan07] 3.6"),
    entry<AtmSilver>("Arc-transversal median (after Silver)",
                     "The same from the newest 250 arcs, in the middle where two cross: an on-line map.",
                     "[Silver04] 2.D"),
    entry<Carve>("Arc carving",
                 "Newer readings cut from older arcs what they found free: sharp points with no delay, ghosts removed.",
                 "[Silver04] 3, 5.A"),
    entry<CarvedGrid>("Carved occupancy grid",
                      "An evidence grid whose bands are as narrow as carving has left the arcs of their sensor.",
                      "[Silver04] 4"),
    entry<TriangulationFusion>("Triangulation-based fusion",
                               "Points where recent arcs meet, edges and poles told from walls: exact and sparse.",
                               "[Barshan07] 3.7, after Wijk and Christensen"),
    entry<Combined>("Arc carving and median combined",
                    "Arc carving and the arc-transversal median side by side on one history, their points in one map.",
                    "[Silver04] 4, 5.A"),
    entry<Consensus>(
        "Tangent consensus",
        "Arcs tell one another where on them a wall or a corner lies: points that are right, nearly all of "
        "them, and linked.",
        "docs/methods/consensus.md"),
    entry<ConsensusEvidence>(
        "Evidence grid on consensus",
        "The evidence grid, fed with where on its arc the consensus places each echo, without outliers.",
        "docs/methods/consensus.md"),
};

}  // namespace

std::span<const MethodEntry> catalog() {
  return methods;
}

const MethodEntry* find_method(std::string_view name) {
  const auto found = std::ranges::find(methods, name, &MethodEntry::name);
  return found != methods.end() ? &*found : nullptr;
}

Result<AnyMethod> make_method(std::string_view name, const OptionMap& options) {
  if (const MethodEntry* found = find_method(name)) return found->make(options);
  std::string names;
  for (const MethodEntry& method : methods) names += (names.empty() ? "" : ", ") + std::string(method.name);
  return Error{ErrorCode::bad_value, "there is no method " + std::string(name), std::string(name),
               "use one of " + names};
}

}  // namespace echoarc
