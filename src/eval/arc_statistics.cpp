// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/arc_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "echoarc/core/arc_carving.hpp"
#include "echoarc/eval/statistics.hpp"

namespace echoarc {
namespace {

constexpr double most_bins = 100'000;

double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::size_t RadiusBins::count() const {
  // An end that a rounding error puts behind a border opens no bin of its own.
  return std::size_t(std::max(1.0, std::ceil(max_m / width_m - 1e-9)));
}

std::optional<std::size_t> RadiusBins::of(double radius_m) const {
  if (!(radius_m >= 0.0) || !(radius_m <= max_m)) return std::nullopt;
  return std::min(std::size_t(radius_m / width_m), count() - 1);
}

double RadiusBins::middle_m(std::size_t bin) const {
  return 0.5 * (double(bin) * width_m + std::min(double(bin + 1) * width_m, max_m));
}

Result<void> validate(const RadiusBins& bins) {
  const bool positive = bins.width_m > 0.0 && bins.max_m > 0.0;
  if (positive && std::isfinite(bins.width_m) && std::isfinite(bins.max_m) && bins.max_m / bins.width_m <= most_bins)
    return {};
  return Error{ErrorCode::bad_value, "the classes of radii are empty or too many", "radius bins",
               "give a width and an end above 0 m, at most 100000 classes"};
}

LatencyMeter::LatencyMeter(const RadiusBins& bins) : bins_(bins), arcs_(bins.count()), unprocessed_(bins.count()) {}

void LatencyMeter::see(const ArcState& arc) {
  if (arc.removed) return;
  const std::uint64_t unprocessed = arc.processed() ? 0 : 1;
  ++now_arcs_;
  now_unprocessed_ += unprocessed;
  const auto bin = bins_.of(arc.arc.range_m());
  if (!bin) return;
  ++arcs_[*bin];
  unprocessed_[*bin] += unprocessed;
}

void LatencyMeter::end_sample() {
  if (now_arcs_ > 0) {
    ++samples_;
    share_sum_ += double(now_unprocessed_) / double(now_arcs_);
  }
  now_arcs_ = 0;
  now_unprocessed_ = 0;
}

Latency LatencyMeter::latency() const {
  Latency latency{.samples = samples_,
                  .unprocessed_share = ratio(share_sum_, double(samples_)),
                  .share_by_radius = {},
                  .arcs_by_radius = arcs_};
  for (std::size_t bin = 0; bin < arcs_.size(); ++bin)
    latency.share_by_radius.push_back(ratio(double(unprocessed_[bin]), double(arcs_[bin])));
  return latency;
}

AzimuthMeter::AzimuthMeter(const RadiusBins& bins) : bins_(bins), collected_(bins.count()) {}

void AzimuthMeter::see(const ArcState& leaving) {
  if (leaving.removed) return;
  const auto bin = bins_.of(leaving.arc.range_m());
  if (!bin) return;
  Collected& all = collected_[*bin];
  const double error_m = max_error_m(leaving.arc);
  ++all.arcs;
  all.error_all_m += error_m;
  if (!leaving.carved) return;
  all.error_m += error_m;
  all.lengths_rad.push_back(leaving.angular_length().rad());
}

std::vector<AzimuthClass> AzimuthMeter::classes() const {
  std::vector<AzimuthClass> classes;
  for (const Collected& all : collected_) {
    const auto carved = std::uint64_t(all.lengths_rad.size());
    classes.push_back({.arcs = all.arcs,
                       .carved = carved,
                       .mean_length_rad = mean(all.lengths_rad),
                       .median_length_rad = median(all.lengths_rad),
                       .mean_error_m = ratio(all.error_m, double(carved)),
                       .mean_error_all_m = ratio(all.error_all_m, double(all.arcs))});
  }
  return classes;
}

double centerline_error_m(double radius_m, Angle beam_width) {
  return 2.0 * radius_m * sin(0.25 * beam_width);
}

double crossing_error_m(double range_quantum_m, Angle psi) {
  return range_quantum_m * (1.0 + cos(psi)) / sin(psi);
}

double fully_carved_share(std::uint64_t removed_full, std::uint64_t removed_split, std::uint64_t left_history) {
  return ratio(double(removed_full), double(removed_full + removed_split + left_history));
}

}  // namespace echoarc
