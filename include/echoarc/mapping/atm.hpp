// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "echoarc/mapping/atm_options.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc {

/// A map point and the pings behind it.
struct SupportedPoint {
  MapPoint point;
  std::array<PingId, 3> support{};  ///< the arc's own ping first, then those whose crossings are the middle ones
  std::size_t support_count = 0;
};

/// What a variant makes of an arc: the row of its table for the number of transversal crossings. Labelled `atm` with
/// bound w(theta_t)/2, at most half the arc's length, or `centerline` with the distance of the arc's farther end.
[[nodiscard]] std::optional<SupportedPoint> atm_point(AtmVariant variant, const ArcHistory& history,
                                                      const TransversalMedians& medians, ArcSlot slot,
                                                      bool small_d_center = false);

/// The arc-transversal median: an echo lies where other arcs cross its arc steeply; of several such crossings the
/// median along the arc is taken, which stray ones do not move ([Choset03] III, IV; [Barshan07] 3.6; [Silver04] 2.D).
///
/// Incremental: each new arc is crossed with the arcs of the history that are near it, and an arc that leaves the
/// history takes its crossings along. Silence says nothing to this method.
template <AtmVariant variant>
class Atm {
 public:
  using Options = AtmOptions<variant>;
  using Map = PointMap;
  static constexpr std::string_view name = variant == AtmVariant::org   ? "atm_org"
                                           : variant == AtmVariant::mod ? "atm_mod"
                                                                        : "atm_silver";

  explicit Atm(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  void finish(Executor& executor);
  /// At most one point per arc: archived ones in the order in which their arcs left the history, then those of the
  /// history, oldest first.
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  [[nodiscard]] std::vector<Tally> tallies() const;
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's arc passes through `position` (within `eps_length_m`): its own point, and the points of the
  /// arcs that it crosses there.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<Atm> restore(std::span<const std::byte> bytes);

  // See `ArcKeeping`.
  void visit_arcs(const ArcVisitor& visitor) const;
  [[nodiscard]] bool history_full() const;
  void watch_leaving(ArcVisitor visitor) { watcher_ = std::move(visitor); }

  [[nodiscard]] const ArcHistory& history() const { return history_; }
  [[nodiscard]] const TransversalMedians& medians() const { return medians_; }
  /// Bytes that count against the memory limit.
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  [[nodiscard]] std::optional<SupportedPoint> point_of(ArcSlot slot) const {
    return atm_point(variant, history_, medians_, slot, options_.small_d_center);
  }
  [[nodiscard]] ArcState state_of(ArcSlot slot) const;
  void see_off(ArcSlot slot);

  Options options_;
  ArcHistory history_;
  TransversalMedians medians_;
  PointMap archive_;
  PointMap map_;
  InsertCounters counters_;
  ArcVisitor watcher_;
};

using AtmOrg = Atm<AtmVariant::org>;
using AtmMod = Atm<AtmVariant::mod>;
using AtmSilver = Atm<AtmVariant::silver>;

extern template class Atm<AtmVariant::org>;
extern template class Atm<AtmVariant::mod>;
extern template class Atm<AtmVariant::silver>;

static_assert(MappingMethod<AtmOrg> && MappingMethod<AtmMod> && MappingMethod<AtmSilver>);
static_assert(ArcKeeping<AtmOrg> && ArcKeeping<AtmMod> && ArcKeeping<AtmSilver>);

}  // namespace echoarc
