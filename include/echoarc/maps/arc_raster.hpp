// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// How the cells of an arc are found.
enum class ArcSampling {
  sampled,  ///< steps of at most half a cell along the arc: no gaps, may miss a corner clipped by less than half a cell
  exact,    ///< every cell the arc meets in a piece of positive length
};

/// Turns arcs into cells. Keeps scratch memory between calls: use one raster per thread.
class ArcRaster {
 public:
  explicit ArcRaster(GridGeometry geometry, ArcSampling sampling = ArcSampling::sampled)
      : geometry_(geometry), sampling_(sampling) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  /// The cells the arc crosses between its limits, each once, in the order in which the arc first enters them. The span
  /// is valid until the next call.
  [[nodiscard]] std::span<const Cell> cells(const Arc& arc);

 private:
  GridGeometry geometry_;
  ArcSampling sampling_;
  std::vector<Cell> cells_;
  std::vector<std::uint64_t> samples_;
  std::vector<double> crossings_;
};

}  // namespace echoarc
