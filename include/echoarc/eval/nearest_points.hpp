// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <vector>

#include "echoarc/eval/point_set.hpp"

namespace echoarc {

/// Exact nearest neighbour among fixed points (kd-tree). A distance transform would be faster and wrong by up to half a
/// cell. Building takes O(N log N), a query O(log N). Const calls from several threads are safe.
class NearestPoints {
 public:
  /// `set` must outlive the index.
  explicit NearestPoints(const PointSet& set);
  ~NearestPoints();
  NearestPoints(NearestPoints&&) noexcept;
  NearestPoints& operator=(NearestPoints&&) noexcept;

  /// Metres to the nearest point; infinity when there is none. `query` must be finite.
  [[nodiscard]] double distance_m(Vec2 query) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

/// Distance of every point of `from` to its nearest neighbour in `to`, in the order of `from`.
[[nodiscard]] std::vector<double> nearest_distances_m(const PointSet& from, const PointSet& to);

}  // namespace echoarc
