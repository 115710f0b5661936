// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/score_report.hpp"

#include <utility>
#include <vector>

#include "echoarc/eval/mean_absolute_error.hpp"

namespace echoarc {
namespace {

void add_wall_distance(std::vector<ScoreRow>& table, const WallDistance& score, const std::string& prefix,
                       const std::string& of) {
  table.push_back({prefix + "points", double(score.points), "", of});
  table.push_back({prefix + "accuracy_5cm", score.accuracy[0], "share", of + " within 5 cm of the reference"});
  table.push_back({prefix + "accuracy_10cm", score.accuracy[1], "share", of + " within 10 cm of the reference"});
  table.push_back({prefix + "accuracy_20cm", score.accuracy[2], "share", of + " within 20 cm of the reference"});
  table.push_back({prefix + "mae", score.mean_m, "m", of + ": mean distance to the reference"});
  table.push_back({prefix + "distance_median", score.median_m, "m", "half are nearer"});
  table.push_back({prefix + "distance_p95", score.p95_m, "m", "95 % are nearer"});
  table.push_back({prefix + "coverage", score.coverage, "share",
                   std::to_string(score.covered_points) + " of " + std::to_string(score.reference_points) +
                       " reference points near the path have a map point near"});
}

void add_correct_detection(std::vector<ScoreRow>& table, const CorrectDetection& score,
                           std::optional<double> tolerance_m) {
  const std::string note =
      tolerance_m ? "with a tolerance of " + std::to_string(*tolerance_m) + " m: not the published ratio" : "";
  const auto of = [](std::uint64_t part, std::uint64_t whole, const char* what) {
    return std::to_string(part) + " of " + std::to_string(whole) + what;
  };
  const std::string separator = note.empty() ? "" : "; ";
  table.push_back({"cdr_full", score.full_ratio(), "share",
                   of(score.correct_full, score.full, " full directions found") + separator + note});
  table.push_back({"cdr_empty", score.empty_ratio(), "share",
                   of(score.correct_empty, score.empty, " empty directions left empty") + separator + note});
  table.push_back(
      {"cdr_overall", score.overall_ratio(), "share",
       of(score.correct_full + score.correct_empty, score.full + score.empty, " directions right") + separator + note});
}

void add_timing(std::vector<ScoreRow>& table, const TimingSummary& timing) {
  const std::string note = "median of " + std::to_string(timing.runs) + (timing.runs == 1 ? " run" : " runs");
  table.push_back({"cpu_insert", timing.insert_cpu_s, "s", "readings into the method; " + note});
  table.push_back({"cpu_finish", timing.finish_cpu_s, "s", "from there to the map; " + note});
  table.push_back({"cpu_total", timing.total_cpu_s, "s", note});
  table.push_back(
      {"cpu_per_reading", timing.per_reading_s, "s", std::to_string(timing.readings) + " readings; " + note});
}

PointSet inside(const PointSet& map, const Box& region) {
  std::vector<Vec2> kept;
  for (const Vec2 p : map.points())
    if (p.x >= region.low.x && p.x < region.high.x && p.y >= region.low.y && p.y < region.high.y) kept.push_back(p);
  return PointSet::make(std::move(kept)).value();  // part of a set that is valid
}

}  // namespace

Result<ScoreReport> score(const PointSet& map, const Reference& reference, const ScoreRequest& request,
                          const PointSet* cells) {
  if (const Result<void> valid = validate(request.wall_distance); !valid) return valid.error();
  ScoreReport report;
  report.reference = reference.provenance;
  report.reference_points = reference.points.size();
  report.wall_distance = wall_distance(map, reference, request.path, request.wall_distance);
  if (!request.directions) return report;
  const PointSet& drawn = cells != nullptr ? *cells : map;
  const Result<CorrectDetection> detection =
      correct_detection(drawn, reference, *request.directions, request.detection_tolerance_m);
  if (!detection) return detection.error();
  report.cells_mae_m = mean_absolute_error_m(inside(drawn, request.directions->region), reference);
  report.correct_detection = *detection;
  report.detection_tolerance_m = request.detection_tolerance_m;
  return report;
}

std::vector<ScoreRow> rows(const ScoreReport& report) {
  std::vector<ScoreRow> table;
  table.push_back({"reference_points", double(report.reference_points), "", report.reference});
  add_wall_distance(table, report.wall_distance.all, "", "map points");
  add_wall_distance(table, report.wall_distance.one_per_cell, "thinned_", "map points, one per cell");
  if (report.cells_mae_m)
    table.push_back({"cells_mae", *report.cells_mae_m, "m", "cells of the directions' region: mean distance"});
  if (report.correct_detection) add_correct_detection(table, *report.correct_detection, report.detection_tolerance_m);
  if (report.timing) add_timing(table, *report.timing);
  return table;
}

}  // namespace echoarc
