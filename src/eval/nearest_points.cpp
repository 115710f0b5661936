// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/nearest_points.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <nanoflann.hpp>

namespace echoarc {
namespace {

/// The points as nanoflann wants to see them.
struct Cloud {
  std::span<const Vec2> points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
    return dimension == 0 ? points[index].x : points[index].y;
  }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;  // nanoflann finds it
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, std::uint32_t>;

}  // namespace

struct NearestPoints::Index {
  explicit Index(std::span<const Vec2> points) : cloud{points}, tree(2, cloud) {}
  Cloud cloud;
  Tree tree;
};

NearestPoints::NearestPoints(const PointSet& set)
    : index_(set.empty() ? nullptr : std::make_unique<Index>(set.points())) {}
NearestPoints::~NearestPoints() = default;
NearestPoints::NearestPoints(NearestPoints&&) noexcept = default;
NearestPoints& NearestPoints::operator=(NearestPoints&&) noexcept = default;

double NearestPoints::distance_m(Vec2 query) const {
  if (index_ == nullptr) return std::numeric_limits<double>::infinity();
  const double coordinates[2] = {query.x, query.y};
  std::uint32_t nearest = 0;
  double squared_m2 = 0.0;
  index_->tree.knnSearch(coordinates, 1, &nearest, &squared_m2);
  return std::sqrt(squared_m2);
}

std::vector<double> nearest_distances_m(const PointSet& from, const PointSet& to) {
  const NearestPoints nearest(to);
  std::vector<double> distances_m;
  distances_m.reserve(from.size());
  for (const Vec2 p : from.points()) distances_m.push_back(nearest.distance_m(p));
  return distances_m;
}

}  // namespace echoarc
