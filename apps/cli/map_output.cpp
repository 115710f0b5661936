// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/map_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "echoarc/io/method_output.hpp"
#include "echoarc/io/positions_csv.hpp"

namespace echoarc::cli {
namespace {

constexpr std::string_view features_folder_name = "features";

std::vector<Vec2> positions_of(std::span<const Odometry> path) {
  std::vector<Vec2> positions;
  for (const Odometry& pose : path) positions.push_back(pose.T_world_robot.position);
  return positions;
}

std::size_t count_cells(const DenseGrid<CellState>& states, CellState wanted) {
  return static_cast<std::size_t>(std::ranges::count(states.values(), wanted));
}

struct MapContext {
  const MapRun& run;
  std::string log;  ///< its name, for titles
  std::vector<Vec2> path;
};

Result<io::MethodReport> write_map(const std::filesystem::path& folder, const AnyMethod& method,
                                   const MapContext& context) {
  const std::string name(method.name());
  const Result<MapExport> map = method.export_map();
  if (!map) {
    Error error = map.error();
    error.message = fmt::format("method {}: {}", name, error.message);
    return error;
  }
  const Result<std::vector<Feature>> features =
      context.run.features.write_lines(folder / features_folder_name, name, map->points, context.run.log.frame);
  if (!features) return features.error();
  const std::string title = fmt::format("{}: {}", context.log, find_method(name)->title);
  const Result<void> written =
      io::write_method_output(folder / name, *map, {.title = title, .path = context.path, .features = *features});
  if (!written) return written.error();
  return io::MethodReport{.name = name,
                          .options = method.options(),
                          .counters = method.counters(),
                          .tallies = method.tallies(),
                          .points = map->points.size(),
                          .cells_free = count_cells(map->states, CellState::free),
                          .cells_occupied = count_cells(map->states, CellState::occupied)};
}

}  // namespace

Result<std::vector<io::MethodReport>> write_maps(const std::filesystem::path& folder, MapRun& run) {
  if (const Result<void> written = io::write_path_csv(folder / io::path_csv_name, run.result.path); !written)
    return written.error();
  const auto written = run.features.write_arc_features(folder / features_folder_name, run.log.frame);
  if (!written) return written.error();
  const MapContext context{run, std::filesystem::path(run.log.source).filename().string(),
                           positions_of(run.result.path)};
  std::vector<io::MethodReport> reports;
  for (const AnyMethod& method : run.methods) {
    Result<io::MethodReport> report = write_map(folder, method, context);
    if (!report) return report.error();
    reports.push_back(std::move(*report));
  }
  return reports;
}

void count_pings(const SensingReport& sensing, io::RunReport& report) {
  report.pings = {{"offered", sensing.pings},
                  {"echo", sensing.echoes},
                  {"no_echo", sensing.no_echoes},
                  {"too_close", sensing.too_close}};
  for (const RejectionInfo& reason : rejections()) {
    report.rejected[std::string(reason.name)] = sensing.rejected_pings[reason.reason].count;
    report.rejected["odometry." + std::string(reason.name)] = sensing.rejected_odometry[reason.reason].count;
  }
}

}  // namespace echoarc::cli
