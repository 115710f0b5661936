// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/arc_crossing.hpp"
#include "echoarc/core/bytes.hpp"
#include "echoarc/core/range_quantum.hpp"
#include "echoarc/maps/arc_history.hpp"

namespace echoarc {

/// Where the least crossing angle theta_t comes from.
enum class TransversalAngle {
  given,           ///< the same for all arcs
  from_gain,       ///< for each arc the angle that gives the desired resolution gain at its range ([Choset03] eq. 2)
  from_histogram,  ///< a central value of all crossing angles in the history ([Barshan07] 4.3)
};

enum class HistogramStatistic { mean, mode, median };

/// Which crossings of two arcs count as transversal: those at theta_t or more.
struct TransversalRule {
  TransversalAngle angle = TransversalAngle::given;
  Angle theta_t = degrees(30.0);
  double gain = 10.0;
  HistogramStatistic statistic = HistogramStatistic::median;
  double range_quantum_m = inch_m;  ///< the band of distances that a range stands for
};

/// Crossing angles in bins of one degree over [0, 90] degrees.
class AngleHistogram {
 public:
  static constexpr std::size_t bins = 90;

  void add(double angle_rad) { ++counts_[bin(angle_rad)]; }
  void remove(double angle_rad) { --counts_[bin(angle_rad)]; }
  [[nodiscard]] std::uint64_t count(std::size_t bin) const { return counts_[bin]; }
  /// `mean` of the bins' centres, centre of the bin that holds the `median`, or centre of the fullest bin after
  /// summing over three neighbours (`mode`; of equally full ones the lowest). 0 when nothing was counted.
  [[nodiscard]] Angle value(HistogramStatistic statistic) const;

 private:
  [[nodiscard]] static std::size_t bin(double angle_rad);
  std::array<std::uint64_t, bins> counts_{};
};

/// The median of an arc's transversal crossings.
struct TransversalMedian {
  std::size_t count = 0;              ///< transversal crossings; without one the rest says nothing
  Angle t;                            ///< parameter of the median, of two middle ones the mean
  std::array<ArcSlot, 2> partners{};  ///< whose crossings are the middle ones: one (twice) or two
};

/// For every arc of a history its transversal crossings with the others, sorted along the arc: the bookkeeping of the
/// arc-transversal median ([Choset03] III, [Silver04] 2.D).
///
/// A crossing is kept with both arcs, so an arc that leaves takes it from its partners. The median is the one of the
/// arc's own parameter; with a given angle it is found in constant time.
class TransversalMedians {
 public:
  /// An arc that has as many crossings accepts no more partners: it keeps a robot that stands still for hours bounded.
  static constexpr std::size_t max_crossings_per_arc = 2048;

  explicit TransversalMedians(const TransversalRule& rule = {}) : rule_(rule) {}

  [[nodiscard]] const TransversalRule& rule() const { return rule_; }
  /// Crosses the arc in `slot`, which has just entered the history, with all others in it.
  void insert(const ArcHistory& history, ArcSlot slot);
  /// The same for those who know already where to look: among `met` are all arcs, each once, whose box overlaps the
  /// new one's.
  void insert(const ArcHistory& history, ArcSlot slot, std::span<const ArcSlot> met);
  /// Forgets the arc and its crossings with the others; before it is evicted.
  void erase(ArcSlot slot);

  /// theta_t for an arc as things stand; above 90 degrees when no angle gives the desired gain.
  [[nodiscard]] Angle least_angle(const Arc& arc) const;
  [[nodiscard]] TransversalMedian median(const ArcHistory& history, ArcSlot slot) const;
  /// What `median` would say of an arc if it were inserted now.
  [[nodiscard]] TransversalMedian preview(const ArcHistory& history, const Arc& arc) const;
  [[nodiscard]] const AngleHistogram& histogram() const { return histogram_; }

  /// Pairs of arcs whose crossings were left out because one of the two had too many.
  [[nodiscard]] std::uint64_t pairs_left_out() const { return pairs_left_out_; }
  /// Bytes of all crossings kept, with room for their vectors to grow.
  [[nodiscard]] std::size_t memory_bytes() const { return records_ * sizeof(Record) * 3 / 2; }
  /// Bytes of one arc apart from its crossings.
  static constexpr std::size_t arc_bytes = sizeof(CrossableArc) + sizeof(void*) * 3 + sizeof(double);

  /// Writes the crossings of `history`'s arcs, oldest first.
  void save(const ArcHistory& history, ByteWriter& out) const;
  /// Reads them back for a history just restored; false when the bytes hold none.
  [[nodiscard]] bool restore(const ArcHistory& history, ByteReader& in);

 private:
  struct Record {
    double t;
    float angle_rad;
    ArcSlot partner;
  };
  struct Found {
    double t_old;
    double t_new;
    float angle_rad;
    ArcSlot partner;
  };

  [[nodiscard]] double least_angle_to_keep(double least_old, double least_new) const;
  void collect(const CrossableArc& arc, double least_rad, ArcSlot self, std::span<const ArcSlot> candidates,
               std::vector<Found>& found) const;
  void cross_with_candidates(const ArcHistory& history, ArcSlot slot);
  [[nodiscard]] bool has_room(ArcSlot slot, std::size_t more) const {
    return crossings_[slot].size() + more <= max_crossings_per_arc;
  }
  [[nodiscard]] TransversalMedian middle_of(std::span<const Record> sorted, double least_rad) const;
  void add(ArcSlot slot, const Record& record);

  TransversalRule rule_;
  std::vector<CrossableArc> arcs_;              // by slot
  std::vector<double> least_rad_;               // by slot: theta_t of the arc where it does not change any more
  std::vector<std::vector<Record>> crossings_;  // by slot, by t; equal ones by age of the partner
  AngleHistogram histogram_;
  std::size_t records_ = 0;
  std::uint64_t pairs_left_out_ = 0;
  std::vector<ArcSlot> candidates_;  // scratch
  std::vector<Found> found_;         // scratch
};

}  // namespace echoarc
