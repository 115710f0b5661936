// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/features/feature.hpp"

/// McKerrow's common tangents ([Choset03] II-C; [Silver04] 4 for carved arcs).
namespace echoarc {

/// The line that touches two circular arcs from outside, seen from the sensors.
struct CommonTangent {
  Vec2 normal;  ///< unit, from the sensors to the line
  Vec2 first;   ///< where it touches the first arc: S + r n
  Vec2 second;
};

/// The common tangent whose normal n lies on both arcs' present intervals: n.(S2 - S1) = r1 - r2. Of two such normals
/// the one nearer the middles of the intervals. No value when there is none, when an arc is elliptical, or when the
/// sensors stand closer than \p baseline_min_m.
[[nodiscard]] std::optional<CommonTangent> common_tangent(const Arc& first, const Arc& second,
                                                          double baseline_min_m = 0.0);

struct TangentOptions {
  double baseline_min_m = 0.05;
  double gap_m = 0.30;
  Angle turn = degrees(5.0);
  int arcs_min = 2;
  double range_max_m = 5.0;

  static constexpr auto fields() {
    using O = TangentOptions;
    return std::tuple{
        field("baseline_min_m", &O::baseline_min_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "a sonar moves so far between two arcs of a pair"}),
        field("gap_m", &O::gap_m,
              {.unit = "m", .min = 0.0, .max = 100.0, .doc = "the echo points of a pair are closer than this"}),
        field("turn_deg", &O::turn,
              {.unit = "deg", .min = 0.0, .max = 180.0, .doc = "a segment goes on while the normal turns by less"}),
        field("arcs_min", &O::arcs_min,
              {.unit = "arcs", .min = 2, .max = 1000000, .doc = "segments that touch fewer arcs are dropped"}),
        field("range_max_m", &O::range_max_m,
              {.unit = "m", .min = 0.0, .max = 1000.0, .doc = "farther echoes are left out"})};
  }
};

/// What became of the arcs.
struct TangentCounters {
  std::uint64_t arcs = 0;
  std::uint64_t bistatic = 0;     ///< elliptical arcs are not used
  std::uint64_t passed_over = 0;  ///< too far, or the sonar had not moved on
  std::uint64_t pairs = 0;        ///< of successive arcs of a sonar
  std::uint64_t tangents = 0;     ///< pairs that have one
};

/// Chains the common tangents of every sonar's successive arcs to segments. Memory: one open segment per sonar, and the
/// finished ones.
class CommonTangents {
 public:
  explicit CommonTangents(TangentOptions options = {}) : options_(options) {}

  /// Readings in the order of time; those without an echo say nothing.
  void insert(std::span<const Reading> readings);
  /// An arc with its present limits, carved or not.
  void insert(const Arc& arc, SensorId sensor, PingId ping);
  /// Finished segments, then the open ones in the order of the sonars.
  [[nodiscard]] std::vector<Feature> features() const;
  [[nodiscard]] const TangentCounters& counters() const { return counters_; }

 private:
  struct Chain {
    std::vector<Vec2> points;  ///< of every pair both echo points
    std::vector<PingId> pings;
    Vec2 normal;
  };
  struct Track {
    Arc arc;
    PingId ping = 0;
    Chain chain;
  };
  void close(Chain& chain);
  [[nodiscard]] std::optional<Feature> segment_of(const Chain& chain) const;

  TangentOptions options_;
  TangentCounters counters_;
  std::map<SensorId, Track> tracks_;
  std::vector<Feature> finished_;
};

}  // namespace echoarc
