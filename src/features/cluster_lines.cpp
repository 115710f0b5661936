// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/cluster_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoarc/features/fitted_line.hpp"

namespace echoarc {
namespace {

constexpr int deepest_split = 64;  // what needs more splits than this is no polygon

/// A line and the points behind it.
struct Piece {
  PointMoments moments;
  FittedLine line;
  double low_m = 0.0;  ///< extent along the line, from its centroid
  double high_m = 0.0;

  [[nodiscard]] double length_m() const { return high_m - low_m; }
  [[nodiscard]] Vec2 begin() const { return line.at(low_m); }
  [[nodiscard]] Vec2 end() const { return line.at(high_m); }
};

Piece fit(std::span<const Vec2> points) {
  Piece piece;
  for (const Vec2 p : points) piece.moments.add(p);
  piece.line = FittedLine::of(piece.moments);
  // The sense of a line is that of its points, so that it turns with the world.
  if (dot(piece.line.direction, points.back() - points.front()) < 0.0) piece.line.direction = -piece.line.direction;
  for (const Vec2 p : points) {
    piece.low_m = std::min(piece.low_m, piece.line.along_m(p));
    piece.high_m = std::max(piece.high_m, piece.line.along_m(p));
  }
  return piece;
}

/// Where to cut: the point farthest from the chord between the outermost points. (The point farthest from the fitted
/// line is often an end of an arm of a corner, and cutting there peels off one point after the other.)
Vec2 cut_of(std::span<const Vec2> points, const Piece& piece) {
  const auto along = [&](Vec2 p) { return piece.line.along_m(p); };
  const Vec2 low = *std::ranges::min_element(points, {}, along);
  const Vec2 high = *std::ranges::max_element(points, {}, along);
  return *std::ranges::max_element(points, {}, [&](Vec2 p) { return std::abs(cross(high - low, p - low)); });
}

std::vector<std::vector<Vec2>> clusters_of(std::span<const Vec2> points, double link_m) {
  const std::vector<std::size_t> cluster = single_link_clusters(points, link_m);
  std::vector<std::vector<Vec2>> clusters;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (cluster[k] == clusters.size()) clusters.emplace_back();
    clusters[cluster[k]].push_back(points[k]);
  }
  return clusters;
}

/// Fits a line; where a point lies too far off, cuts, and fits what is still linked on either side.
void split(std::vector<Vec2> points, const ClusterLineOptions& options, int depth, std::vector<Piece>& pieces) {
  if (points.size() < std::size_t(options.points_min) || depth > deepest_split) return;
  const Piece piece = fit(points);
  const auto off = [&](Vec2 p) { return std::abs(piece.line.beside_m(p)); };
  const auto worst = std::ranges::max_element(points, {}, off);
  if (off(*worst) <= options.split_m) {
    if (piece.length_m() >= options.length_min_m) pieces.push_back(piece);
    return;
  }
  const Vec2 cut = cut_of(points, piece);
  std::vector<Vec2> before;
  std::vector<Vec2> after;
  for (const Vec2 p : points)
    if (p != cut) (piece.line.along_m(p) < piece.line.along_m(cut) ? before : after).push_back(p);
  points = {};
  (before.size() <= after.size() ? before : after).push_back(cut);
  for (const auto& side : {before, after})
    for (std::vector<Vec2>& part : clusters_of(side, options.link_m))
      split(std::move(part), options, depth + 1, pieces);
}

bool belong_together(const Piece& a, const Piece& b, const ClusterLineOptions& options) {
  const double turn = std::abs(cross(a.line.direction, b.line.direction));
  if (turn >= sin(options.merge_angle)) return false;
  const auto middle = [](const Piece& p) { return 0.5 * (p.begin() + p.end()); };
  const double offset_m = std::max(std::abs(a.line.beside_m(middle(b))), std::abs(b.line.beside_m(middle(a))));
  if (offset_m >= options.merge_offset_m) return false;
  const auto [low_m, high_m] = std::minmax({a.line.along_m(b.begin()), a.line.along_m(b.end())});
  return std::max(low_m - a.high_m, a.low_m - high_m) < options.merge_gap_m;
}

Piece joined(const Piece& a, const Piece& b) {
  Piece piece;
  piece.moments = a.moments;
  piece.moments.add(b.moments);
  piece.line = FittedLine::of(piece.moments);
  if (dot(piece.line.direction, a.line.direction) < 0.0) piece.line.direction = -piece.line.direction;
  for (const Vec2 p : {a.begin(), a.end(), b.begin(), b.end()}) {
    piece.low_m = std::min(piece.low_m, piece.line.along_m(p));
    piece.high_m = std::max(piece.high_m, piece.line.along_m(p));
  }
  return piece;
}

/// Joins pairs until none is left to join.
std::vector<Piece> merge(std::vector<Piece> pieces, const ClusterLineOptions& options) {
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (std::size_t other = 0; other < pieces.size(); ++other) {
      if (other == k || !belong_together(pieces[k], pieces[other], options)) continue;
      const std::size_t first = std::min(k, other);
      pieces[first] = joined(pieces[first], pieces[std::max(k, other)]);
      pieces.erase(pieces.begin() + std::ptrdiff_t(std::max(k, other)));
      k = first;
      other = std::size_t(-1);  // the longer line may reach others
    }
  return pieces;
}

}  // namespace

std::vector<Feature> cluster_lines(std::span<const Vec2> points, const ClusterLineOptions& options) {
  constexpr double farthest_m = 1e9;  // beyond, positions are no whole buckets any more
  std::vector<Vec2> sound;
  for (const Vec2 p : points)
    if (std::abs(p.x) < farthest_m && std::abs(p.y) < farthest_m) sound.push_back(p);
  std::vector<Piece> pieces;
  for (std::vector<Vec2>& members : clusters_of(sound, options.link_m)) split(std::move(members), options, 0, pieces);
  std::vector<Feature> lines;
  for (const Piece& piece : merge(std::move(pieces), options))
    lines.push_back({FeatureKind::line,
                     piece.begin(),
                     piece.end(),
                     piece.line.rms_m,
                     static_cast<std::uint32_t>(piece.moments.count()),
                     {}});
  return lines;
}

}  // namespace echoarc
