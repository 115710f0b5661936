// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/arc_carving.hpp"
#include "echoarc/core/bytes.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/arc_history.hpp"

namespace echoarc {

/// What newer readings left of one arc.
struct Remains {
  CarvableArc left;  ///< its limits hold what is left
  Box box;           ///< holds what was left when the arc entered
  ArcSource own;
  ArcSource low_by;   ///< the reading that set the beginning of what is left; its own where nothing was carved
  ArcSource high_by;  ///< the same of the end
  bool dead = false;  ///< removed: stays in the history for other methods, gives no point and is carved no more

  [[nodiscard]] const Arc& arc() const { return left.arc(); }
  [[nodiscard]] bool carved() const {
    return arc().t_begin() > -arc().half_width() || arc().t_end() < arc().half_width();
  }
};

struct CarvingCounts {
  std::uint64_t carved = 0;
  std::uint64_t removed_full = 0;
  std::uint64_t removed_split = 0;
  std::uint64_t left_history = 0;
};

/// Arc carving on a history that its user owns, so that other methods can work on the same arcs beside it ([Silver04]
/// 4, 5.A): the history keeps the arcs as they were measured, the carver what is left of each, by slot.
class Carver {
 public:
  explicit Carver(double guard_m = 0.0) : guard_m_(guard_m) {}

  /// Everything in the history that lives loses what lies in the free sector of `newer`, the arc of the reading `by`.
  void carve(const ArcHistory& history, const Arc& newer, const ArcSource& by);
  /// The slots that the last `carve` looked at: all whose box overlaps that of the newer arc.
  [[nodiscard]] std::span<const ArcSlot> met() const { return candidates_; }
  /// The arc has entered the history.
  void admit(const ArcHistory& history, ArcSlot slot);
  /// The arc is about to leave the history.
  void see_off(ArcSlot slot) { counts_.left_history += remains_[slot].dead ? 0 : 1; }

  [[nodiscard]] const Remains& remains(ArcSlot slot) const { return remains_[slot]; }
  [[nodiscard]] const CarvingCounts& counts() const { return counts_; }
  [[nodiscard]] std::vector<Tally> tallies() const;

  void save(ByteWriter& out, ArcSlot slot) const;
  void save_counts(ByteWriter& out) const { out.put(counts_); }
  /// For a slot that was admitted; false when the bytes are no state of this arc.
  [[nodiscard]] bool restore(ByteReader& in, ArcSlot slot);
  void restore_counts(ByteReader& in) { counts_ = in.get<CarvingCounts>(); }

 private:
  /// What decides most pairs, apart from the rest: a cache line.
  struct Outline {
    CircleOutline arc;
    bool circular = false;
    bool dead = false;
  };

  /// Whether carving the arc changes nothing, as far as that is known at once.
  [[nodiscard]] static bool is_spared(const Outline& older, const FreeSector& newer) {
    return older.dead || (older.circular && newer.arc().is_circular() && newer.leaves_aside(older.arc));
  }
  void apply(Remains& older, const FreeSector& newer, const ArcSource& by);
  /// After every change of what is left.
  void trace_outline(ArcSlot slot);

  double guard_m_;
  std::vector<Remains> remains_;   // by slot
  std::vector<Outline> outlines_;  // by slot
  CarvingCounts counts_;
  std::vector<ArcSlot> candidates_;
};

/// The arc as those see it who look into a method's history.
[[nodiscard]] inline ArcState state_of(const Remains& remains) {
  return {.arc = remains.arc(),
          .source = remains.own,
          .carved = !remains.dead && remains.carved(),
          .removed = remains.dead};
}

/// Adds the point of an arc: the middle of what is left ([Silver04] eq. 3.6). Nothing for a removed arc, nor for one
/// that leaves a larger error than `max_error_m`.
void add_point(const Remains& remains, double max_error_m, PointMap& map);

/// The largest bound E_s of a point that options with `carving_fields` let into the map.
template <class Options>
[[nodiscard]] double error_limit_m(const Options& options) {
  return options.error_threshold ? options.max_error_m : std::numeric_limits<double>::infinity();
}

[[nodiscard]] inline ArcSource source_of(const Reading& reading) {
  return {reading.ping, reading.time_s, reading.rx};
}

/// The arc of a reading that carving can use: an echo of more than 0 and at most `max_range_m`. Counts why there is
/// none.
[[nodiscard]] std::optional<Arc> carvable_arc(const Reading& reading, BeamPolicy policy, double max_range_m,
                                              InsertCounters& counters);
/// Whether a position lies on the reading's carvable arc, within `eps_length_m`.
[[nodiscard]] bool on_carvable_arc(const Reading& reading, BeamPolicy policy, double max_range_m, Vec2 position);
/// The arc under which silence counts as free space: at the sensor's trusted range, at most `max_range_m`.
[[nodiscard]] std::optional<Arc> silent_arc(const Reading& reading, BeamPolicy policy, double max_range_m);

}  // namespace echoarc
