// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/sweep_subject.hpp"

#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cli/eval_input.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/io/scene_toml.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;
using studies::JudgedLog;
using studies::StudyScene;
using studies::SweepSubject;

bool is_scene_file(const fs::path& path) {
  return path.extension() == ".toml";
}

Result<SweepSubject> load_scene(const SubjectArguments& arguments) {
  const fs::path& path = arguments.log.log;
  if (!arguments.reference.empty() || !arguments.region.empty() || !arguments.direction.empty())
    return Error{ErrorCode::bad_value, "a scene says itself how its maps are judged", "--reference, --doi, --region",
                 "leave them out, or change [scoring] of the scene"};
  Result<io::SceneFile> file = is_scene_file(path) ? io::read_scene_file(path)
                                                   : io::read_scene(*io::builtin_scene(path.string()), path.string());
  if (!file) return file.error();
  if (!file->scoring)
    return Error{ErrorCode::bad_value, "the scene does not say how its maps are judged", path.string(),
                 "give it a table [scoring] with a region"};
  return SweepSubject(StudyScene{std::move(file->scene), std::move(*file->scoring)});
}

Result<SceneScoring> scoring_of(const SubjectArguments& arguments) {
  const double inf = std::numeric_limits<double>::infinity();
  SceneScoring scoring;
  scoring.region = {{-inf, -inf}, {inf, inf}};
  if (!arguments.region.empty()) {
    scoring.region = {{arguments.region[0], arguments.region[1]}, {arguments.region[2], arguments.region[3]}};
    const auto& [low, high] = scoring.region;
    if (!is_finite(low) || !is_finite(high) || low.x >= high.x || low.y >= high.y)
      return Error{ErrorCode::bad_value, "the region is empty", "--region", "give X_MIN Y_MIN X_MAX Y_MAX in metres"};
  }
  if (arguments.direction.empty()) return scoring;
  const Result<Angle> axis = parse_direction(arguments.direction);
  if (!axis) return axis.error();
  scoring.axis = *axis;
  return scoring;
}

/// The description of the log's columns is that of the reference, too, where that is a log.
LogArguments reference_arguments(const SubjectArguments& arguments) {
  const fs::path reference = arguments.reference;
  const bool is_map = reference.extension() == ".yaml" || fs::exists(reference / "map.yaml");
  if (is_map || reference.extension() == ".csv")
    return {.log = reference, .description = {}, .odometry = {}, .robot = {}};
  LogArguments as_log = arguments.log;
  as_log.log = reference;
  return as_log;
}

Result<SweepSubject> load_judged_log(const SubjectArguments& arguments) {
  const fs::path& path = arguments.log.log;
  if (!fs::exists(path))
    return Error{ErrorCode::not_found, "there is no such scene or log", path.string(),
                 "give a scene.toml, the name of a scene, or a log"};
  if (arguments.reference.empty())
    return Error{ErrorCode::bad_value, "a log does not say where the walls are", "--reference",
                 "give the truth: --reference truth.csv, a map.yaml, or the log itself if it has a laser"};
  Result<SceneScoring> scoring = scoring_of(arguments);
  if (!scoring) return scoring.error();
  Result<Reference> reference = load_reference(reference_arguments(arguments));
  if (!reference) return reference.error();
  Result<Log> log = load_log(arguments.log);
  if (!log) return log.error();
  return SweepSubject(JudgedLog{std::move(*log), std::move(*reference), std::move(*scoring)});
}

}  // namespace

void declare_subject(CLI::App& app, SubjectArguments& arguments) {
  app.add_option("SCENE", arguments.log.log, "a scene.toml or the name of a scene; or a log, with --reference")
      ->required()
      ->type_name("PATH");
  app.add_option("--reference", arguments.reference,
                 "of a log: CSV of surfaces (polyline,x,y), a map.yaml, or a log with a laser")
      ->type_name("PATH");
  CLI::Option* region =
      app.add_option("--region", arguments.region, "of a log: judge this part, X_MIN Y_MIN X_MAX Y_MAX in metres");
  region->expected(4)->type_name("METRES");
  app.add_option("--doi", arguments.direction, "of a log: direction of interest for the correct detection ratio")
      ->needs(region)
      ->type_name("axis:DEG");
  declare_log_files(app, arguments.log);
}

bool names_scene(const SubjectArguments& arguments) {
  const fs::path& path = arguments.log.log;
  return is_scene_file(path) || (!fs::exists(path) && io::builtin_scene(path.string()).has_value());
}

Result<SweepSubject> load_subject(const SubjectArguments& arguments) {
  return names_scene(arguments) ? load_scene(arguments) : load_judged_log(arguments);
}

}  // namespace echoarc::cli
