// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/maps/arc_state.hpp"

namespace echoarc {

/// Classes of arcs by their radius: [0, width), [width, 2 width), ... up to and with `max_m`; the last may be narrower.
struct RadiusBins {
  double width_m = 0.25;
  double max_m = 3.81;  ///< 150 inches, as far as the arrays of [Silver04] heard

  [[nodiscard]] std::size_t count() const;
  /// None beyond `max_m`, and for what is no radius.
  [[nodiscard]] std::optional<std::size_t> of(double radius_m) const;
  [[nodiscard]] double middle_m(std::size_t bin) const;
};
/// Errors: a width or an end that is not positive and finite, more than 100 000 bins.
[[nodiscard]] Result<void> validate(const RadiusBins& bins);

/// How much of its history a method has not worked on yet ([Silver04] 5.B).
struct Latency {
  std::uint64_t samples = 0;                  ///< looks at the history
  double unprocessed_share = 0.0;             ///< of the arcs in the history, mean over the samples; NaN without any
  std::vector<double> share_by_radius;        ///< over the arcs of all samples; NaN where there were none
  std::vector<std::uint64_t> arcs_by_radius;  ///< seen, once in every sample
};

/// Collects looks at a history. Arcs that carving removed are not in it any more: they count neither above nor below
/// the line.
class LatencyMeter {
 public:
  /// Requires valid bins.
  explicit LatencyMeter(const RadiusBins& bins = {});

  /// One arc of the look that is going on.
  void see(const ArcState& arc);
  /// Ends a look. One without any arc does not count.
  void end_sample();
  [[nodiscard]] Latency latency() const;

 private:
  RadiusBins bins_;
  std::uint64_t samples_ = 0;
  double share_sum_ = 0.0;
  std::uint64_t now_arcs_ = 0;
  std::uint64_t now_unprocessed_ = 0;
  std::vector<std::uint64_t> arcs_;
  std::vector<std::uint64_t> unprocessed_;
};

/// How narrow the arcs of a class are in the end ([Silver04] 5.C). NaN where there is no arc to say so.
struct AzimuthClass {
  std::uint64_t arcs = 0;          ///< that left the history alive
  std::uint64_t carved = 0;        ///< of those
  double mean_length_rad = 0.0;    ///< theta_d of carved arcs (eq. 5.1; Fig. 11)
  double median_length_rad = 0.0;  ///< likewise
  double mean_error_m = 0.0;       ///< E_s of carved arcs (eq. 5.3; Fig. 12)
  double mean_error_all_m = 0.0;   ///< E_s of all that left alive, carved or not
};

/// Collects arcs as they leave a history, by radius. Removed ones are left out.
class AzimuthMeter {
 public:
  /// Requires valid bins.
  explicit AzimuthMeter(const RadiusBins& bins = {});

  void see(const ArcState& leaving);
  /// One per bin.
  [[nodiscard]] std::vector<AzimuthClass> classes() const;

 private:
  struct Collected {
    std::uint64_t arcs = 0;
    double error_all_m = 0.0;
    double error_m = 0.0;
    std::vector<double> lengths_rad;
  };
  RadiusBins bins_;
  std::vector<Collected> collected_;
};

/// Largest error of a point in the middle of an uncarved arc: 2 r sin(beam/4) ([Silver04] eq. 5.3 with E_m = beam/2).
[[nodiscard]] double centerline_error_m(double radius_m, Angle beam_width);
/// Largest error of a transversal crossing: q cot(psi/2) = q (1/sin psi + 1/tan psi) ([Silver04] eq. 5.4), whatever the
/// radius. Requires 0 < psi <= 90 degrees.
[[nodiscard]] double crossing_error_m(double range_quantum_m, Angle psi);

/// Share of the arcs a carver is done with that it removed because nothing was left: removed_full / (removed_full +
/// removed_split + left_history), the counts of `Carve`; NaN before it is done with any. ([Silver04] 5.C: > 20 %.)
[[nodiscard]] double fully_carved_share(std::uint64_t removed_full, std::uint64_t removed_split,
                                        std::uint64_t left_history);

}  // namespace echoarc
