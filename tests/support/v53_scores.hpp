// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/eval/correct_detection.hpp"
#include "echoarc/eval/mean_absolute_error.hpp"
#include "support/v53_scene.hpp"

namespace echoarc::test {

/// One row of the table of V5.3: cells of the map, and its scores with columns as directions of interest.
struct V53Row {
  std::string method;
  std::size_t pixels;
  double mae_cm;
  double cdr_full;
  double cdr_empty;
  double cdr_overall;
};

inline const V53Row v53_pm{"PM", 11, 0.1000, 0.2075, 1.0000, 0.6529};
inline const V53Row v53_vt1{"VT1", 251, 4.0048, 1.0000, 0.3824, 0.6529};
inline const V53Row v53_dm1{"DM1", 95, 4.9956, 1.0000, 0.3824, 0.6529};
inline const V53Row v53_mp4{"MP4", 241, 3.3782, 1.0000, 0.5294, 0.7355};
inline const V53Row v53_mp7{"MP7", 71, 2.0581, 1.0000, 0.7353, 0.8512};
inline const V53Row v53_mp8{"MP8", 69, 1.8552, 1.0000, 0.7647, 0.8678};
inline const V53Row v53_vt2{"VT2", 151, 1.8726, 1.0000, 0.7059, 0.8347};
inline const V53Row v53_dm2{"DM2", 73, 1.9735, 1.0000, 0.7059, 0.8347};
inline const V53Row v53_vt4{"VT4", 46, 0.1984, 0.7736, 1.0000, 0.9008};
inline const V53Row v53_dm4{"DM4", 41, 0.1000, 0.7736, 1.0000, 0.9008};

/// The larger of 1e-4 relative and half a unit of the last of four printed decimals.
inline double v53_tolerance(double printed) {
  return std::max(1e-4 * printed, 0.5e-4);
}

inline void expect_v53_scores(const PointSet& map, const V53Row& row) {
  const Reference reference{*PointSet::make(v53_reference()), 0.002, "V5.3"};
  const DirectionSet columns = column_directions(v53_geometry(), v53_region().i_end, v53_region().j_end);
  const auto score = correct_detection(map, reference, columns);
  ASSERT_TRUE(score) << row.method;
  EXPECT_EQ(map.size(), row.pixels) << row.method;
  EXPECT_EQ(score->full, 53U);
  EXPECT_EQ(score->empty, 68U);
  EXPECT_NEAR(100.0 * mean_absolute_error_m(map, reference), row.mae_cm, v53_tolerance(row.mae_cm)) << row.method;
  EXPECT_NEAR(score->full_ratio(), row.cdr_full, v53_tolerance(row.cdr_full)) << row.method;
  EXPECT_NEAR(score->empty_ratio(), row.cdr_empty, v53_tolerance(row.cdr_empty)) << row.method;
  EXPECT_NEAR(score->overall_ratio(), row.cdr_overall, v53_tolerance(row.cdr_overall)) << row.method;
}

}  // namespace echoarc::test
