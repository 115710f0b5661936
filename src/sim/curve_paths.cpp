// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/ping_search.hpp"

namespace echoarc::sim {

namespace {

// Samples to either side that the radius of curvature is taken from: the rounding of neighbours would show.
constexpr std::ptrdiff_t radius_reach = 8;
constexpr double most_focus = 4.0;

/// The parabola through three neighbouring samples, u in [-1, 1].
struct Arch {
  Vec2 before;
  Vec2 middle;
  Vec2 after;

  [[nodiscard]] Vec2 at(double u) const {
    return middle + u / 2.0 * (after - before) + u * u / 2.0 * (before + after - 2.0 * middle);
  }
  [[nodiscard]] Vec2 tangent(double u) const { return (after - before) / 2.0 + u * (before + after - 2.0 * middle); }
};

/// The stationary point of `length` within [-1, 1]: golden section, for the minimum of `sign` times it.
template <class Length>
double golden_section(const Length& length, double sign) {
  constexpr double ratio = 0.6180339887498949;
  double low = -1.0;
  double high = 1.0;
  double left = high - ratio * (high - low);
  double right = low + ratio * (high - low);
  double at_left = sign * length(left);
  double at_right = sign * length(right);
  while (high - low > 1e-6) {
    if (at_left <= at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      left = high - ratio * (high - low);
      at_left = sign * length(left);
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      right = low + ratio * (high - low);
      at_right = sign * length(right);
    }
  }
  return 0.5 * (low + high);
}

/// Signed curvature of the circle through three points in their order, positive if it bends to the left.
double curvature(const Arch& arch) {
  const Vec2 a = arch.middle - arch.before;
  const Vec2 b = arch.after - arch.middle;
  return 2.0 * cross(a, b) / (norm(a) * norm(b) * norm(arch.after - arch.before));
}

/// Curvature spreads or gathers sound: `bend` is the curvature towards the listener (positive: hollow).
double focus_db(double bend, double range_m) {
  if (bend <= 0.0) return -10.0 * std::log10(1.0 - bend * range_m);  // rho / (rho + r)
  return 10.0 * std::log10(std::min(most_focus, 1.0 / std::abs(1.0 - bend * range_m)));
}

class CurveSearch {
 public:
  CurveSearch(PingSearch& ping, const SmoothCurve& curve)
      : ping_(ping),
        curve_(curve),
        facets_(static_cast<std::ptrdiff_t>(curve.points.size()) - 1),
        closed_(norm(curve.points.front() - curve.points.back()) <= 1e-6) {}

  /// Local extrema of the length at the samples first ... last - 1; the ends of an open curve are edges instead.
  void search(std::ptrdiff_t first, std::ptrdiff_t last) {
    const std::ptrdiff_t begin = closed_ ? first : std::max<std::ptrdiff_t>(first, 1);
    const std::ptrdiff_t end = std::min(last, facets_);
    if (begin >= end) return;
    double before = length(sample(begin - 1));
    double here = length(sample(begin));
    for (std::ptrdiff_t i = begin; i < end; ++i) {
      const double after = length(sample(i + 1));
      // Of two equal neighbours the second counts.
      if (here <= before && here < after) echo(i, 1.0);
      if (here >= before && here > after) echo(i, -1.0);
      before = std::exchange(here, after);
    }
  }

 private:
  [[nodiscard]] Vec2 sample(std::ptrdiff_t i) const {
    return curve_.points[static_cast<std::size_t>(closed_ ? (i + facets_) % facets_ : i)];
  }
  [[nodiscard]] Arch arch(std::ptrdiff_t i, std::ptrdiff_t reach) const {
    return {sample(i - reach), sample(i), sample(i + reach)};
  }
  [[nodiscard]] double length(Vec2 p) const {
    return std::sqrt(squared_norm(p - ping_.sender.position)) + std::sqrt(squared_norm(p - ping_.listener.position));
  }

  void echo(std::ptrdiff_t i, double sign) {
    const Arch here = arch(i, 1);
    const double u = golden_section([&](double x) { return length(here.at(x)); }, sign);
    const Vec2 point = here.at(u);
    const double length_m = length(point);
    if (length_m > ping_.limits.max_length_m || !ping_.sender.hears(point) || !ping_.listener.hears(point)) return;
    const Vec2 left = perpendicular(here.tangent(u)) / norm(here.tangent(u));
    const double side = dot(ping_.sender.position - point, left);
    // Where the curve stands between both, the straight way is the shortest.
    if (side * dot(ping_.listener.position - point, left) <= 0.0) return;
    const double towards = side > 0.0 ? 1.0 : -1.0;
    // Obstacles are drawn in facets, which may stand a little before the smooth curve.
    const double sagitta_m = norm(here.before + here.after - 2.0 * here.middle);
    const Vec2 seen = point + towards * (2e-6 + sagitta_m) * left;
    if (!ping_.sees(ping_.sender.position, seen) || !ping_.sees(seen, ping_.listener.position)) return;
    const std::ptrdiff_t reach =
        closed_ ? std::min(radius_reach, facets_ / 4) : std::min({radius_reach, i, facets_ - i});
    const double bend = towards * curvature(arch(i, std::max<std::ptrdiff_t>(reach, 1)));
    ping_.add(point, point, length_m, focus_db(bend, length_m / 2.0) - ping_.world.loss_db(curve_.material),
              EchoCause::curve, 1);
  }

  PingSearch& ping_;
  const SmoothCurve& curve_;
  std::ptrdiff_t facets_;
  bool closed_;
};

}  // namespace

void find_curve_paths(PingSearch& ping) {
  const SpatialIndex& index = ping.world.index;
  ping.for_each_lit(ping.sender_view(), [&](std::uint32_t item) {
    if (item < index.first_chunk() || item >= index.first_disc()) return;
    const CurveChunk& chunk = index.chunks()[item - index.first_chunk()];
    CurveSearch(ping, ping.world.description.curves[chunk.curve]).search(chunk.first, chunk.last);
  });
}

}  // namespace echoarc::sim
