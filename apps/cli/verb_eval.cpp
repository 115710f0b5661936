// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/eval_input.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/truth_input.hpp"
#include "cli/verb.hpp"
#include "echoarc/eval/score_report.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EvalArguments {
  std::filesystem::path maps;
  LogArguments reference;  ///< `log` is the reference, whatever its kind
  std::filesystem::path path;
  std::vector<std::string> directions;
  std::vector<double> region;
  double line_width_m = 0.01;
  bool json = false;
};

struct NamedScore {
  std::string name;
  ScoreReport report;
};

/// The lines of --doi over --region; none when no direction was asked for.
Result<std::optional<DirectionSet>> directions_of(const EvalArguments& arguments) {
  if (arguments.directions.empty()) return std::optional<DirectionSet>{};
  const Vec2 low{arguments.region[0], arguments.region[1]};
  const Vec2 high{arguments.region[2], arguments.region[3]};
  if (!is_finite(low) || !is_finite(high) || low.x >= high.x || low.y >= high.y)
    return Error{ErrorCode::bad_value, "the region is empty", "--region", "give X_MIN Y_MIN X_MAX Y_MAX in metres"};
  DirectionSet all;
  for (const std::string& text : arguments.directions) {
    const Result<Angle> along = parse_direction(text);
    if (!along) return along.error();
    // The first line begins at the lower left corner of the region.
    const Vec2 middle = low + 0.5 * arguments.line_width_m * Vec2{1.0, 1.0};
    DirectionSet set = axis_directions({low, high}, middle, *along, arguments.line_width_m);
    all.region = set.region;
    all.families.insert(all.families.end(), set.families.begin(), set.families.end());
  }
  if (const Result<void> valid = validate(all); !valid) return valid.error();
  return std::optional{std::move(all)};
}

std::string share(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.1f} %", 100.0 * value);
}
std::string centimetres(double value_m, int digits = 1) {
  return std::isnan(value_m) ? "-" : fmt::format("{:.{}f}", 100.0 * value_m, digits);
}

Table distance_table(const std::vector<NamedScore>& scores, WallDistance TwoWayWallDistance::* part) {
  Table table({"method", "points", "MAE [cm]", "<=5 cm", "<=10 cm", "<=20 cm", "coverage"});
  for (const auto& [name, report] : scores) {
    const WallDistance& score = report.wall_distance.*part;
    table.add({name, std::to_string(score.points), centimetres(score.mean_m), share(score.accuracy[0]),
               share(score.accuracy[1]), share(score.accuracy[2]), share(score.coverage)});
  }
  return table;
}

void print_scores(const std::vector<NamedScore>& scores) {
  const ScoreReport& first = scores.front().report;
  fmt::print("reference: {} ({})\n\nevery map point\n{}", first.reference, counted(first.reference_points, "point"),
             distance_table(scores, &TwoWayWallDistance::all).text());
  fmt::print("\none map point per 5 cm cell\n{}", distance_table(scores, &TwoWayWallDistance::one_per_cell).text());
  if (first.correct_detection) {
    Table table({"method", "full", "empty", "overall", "MAE [cm]"});
    for (const auto& [name, report] : scores)
      table.add({name, share(report.correct_detection->full_ratio()), share(report.correct_detection->empty_ratio()),
                 share(report.correct_detection->overall_ratio()), centimetres(*report.cells_mae_m, 2)});
    fmt::print("\ncells drawn in {} full and {} empty directions of interest: correct detection ratio (CDR)\n{}",
               first.correct_detection->full, first.correct_detection->empty, table.text());
  }
  fmt::print(
      "\nMAE: mean distance of map points to the reference; <=d: share of them that near;\n"
      "coverage: share of the reference within 2.5 m of the path with a map point at most 10 cm away\n");
}

void print_json(const std::vector<NamedScore>& scores) {
  Json methods = Json::object();
  for (const auto& [name, report] : scores) {
    Json figures = Json::object();
    for (const ScoreRow& row : rows(report)) figures[row.name] = row.value;  // NaN becomes null
    methods[name] = std::move(figures);
  }
  const Json all{{"reference", scores.front().report.reference}, {"methods", std::move(methods)}};
  fmt::print("{}\n", all.dump(2));
}

Result<std::vector<NamedScore>> score_all(const EvalArguments& arguments, std::optional<DirectionSet> directions) {
  const Result<std::vector<NamedMap>> maps = load_maps(arguments.maps);
  if (!maps) return maps.error();
  Result<PointSet> path = load_path(arguments.maps, arguments.path);
  if (!path) return path.error();
  if (path->empty()) warn("no path of the robot: coverage is left out (give --path FILE.csv with columns x,y)");
  Result<Truth> truth = load_truth(arguments.reference, *path);
  if (!truth) return truth.error();
  if (!directions) directions = std::move(truth->directions);
  const ScoreRequest request{.path = std::move(*path),
                             .wall_distance = {},
                             .directions = std::move(directions),
                             .detection_tolerance_m = std::nullopt};
  std::vector<NamedScore> scores;
  for (const NamedMap& map : *maps) {
    Result<ScoreReport> report = score(map.points, truth->reference, request, map.cells ? &*map.cells : nullptr);
    if (!report) return report.error();
    scores.push_back({map.name, std::move(*report)});
  }
  return scores;
}

ExitStatus run(const EvalArguments& arguments) {
  Result<std::optional<DirectionSet>> directions = directions_of(arguments);
  if (!directions) return misuse(directions.error());
  const Result<std::vector<NamedScore>> scores = score_all(arguments, std::move(*directions));
  if (!scores) return fail(scores.error());
  if (arguments.json)
    print_json(*scores);
  else
    print_scores(*scores);
  return done;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<EvalArguments>();
  app.add_option("DIR", arguments->maps, "a folder that `map` wrote, one method's folder in it, or a map.yaml")
      ->required()
      ->type_name("PATH");
  app.add_option("--reference", arguments->reference.log,
                 "the truth: CSV of surfaces (polyline,x,y), a map.yaml, a scene (file or name), or a log with a laser")
      ->required()
      ->type_name("PATH");
  declare_log_files(app, arguments->reference);
  app.add_option("--path", arguments->path, "CSV with columns x,y: where the robot was; default path.csv of DIR")
      ->type_name("FILE");
  CLI::Option* region = app.add_option("--region", arguments->region, "X_MIN Y_MIN X_MAX Y_MAX of --doi, metres");
  region->expected(4)->type_name("METRES");
  app.add_option("--doi", arguments->directions, "directions of interest for the correct detection ratio")
      ->needs(region)
      ->allow_extra_args(false)
      ->type_name("axis:DEG");
  app.add_option("--doi-width", arguments->line_width_m, "width of a direction of interest, metres")
      ->check(CLI::Range(0.001, 10.0).description(""))
      ->type_name("METRES")
      ->capture_default_str();
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb eval_verb() {
  return {"eval",
          "scores of maps against a reference",
          {{"echoarc eval room-map --reference room-truth.csv", "every method of a folder against surfaces"},
           {"echoarc eval demo-map --reference demo", "against the scene that a log was simulated in"},
           {"echoarc eval room-map/consensus --reference room-map/evidence/map.yaml", "one map against another"},
           {"echoarc eval run1-map --reference run1 --describe corridor.toml", "against the log's own laser"},
           {"echoarc eval room-map --reference room-truth.csv --doi axis:90 --region 0 0 6 4",
            "with the correct detection ratio of directions along +y"},
           {"echoarc eval room-map --reference room-truth.csv --json", "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
