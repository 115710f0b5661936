// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "echoarc/core/rng.hpp"
#include "sim/world_model.hpp"

namespace echoarc::sim {

namespace {

constexpr double highest_m = 0.005;
// Nearer to the wall than a leg's uncounted last 1e-6 m, a bump would be seen from behind.
constexpr double lowest_m = 1e-5;
constexpr double jitter_share = 0.3;  // of the pitch, to either side
constexpr double spread_db = 3.0;

/// A stream of its own for every bump: no bump moves when a wall gets longer or another one is added behind it.
Rng bump_rng(std::uint64_t seed, std::uint64_t surface, bool right, std::uint64_t index) {
  std::uint64_t key = seed;
  for (const std::uint64_t part : {surface, std::uint64_t{right}, index})
    key = Rng(key ^ (part * 0x9e3779b97f4a7c15ULL)).next();
  return Rng(key);
}

/// A surface as a run of points with the distance gone at each.
class Track {
 public:
  explicit Track(std::vector<Vec2> points) : points_(std::move(points)), gone_m_(points_.size(), 0.0) {
    for (std::size_t i = 1; i < points_.size(); ++i) gone_m_[i] = gone_m_[i - 1] + norm(points_[i] - points_[i - 1]);
  }
  [[nodiscard]] double length_m() const { return gone_m_.back(); }
  struct Place {
    Vec2 point;
    Vec2 left;  // unit
  };
  /// Where the track is after `distance_m`. Distances must not fall.
  [[nodiscard]] Place at(double distance_m) {
    while (piece_ + 2 < points_.size() && gone_m_[piece_ + 1] < distance_m) ++piece_;
    const Vec2 along = (points_[piece_ + 1] - points_[piece_]) / (gone_m_[piece_ + 1] - gone_m_[piece_]);
    return {points_[piece_] + (distance_m - gone_m_[piece_]) * along, perpendicular(along)};
  }

 private:
  std::vector<Vec2> points_;
  std::vector<double> gone_m_;
  std::size_t piece_ = 0;
};

std::size_t count_on(const Track& track, const Material& material) {
  return static_cast<std::size_t>(track.length_m() / material.rough_pitch_m);
}

void place_on(Track track, const Material& material, std::uint64_t seed, std::uint64_t surface, bool right,
              std::vector<Scatterer>& points) {
  const std::size_t count = count_on(track, material);
  for (std::size_t i = 0; i < count; ++i) {
    Rng rng = bump_rng(seed, surface, right, i);
    const double shift = rng.uniform(-jitter_share, jitter_share);
    const Track::Place place = track.at((static_cast<double>(i) + 0.5 + shift) * material.rough_pitch_m);
    const Vec2 facing = right ? -place.left : place.left;
    const double height_m = rng.uniform(lowest_m, highest_m);
    points.push_back({place.point + height_m * facing, facing, rng.normal(*material.rough_db, spread_db)});
  }
}

}  // namespace

Result<Bumps> place_bumps(const WorldDescription& d) {
  Bumps bumps;
  std::uint64_t surface = 0;
  bool fits = true;
  const auto add = [&](MaterialId id, bool one_sided, const auto& points) {
    const Material& material = d.materials[id];
    std::optional<Track> track;
    if (material.rough_db) track.emplace(points());
    for (const bool right : {false, true}) {
      bumps.start_of_surface.push_back(static_cast<std::uint32_t>(bumps.points.size()));
      if (!track || (right && one_sided)) continue;
      fits = fits && bumps.points.size() + count_on(*track, material) <= World::max_scatterers;
      if (fits) place_on(*track, material, d.seed, surface, right, bumps.points);
    }
    ++surface;
  };
  for (const Wall& wall : d.walls) add(wall.material, wall.one_sided, [&] { return std::vector{wall.a, wall.b}; });
  for (const SmoothCurve& curve : d.curves) add(curve.material, false, [&] { return curve.points; });
  bumps.start_of_surface.push_back(static_cast<std::uint32_t>(bumps.points.size()));
  if (fits) return bumps;
  return Error{ErrorCode::too_large, "rough walls carry more than 20000000 bumps", "", "raise rough_pitch_m"};
}

}  // namespace echoarc::sim
