// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/depth_regions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace echoarc {
namespace {

/// Returns in the order of their bearings, beginning after the largest jump: where the circle is cut, and so every run,
/// does not depend on where bearing 0 points.
class Circle {
 public:
  Circle(std::vector<DepthReturn> returns, const DepthRegionOptions& options)
      : returns_(std::move(returns)), options_(options) {
    for (DepthReturn& r : returns_) r.bearing = wrap(r.bearing);
    std::ranges::sort(returns_, {}, [](const DepthReturn& r) { return std::pair(r.bearing, r.ping); });
    std::size_t cut = 0;
    for (std::size_t k = 1; k < size(); ++k)
      if (jump_m(k) > jump_m(cut)) cut = k;
    std::ranges::rotate(returns_, returns_.begin() + std::ptrdiff_t(cut));
  }
  [[nodiscard]] std::size_t size() const { return returns_.size(); }
  [[nodiscard]] const DepthReturn& operator[](std::size_t k) const { return returns_[k]; }
  [[nodiscard]] bool heard(std::size_t k) const { return std::isfinite(returns_[k].depth_m); }
  /// Counter-clockwise from return k to return `to`, in [0, 2 pi).
  [[nodiscard]] Angle turn(std::size_t k, std::size_t to) const {
    const double turn = (returns_[to].bearing - returns_[k].bearing).rad();
    return radians(turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn);
  }
  /// Whether return k follows upon the one before it without silence or a gap between them.
  [[nodiscard]] bool follows(std::size_t k) const {
    const std::size_t before = (k + size() - 1) % size();
    return heard(k) && heard(before) && turn(before, k) <= options_.gap;
  }

 private:
  [[nodiscard]] double jump_m(std::size_t k) const {
    if (!follows(k)) return std::numeric_limits<double>::infinity();
    return std::abs(returns_[k].depth_m - returns_[(k + size() - 1) % size()].depth_m);
  }
  std::vector<DepthReturn> returns_;
  DepthRegionOptions options_;
};

/// Returns first ... first + count - 1 of a circle.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
  double sum_m = 0.0;
  [[nodiscard]] double mean_m() const { return sum_m / double(count); }
};

std::vector<Run> grow_runs(const Circle& circle, double tolerance_m) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < circle.size(); ++k) {
    if (!circle.heard(k)) continue;
    const bool goes_on = k > 0 && circle.follows(k) && !runs.empty() &&
                         std::abs(circle[k].depth_m - runs.back().mean_m()) <= tolerance_m;
    if (!goes_on) runs.push_back({k, 0, 0.0});
    ++runs.back().count;
    runs.back().sum_m += circle[k].depth_m;
  }
  if (runs.size() < 2 || !circle.follows(0)) return runs;
  // The cut may lie inside a run.
  const Run last = runs.back();
  if (last.first + last.count < circle.size() || std::abs(last.mean_m() - runs.front().mean_m()) > tolerance_m)
    return runs;
  runs.front() = {last.first, last.count + runs.front().count, last.sum_m + runs.front().sum_m};
  runs.pop_back();
  return runs;
}

}  // namespace

std::vector<DepthRegion> depth_regions(Vec2 position, std::vector<DepthReturn> returns,
                                       const DepthRegionOptions& options) {
  std::erase_if(returns, [](const DepthReturn& r) { return !is_finite(r.bearing); });
  if (returns.empty()) return {};
  const Circle circle(std::move(returns), options);
  std::vector<DepthRegion> regions;
  for (const Run& run : grow_runs(circle, options.depth_m)) {
    const std::size_t last = (run.first + run.count - 1) % circle.size();
    const Angle extent = circle.turn(run.first, last);
    if (run.count < std::size_t(options.readings_min) || extent < options.extent_min - radians(1e-9)) continue;
    DepthRegion region{position, run.mean_m(), wrap(circle[run.first].bearing + 0.5 * extent), extent, {}};
    for (std::size_t k = 0; k < run.count; ++k) region.pings.push_back(circle[(run.first + k) % circle.size()].ping);
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace echoarc
