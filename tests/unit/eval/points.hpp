// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <utility>
#include <vector>

#include "echoarc/eval/reference.hpp"

namespace echoarc::test {

/// A point set of finite points; the test has no business giving others.
inline PointSet point_set(std::vector<Vec2> points, double cell_m = 0.0) {
  return *(cell_m > 0.0 ? PointSet::of_cells(std::move(points), cell_m) : PointSet::make(std::move(points)));
}

inline Reference reference_of(std::vector<Vec2> points, double cell_m = 0.0) {
  return {point_set(std::move(points), cell_m), cell_m, "test"};
}

}  // namespace echoarc::test
