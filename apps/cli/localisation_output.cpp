// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/localisation_output.hpp"

#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/table.hpp"
#include "cli/text_file.hpp"
#include "echoarc/io/run_report.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;
using studies::KnownStart;
using studies::LocalisationRun;

std::string_view start_name(KnownStart start) {
  if (start == KnownStart::nothing) return "global";
  return start == KnownStart::misled ? "kidnapped" : "tracking";
}

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::string cell(const std::optional<double>& value, double scale = 1.0, int digits = 3) {
  return value && std::isfinite(*value) ? fmt::format("{:.{}f}", *value * scale, digits) : "";
}

std::string shown(const std::optional<double>& value, double scale, int digits) {
  const std::string text = cell(value, scale, digits);
  return text.empty() ? "-" : text;
}

Json json_of(const LocalisationRun& run) {
  return {{"seed", run.seed},
          {"time_s", run.time_s},
          {"travelled_m", run.travelled_m},
          {"found_s", number(run.found_s)},
          {"found_m", number(run.found_m)},
          {"wrong_claims", run.wrong_claims},
          {"wrong_s", run.wrong_s},
          {"misled_s", run.misled_s},
          {"localised_share", run.localised_share},
          {"ambiguous_share", run.ambiguous_share},
          {"error_median_m", number(run.error_median_m)},
          {"error_p95_m", number(run.error_p95_m)},
          {"heading_p95_deg", number(run.heading_p95_deg)},
          {"any_error_p95_m", number(run.any_error_p95_m)},
          {"odometry_error_m", number(run.odometry_error_m)},
          {"last_word", run.last_word},
          {"step_p99_s", run.step_p99_s},
          {"step_max_s", run.step_max_s},
          {"cpu_s", run.cpu_s}};
}

std::string runs_csv(const std::vector<LocalisationRun>& runs) {
  std::string text =
      "seed,time_s,travelled_m,found_s,found_m,wrong_claims,wrong_s,misled_s,localised_share,ambiguous_share,"
      "error_median_m,error_p95_m,heading_p95_deg,any_error_p95_m,odometry_error_m,last_word,cpu_s,step_p99_s,"
      "step_max_s\n";
  for (const LocalisationRun& run : runs)
    text += fmt::format(
        "{},{:.2f},{:.3f},{},{},{},{:.2f},{:.2f},{:.4f},{:.4f},{},{},{},{},{},\"{}\",{:.3f},{:.6f},{:.6f}\n", run.seed,
        run.time_s, run.travelled_m, cell(run.found_s), cell(run.found_m), run.wrong_claims, run.wrong_s, run.misled_s,
        run.localised_share, run.ambiguous_share, cell(run.error_median_m), cell(run.error_p95_m),
        cell(run.heading_p95_deg), cell(run.any_error_p95_m), cell(run.odometry_error_m), run.last_word, run.cpu_s,
        run.step_p99_s, run.step_max_s);
  return text;
}

std::string believed_csv(const std::vector<LocalisationRun>& runs) {
  std::string text =
      "seed,time_s,state,believed_x_m,believed_y_m,believed_heading_deg,true_x_m,true_y_m,true_heading_deg\n";
  for (const LocalisationRun& run : runs)
    for (const studies::LocalisationSample& sample : run.samples) {
      const Pose2& believed = sample.T_map_believed;
      const Pose2& truth = sample.T_map_true;
      text += fmt::format("{},{:.2f},{},{:.3f},{:.3f},{:.2f},{:.3f},{:.3f},{:.2f}\n", run.seed, sample.time_s,
                          name(sample.state), believed.position.x, believed.position.y, believed.heading.deg(),
                          truth.position.x, truth.position.y, truth.heading.deg());
    }
  return text;
}

}  // namespace

std::string localisation_table(const LocalisationReport& report) {
  Table table({"seed", "time [s]", "way [m]", "found [s]", "wrong claims", "wrong [s]", "localised [%]",
               "ambiguous [%]", "error p95 [cm]", "heading p95 [deg]", "odometry off [cm]", "step p99 [ms]",
               "at the end"});
  table.words({12});
  for (const LocalisationRun& run : report.runs)
    table.add({std::to_string(run.seed), fmt::format("{:.0f}", run.time_s), fmt::format("{:.1f}", run.travelled_m),
               shown(run.found_s, 1.0, 1), std::to_string(run.wrong_claims), fmt::format("{:.1f}", run.wrong_s),
               fmt::format("{:.1f}", 100.0 * run.localised_share), fmt::format("{:.1f}", 100.0 * run.ambiguous_share),
               shown(run.error_p95_m, 100.0, 1), shown(run.heading_p95_deg, 1.0, 1),
               shown(run.odometry_error_m, 100.0, 0), fmt::format("{:.1f}", 1e3 * run.step_p99_s), run.last_word});
  return fmt::format("{}: {}\n{}", report.request->scene.name, start_name(report.request->start), table.text());
}

std::string localisation_json(const LocalisationReport& report) {
  Json runs = Json::array();
  for (const LocalisationRun& run : report.runs) runs.push_back(json_of(run));
  const Json json{{"written_by", "echoarc"},
                  {"version", ECHOARC_VERSION},
                  {"command", report.command},
                  {"scene", report.request->scene.name},
                  {"start", start_name(report.request->start)},
                  {"runs", std::move(runs)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> write_localisation(const std::filesystem::path& folder, const LocalisationReport& report) {
  if (Result<void> written = write_text(folder / "runs.csv", runs_csv(report.runs)); !written) return written;
  if (Result<void> written = write_text(folder / "believed.csv", believed_csv(report.runs)); !written) return written;
  return write_text(folder / io::run_report_name, localisation_json(report));
}

}  // namespace echoarc::cli
