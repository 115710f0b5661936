// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The integration example V5.3 of the method specification from end to end: readings through the real methods into the
// real scores.

#include "support/v53_scores.hpp"

#include <gtest/gtest.h>

#include "echoarc/core/executor.hpp"
#include "echoarc/mapping/centerline.hpp"
#include "echoarc/mapping/directional_maximum.hpp"
#include "echoarc/mapping/morphological_processing.hpp"
#include "echoarc/mapping/voting.hpp"

namespace echoarc {
namespace {

template <class Method>
void expect_scores(const typename Method::Options& options, const test::V53Row& row) {
  Method method(test::with_v53_grid(options));
  InlineExecutor executor;
  method.insert(test::v53_readings(), executor);
  method.finish(executor);
  const Result<MapExport> map = method.export_map();
  ASSERT_TRUE(map) << row.method;
  const Result<PointSet> occupied = PointSet::of_occupied(map->states);
  ASSERT_TRUE(occupied) << row.method;
  test::expect_v53_scores(*occupied, row);
}

DirectionalMaximumOptions along_columns(int threshold) {
  return {.threshold = threshold, .doi = DirectionOfInterest::axis, .axis = degrees(90.0)};
}

TEST(V53Scores, PointMarking) {
  expect_scores<Centerline>({}, test::v53_pm);
}

TEST(V53Scores, VotingAndThresholding) {
  expect_scores<Voting>({.threshold = 1}, test::v53_vt1);
  expect_scores<Voting>({.threshold = 2}, test::v53_vt2);
  expect_scores<Voting>({.threshold = 4}, test::v53_vt4);
}

TEST(V53Scores, DirectionalMaximum) {
  expect_scores<DirectionalMaximum>(along_columns(1), test::v53_dm1);
  expect_scores<DirectionalMaximum>(along_columns(2), test::v53_dm2);
  expect_scores<DirectionalMaximum>(along_columns(4), test::v53_dm4);
}

TEST(V53Scores, MorphologicalProcessing) {
  expect_scores<MorphologicalProcessing>({.neighbours = 0}, test::v53_vt1);
  expect_scores<MorphologicalProcessing>({.neighbours = 4}, test::v53_mp4);
  expect_scores<MorphologicalProcessing>({.neighbours = 7}, test::v53_mp7);
  expect_scores<MorphologicalProcessing>({.neighbours = 8}, test::v53_mp8);
}

}  // namespace
}  // namespace echoarc
